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

#include <tests/firmware/cost_stage.hpp>

#include <array>
#include <type_traits>

using namespace arcspan;

namespace {

[[gnu::section(".bss.frame")]] std::uint16_t colours[kCostWidth * kCostHeight];
[[gnu::section(".bss.frame")]] std::uint16_t depths[kCostWidth * kCostHeight];
[[gnu::section(".bss.frame")]] std::uint16_t texels[128 * 128];

std::uint32_t most_pixels = 0;  ///< that a section has drawn: those of the square

/// Places the square in front of the camera.
bool set_stage(MeshView& mesh, ClipTransform& transform) {
  static constexpr std::array<ObjectPosition, 4> kSquare{
      {{-8000, -8000, 0}, {8000, -8000, 0}, {8000, 8000, 0}, {-8000, 8000, 0}}};
  static constexpr std::array<PackedNormal, 4> kNormals{};
  static constexpr std::array<std::uint16_t, 6> kIndices{0, 1, 2, 0, 2, 3};
  static constexpr std::array<TexturePoint, 4> kCorners{{{0, 4096}, {4096, 4096}, {4096, 0}, {0, 0}}};
  Placement placement{Rotation::identity(), {}};
  placement.translation[2] = ObjectLength::of(-24000);
  return ok(MeshView::make(kSquare, kNormals, kIndices, mesh)) &&
         ok(mesh.attach(kCorners, TextureScale{12})) &&
         ok(ClipTransform::make(placement,
                                {PixelLength::of(300), ObjectLength::of(1000), ObjectLength::of(60000)},
                                {kCostWidth, kCostHeight}, transform));
}

/// Draws the square in a section.
template <class Method>
[[gnu::noinline]] bool measure(const char* name, const typename Method::Lighting& lighting) {
  static MeshView mesh;
  static ClipTransform transform;
  if (!set_stage(mesh, transform)) return false;
  hal::Framebuffer<Rgb565> frame(colours, kCostWidth, kCostHeight);
  DepthBuffer depth(depths, kCostWidth, kCostHeight);
  frame.clear({0, 0, 0});
  depth.clear();
  arcspan_mark();
  const DrawResult drawn = draw_mesh<Method>(mesh, transform, lighting, frame, depth);
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
