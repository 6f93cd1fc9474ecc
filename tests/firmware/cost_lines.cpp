// SPDX-License-Identifier: MIT
// A hundred lines, points and billboards of two sizes each, from which scripts/firmware-costs computes what
// one and its pixels take, and the benchmark frame as a wireframe.
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>
#include <arcspan/draw.hpp>
#include <arcspan/draw/wireframe.hpp>
#include <arcspan/draw_billboards.hpp>
#include <arcspan/draw_lines.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>

#include <tests/firmware/cost_stage.hpp>

#include <array>

using namespace arcspan;

namespace {

using Sprite = Textured<Unlit, DirectTexels<>>;
constexpr std::int16_t kPixel = 80;  // object units
constexpr std::size_t kCount = 100;

[[gnu::section(".bss.frame")]] std::uint16_t colours[kCostWidth * kCostHeight];
[[gnu::section(".bss.frame")]] std::uint16_t depths[kCostWidth * kCostHeight];
[[gnu::section(".bss.frame")]] std::uint16_t texels[32 * 32];
[[gnu::section(".bss.frame")]] std::array<ObjectLine, kCount> lines;
[[gnu::section(".bss.frame")]] std::array<ObjectPosition, kCount> places;
[[gnu::section(".bss.frame")]] CachedVertex<Wireframe<>> cache[2048];

/// Draws by draw(frame, depth) and tells the pixels that this covers. `name` has no spaces.
template <class Draw>
bool measure(const char* name, const Draw& draw) {
  hal::Framebuffer<Rgb565> frame(colours, kCostWidth, kCostHeight);
  DepthBuffer depth(depths, kCostWidth, kCostHeight);
  frame.clear({0, 0, 0});
  depth.clear();
  arcspan_mark();
  const Status status = draw(frame, depth);
  arcspan_mark();
  std::uint32_t pixels = 0;
  for (const std::uint16_t at : depths) pixels += at != DepthBuffer::kFarthest ? 1 : 0;
  bare::print_line("section: ", name);
  bare::print_line("section: between");
  bare::print_line("drawn: ", name, " pixels ", pixels);
  return ok(status);
}

/// Makes lines that lead `across` and `down` pixels, a pixel below each other or, if they are tall, two
/// pixels beside each other.
void make_lines(std::int32_t across, std::int32_t down) {
  const auto narrow = [](std::int32_t v) { return static_cast<std::int16_t>(v); };
  for (std::size_t i = 0; i < kCount; ++i) {
    const auto at = static_cast<std::int32_t>(i);
    const std::int32_t x = down > across ? -8100 + 2 * kPixel * at : -6400 + at;
    const std::int32_t y = down > across ? 7000 : 7900 - kPixel * at;
    lines[i] = {{narrow(x), narrow(y), 0}, {narrow(x + kPixel * across), narrow(y - kPixel * down), 400}};
  }
}

bool measure_lines(const char* name, std::int32_t across, std::int32_t down, const ClipTransform& transform) {
  make_lines(across, down);
  return measure(name, [&](auto& frame, const auto& depth) {
    return draw_lines(lines, transform, Unlit::lighting({255, 255, 255}), frame, depth);
  });
}

bool measure_squares(const char* points, const char* sprites, std::uint8_t size,
                     const ClipTransform& transform) {
  for (std::size_t i = 0; i < kCount; ++i) {
    const auto column = static_cast<std::int32_t>(i % 10);
    const auto row = static_cast<std::int32_t>(i / 10);
    places[i] = {static_cast<std::int16_t>((column - 5) * 24 * kPixel),
                 static_cast<std::int16_t>((row - 5) * 20 * kPixel), 0};
  }
  Sprite::Lighting lighting;
  return measure(
             points,
             [&](auto& frame, const auto& depth) {
               return draw_points(places, size, transform, Unlit::lighting({255, 255, 255}), frame, depth);
             }) &&
         ok(Texture<DirectTexels<>>::make(texels, {5, 5, 1}, lighting.texture)) &&
         measure(sprites, [&](auto& frame, const auto& depth) {
           const BillboardSize side{size, size, BillboardSize::Unit::kPixel};
           return draw_billboards<Sprite>(places, side, transform, lighting, frame, depth);
         });
}

bool measure_wireframe() {
  static SphereMemory memory;
  SphereMeshes sphere;
  static scenes::StageSet stage;
  return make_sphere_meshes(32, 16, memory, sphere) &&
         ok(scenes::set_stage({kCostWidth, kCostHeight}, 72, {}, stage)) &&
         measure("wireframe", [&](auto& frame, const auto& depth) {
           return draw_mesh<Wireframe<>>(sphere.planed, stage.transform,
                                         Wireframe<>::Lighting(Unlit::lighting({255, 255, 255})), frame,
                                         depth, cache)
               .status;
         });
}

}  // namespace

int main() {
  Placement placement{Rotation::identity(), {}};
  placement.translation[2] = ObjectLength::of(-24000);
  ClipTransform transform;
  if (!ok(ClipTransform::make(placement,
                              {PixelLength::of(300), ObjectLength::of(1000), ObjectLength::of(60000)},
                              {kCostWidth, kCostHeight}, transform))) {
    return 1;
  }
  const bool done =
      measure_lines("level-short", 16, 0, transform) && measure_lines("level-long", 150, 0, transform) &&
      measure_lines("flat-short", 16, 4, transform) && measure_lines("flat-long", 150, 37, transform) &&
      measure_lines("tall-short", 1, 16, transform) && measure_lines("tall-long", 9, 150, transform) &&
      measure_squares("points-small", "sprites-small", 4, transform) &&
      measure_squares("points-large", "sprites-large", 16, transform) && measure_wireframe();
  return done ? 0 : 2;
}
