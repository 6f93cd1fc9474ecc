// SPDX-License-Identifier: MIT
// A square of 200x200 pixels that faces the camera, with a texture of 128x128 opaque texels without light: a
// section for every operation, for scripts/firmware-costs.
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/fog.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/grey_gouraud.hpp>
#include <arcspan/shading/textured/textured.hpp>
#include <arcspan/shading/unlit.hpp>
#include <arcspan/shading/with_operation.hpp>

#include <tests/firmware/cost_places.hpp>
#include <tests/firmware/cost_stage.hpp>

#include <type_traits>

using namespace arcspan;

namespace {

[[gnu::section(".bss.frame")]] std::uint16_t colours[kCostWidth * kCostHeight];
[[gnu::section(".bss.frame")]] std::uint16_t depths[kCostWidth * kCostHeight];
[[gnu::section(".bss.frame")]] std::uint16_t texels[128 * 128];

std::uint32_t most_pixels = 0;  ///< that a section has drawn: those of the square

/// Draws the square in a section.
template <class Method>
[[gnu::noinline]] bool measure(const char* name, const typename Method::Lighting& lighting) {
  static CostPlace place;
  if (!make_square(0, place)) return false;
  hal::Framebuffer<Rgb565> frame(colours, kCostWidth, kCostHeight);
  DepthBuffer depth(depths, kCostWidth, kCostHeight);
  frame.clear({0, 0, 0});
  depth.clear();
  arcspan_mark();
  const DrawResult drawn = draw_mesh<Method>(place.mesh, place.transform, lighting, frame, depth);
  arcspan_mark();
  bare::print_line("section: ", name);
  bare::print_line("section: between");
  std::uint32_t pixels = 0;
  for (const std::uint16_t at : depths) pixels += at != DepthBuffer::kFarthest ? 1 : 0;
  if (pixels > most_pixels) most_pixels = pixels;
  return ok(drawn.status) && drawn.triangles == 2;
}

/// measure() of a method with a texture, made of the parts of its lighting.
template <class Method, class... Parts>
bool measure_with(const char* name, const Parts&... parts) {
  static typename Method::Lighting lighting;
  using Format = std::remove_cvref_t<decltype(lighting.texture)>;
  Format texture;
  if (!ok(Format::make(texels, {7, 7, 1}, texture))) return false;
  lighting.set(texture);
  (lighting.set(parts), ...);
  return measure<Method>(name, lighting);
}

template <TexelFormat Texels = DirectTexels<>, TextureFilter Filter = TextureFilter::kNearest>
using Picture = Textured<Unlit, Texels, TexelLight::kNone, Filter>;
using Bilinear = Picture<DirectTexels<>, TextureFilter::kBilinear>;

}  // namespace

int main() {
  for (std::size_t i = 0; i < 128 * 128; ++i)
    texels[i] = static_cast<std::uint16_t>((i * 40503u >> 3) | 0x20u);
  static Fog fog;
  if (!ok(Fog::make({1000, 60000, 1000, 60000}, {200, 200, 220}, fog))) return 1;
  const bool good =
      measure_with<Picture<>>("plain") && measure_with<Picture<DirectTexels<Alpha1Colour>>>("alpha-1") &&
      measure_with<WithOperation<Picture<>, ScreenDoor>>("screen-door", ScreenDoor{4}) &&
      measure_with<WithOperation<Picture<>, Opacity<>>>("opacity", Opacity<>{16}) &&
      measure_with<WithOperation<Picture<>, Opacity<Blend::kAdd>>>("add", Opacity<Blend::kAdd>{16}) &&
      measure_with<WithOperation<Picture<>, Opacity<Blend::kMultiply>>>("multiply",
                                                                        Opacity<Blend::kMultiply>{32}) &&
      measure_with<WithOperation<Picture<DirectTexels<Alpha4Colour>>, Opacity<>>>("alpha-4", Opacity<>{32}) &&
      measure_with<WithOperation<Picture<>, Fogged>>("fog", Fogged{&fog}) &&
      measure_with<Bilinear>("bilinear");
  bare::print_line("pixels: ", most_pixels);
  return good ? 0 : 2;
}
