// SPDX-License-Identifier: MIT
// A complete firmware with a display, for the LM3S6965 board: a mesh in flash rotates on the OLED. It is
// drawn in bands of 16 rows, so that neither the frame nor its depth has to fit in RAM. For another board or
// panel, change kWidth, kHeight, `Pages` and the first lines of main().
#include <arcspan/bare/console.hpp>
#include <arcspan/draw.hpp>
#include <arcspan/hal/panel/page_mode.hpp>
#include <arcspan/pixel/gray4.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <oled.hpp>
#include <tests/frames/integer_shapes.hpp>

using namespace arcspan;
using Light = Illumination<1, Highlight::kBlinn>;
using Pages = hal::PageMode<hal::Ssd0323>;

constexpr auto kTorus = scenes::make_torus<24, 12>();
constexpr std::int32_t kWidth = 128, kHeight = 64, kRows = 16;
std::uint8_t band_memory[Pages::Frame::words(kWidth, kRows)];
std::uint8_t wire_memory[hal::wire_bytes<hal::Ssd0323>(kWidth, kRows)];
std::uint16_t depth_memory[DepthBuffer::words(kWidth, kRows)];

Status draw(hal::Framebuffer<Gray4>& band, std::uint16_t turn) {
  MeshView mesh;
  Status status = kTorus.view(mesh);
  Placement placement{Rotation::about_x({4551}) * Rotation::about_y({turn}), {}};
  placement.translation[2] = ObjectLength::of(-4 * scenes::kRadius);
  ClipTransform transform;
  if (ok(status)) {
    status = ClipTransform::make(placement,
                                 {PixelLength::of(110), ObjectLength::of(32768), ObjectLength::of(98304)},
                                 {kWidth, kHeight}, transform);
  }
  constexpr Coefficient kHalf = Coefficient::of(0.5);
  const Material material{{kHalf, kHalf, kHalf}, {kHalf, kHalf, kHalf}, {kHalf, kHalf, kHalf}, 32};
  const DirectionalLight sun{placement.rotation.to_object(normalised(3, 4, 5))};
  static Light light;  // too large for the stack
  if (ok(status))
    status = Light::make(material, {sun}, placement.rotation.to_object(normalised(0, 0, 1)), light);
  if (!ok(status)) return status;

  DepthBuffer depth(depth_memory, kWidth, kRows);
  depth.move_to(band.bounds().top);
  depth.clear();
  band.clear({0, 0, 0});
  return draw_mesh<Arc<Light>>(mesh, transform, light, band, depth).status;
}

int main() {
  lm3s6965::start_clocks();
  lm3s6965::Oled oled;
  if (!ok(oled.start())) return 1;
  Pages pages(oled.panel(), band_memory, wire_memory, kRows);
  for (std::uint16_t frame = 0; frame < 8; ++frame) {
    const auto turn = static_cast<std::uint16_t>(frame * 512);
    const Status status = pages.show([turn](hal::Framebuffer<Gray4>& band) { return draw(band, turn); });
    bare::print_line("frame ", std::uint32_t{frame}, ok(status) ? ": shown" : to_string(status));
    if (!ok(status)) return 2;
  }
  return 0;
}
