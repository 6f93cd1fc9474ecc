// SPDX-License-Identifier: MIT
// STM32 HAL: the ring on an ST7789 of 240x240 pixels, in bands of 24 rows; DMA sends one while the next is
// drawn. In CubeMX: SPI1 as transmit-only master with a DMA channel for TX and its interrupt, and outputs
// named LCD_DC, LCD_RESET, LCD_CS. Call ring_run() at the end of main() in main.c.
#include "main.h"
#include "ring.hpp"

#include <arcspan/hal/panel/page_mode.hpp>
#include <arcspan/hal/panel/st7789.hpp>

using namespace ring;
using Pages = hal::PageMode<hal::St7789>;

extern "C" SPI_HandleTypeDef hspi1;

namespace {

constexpr hal::Glass kGlass{240, 240, 0, 0, false, false, false, true};
constexpr std::int32_t kSide = 240, kRows = 24;
constexpr Camera kCamera = camera_of({kSide, kSide});

class Spi final : public hal::SpiBus {
  static constexpr std::size_t kMost = 65535;  // bytes of a transfer of the HAL

  static std::uint8_t* data_of(std::span<const std::uint8_t> bytes) {
    return const_cast<std::uint8_t*>(bytes.data());  // older versions of the HAL take no const; none writes
  }
  Status do_write(std::span<const std::uint8_t> bytes) override {
    if (bytes.size() > kMost) return Status::kInvalidArgument;
    const auto size = static_cast<std::uint16_t>(bytes.size());
    return HAL_SPI_Transmit(&hspi1, data_of(bytes), size, HAL_MAX_DELAY) == HAL_OK ? Status::kOk
                                                                                   : Status::kTransferFailed;
  }
  // On a core with a data cache the band must be in memory that is not cached, or cleaned here.
  Status do_start(std::span<const std::uint8_t> bytes) override {
    if (bytes.size() > kMost) return Status::kInvalidArgument;
    const auto size = static_cast<std::uint16_t>(bytes.size());
    return HAL_SPI_Transmit_DMA(&hspi1, data_of(bytes), size) == HAL_OK ? Status::kOk
                                                                        : Status::kTransferFailed;
  }
  // The HAL sets the state in its interrupt, after the last bit.
  Status do_poll() override {
    if (HAL_SPI_GetState(&hspi1) != HAL_SPI_STATE_READY) return Status::kBusy;
    return HAL_SPI_GetError(&hspi1) == HAL_SPI_ERROR_NONE ? Status::kOk : Status::kTransferFailed;
  }
  void do_abort() override { HAL_SPI_Abort(&hspi1); }
};

class Pin final : public hal::OutputPin {
 public:
  Pin(GPIO_TypeDef* port, std::uint16_t pin) : port_(port), pin_(pin) {}

 private:
  Status do_set(hal::Level level) override {
    HAL_GPIO_WritePin(port_, pin_, level == hal::Level::kHigh ? GPIO_PIN_SET : GPIO_PIN_RESET);
    return Status::kOk;
  }
  GPIO_TypeDef* port_;
  std::uint16_t pin_;
};

// SysTick counts down through each millisecond of HAL_GetTick(). HAL_Delay() waits up to two milliseconds,
// which is too long between two looks at the DMA.
class HalClock final : public hal::Clock {
  std::uint32_t do_now_us() override {
    std::uint32_t milliseconds, left;
    do {
      milliseconds = HAL_GetTick();
      left = SysTick->VAL;
    } while (milliseconds != HAL_GetTick());  // repeat if the next one began between the two
    const std::uint32_t cycles = SysTick->LOAD + 1;
    return milliseconds * 1000 + (cycles - 1 - left) * 1000 / cycles;
  }
  void do_delay_us(std::uint32_t us) override {
    const std::uint32_t begin = do_now_us();
    while (do_now_us() - begin <= us) {  // a microsecond more, because the first one had begun
    }
  }
};

Pages::Frame::Word band_memory[Pages::Frame::words(kSide, kRows)];
std::uint8_t wire_memory[hal::wire_bytes<hal::St7789>(kSide, kRows)];
std::uint16_t depths[DepthBuffer::words(kSide, kRows)];
SceneMemory<MethodList<Method>, 1, kMesh.vertex_count(), kMesh.triangle_count()> scene_memory;

}  // namespace

extern "C" void ring_run(void) {
  Spi bus;
  Pin data_or_command(LCD_DC_GPIO_Port, LCD_DC_Pin), reset(LCD_RESET_GPIO_Port, LCD_RESET_Pin);
  HalClock clock;
  HAL_GPIO_WritePin(LCD_CS_GPIO_Port, LCD_CS_Pin, GPIO_PIN_RESET);  // the panel is the only device
  hal::St7789 panel(bus, data_or_command, &reset, clock, kGlass);
  Pages pages(panel, band_memory, wire_memory, kRows);
  Object object(kMesh, kCopper);
  Status status = panel.start();
  for (std::uint16_t turn = 0; ok(status); turn += 400) {
    object.rotation = rotation_of(EulerAngles{{turn}, {11000}, {}});
    status = prepare_scene({kCamera, {kSun}, {&object, 1}}, scene_memory);
    if (!ok(status)) break;
    status = pages.show([](Pages::Frame& band) {
      DepthBuffer depth(depths, kSide, kRows, band.bounds().top);
      return draw_prepared_scene(scene_memory, band, depth, {0, 0, 40}).status;
    });
  }
  Error_Handler();
}
