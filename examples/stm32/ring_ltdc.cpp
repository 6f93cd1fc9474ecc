// SPDX-License-Identifier: MIT
// STM32 HAL: the ring on a panel of 480x272 pixels on the LTDC, with two frames in SDRAM that are exchanged
// between two pictures. In CubeMX: LTDC with one layer in RGB565 and its interrupt, SDRAM at 0xC0000000. Call
// ring_run() at the end of main() in main.c.
#include "main.h"
#include "ring.hpp"

#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>

using namespace ring;
using Frame = hal::Framebuffer<Rgb565>;

extern "C" LTDC_HandleTypeDef hltdc;

namespace {

constexpr std::int32_t kWidth = 480, kHeight = 272;
constexpr Camera kCamera = camera_of({kWidth, kHeight});

struct Sdram {
  std::uint16_t frames[2][kWidth * kHeight];
  std::uint16_t depths[kWidth * kHeight];
};
Sdram& sdram = *reinterpret_cast<Sdram*>(0xC0000000);

SceneMemory<MethodList<Method>, 1, kMesh.vertex_count()> scene_memory;
volatile bool is_shown = true;

// Shows the frame from the next picture on.
void show(std::uint16_t* pixels) {
#if defined(__DCACHE_PRESENT) && __DCACHE_PRESENT
  SCB_CleanDCache_by_Addr(reinterpret_cast<std::uint32_t*>(pixels), sizeof sdram.frames[0]);
#endif
  is_shown = false;
  HAL_LTDC_SetAddress_NoReload(&hltdc, static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(pixels)),
                               0);
  HAL_LTDC_Reload(&hltdc, LTDC_RELOAD_VERTICAL_BLANKING);
}

}  // namespace

extern "C" void HAL_LTDC_ReloadEventCallback(LTDC_HandleTypeDef*) { is_shown = true; }

extern "C" void ring_run(void) {
  Object object(kMesh, kCopper);
  Status status = Status::kOk;
  unsigned hidden = 0;  // the frame that is not shown
  for (std::uint16_t turn = 0; ok(status); turn += 400, hidden ^= 1) {
    std::uint16_t* const pixels = sdram.frames[hidden];
    Frame frame({pixels, kWidth * kHeight}, kWidth, kHeight);
    DepthBuffer depth(sdram.depths, kWidth, kHeight);
    object.rotation = rotation_of(EulerAngles{{turn}, {11000}, {}});
    status = prepare_scene({kCamera, {kSun}, {&object, 1}}, scene_memory);
    if (ok(status)) status = draw_prepared_scene(scene_memory, frame, depth, {0, 0, 40}).status;
    while (!is_shown) {  // the frame before this one; after that, nobody reads the other
    }
    show(pixels);
  }
  Error_Handler();
}
