// SPDX-License-Identifier: MIT
// The benchmark frame and a figure of small triangles with a texture of 128x128 texels, mapped along the
// z-axis, and a large square that is seen at an angle: the sections of one program for each light, for
// scripts/firmware-costs.
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/textured/textured.hpp>

#include <tests/firmware/cost_figure.hpp>
#include <tests/firmware/cost_stage.hpp>

#include <array>
#include <new>

// The light of the texture, which CMakeLists.txt defines.
#include ARCSPAN_LIGHT_HEADER

using namespace arcspan;

namespace {

using Method = Textured<ARCSPAN_LIGHT, DirectTexels<>>;

[[gnu::section(".bss.frame")]] std::uint16_t colours[kCostWidth * kCostHeight];
[[gnu::section(".bss.frame")]] std::uint16_t depths[kCostWidth * kCostHeight];
[[gnu::section(".bss.frame")]] std::uint16_t texels[128 * 128];
[[gnu::section(".bss.frame")]] std::array<TexturePoint, 4096> points;
[[gnu::section(".bss.frame")]] CachedVertex<Method> cache[4096];

bool measure(const char* name, const MeshView& mesh, const ClipTransform& transform,
             const Method::Lighting& lighting) {
  const Viewport& size = transform.viewport();  // of as many pixels as the benchmark frame has
  hal::Framebuffer<Rgb565> frame(colours, size.width, size.height);
  DepthBuffer depth(depths, size.width, size.height);
  frame.clear({0, 0, 0});
  depth.clear();
  arcspan_mark();
  const DrawResult drawn = draw_mesh<Method>(mesh, transform, lighting, frame, depth, cache);
  arcspan_mark();
  std::uint32_t pixels = 0;
  for (const std::uint16_t at : depths) pixels += at != DepthBuffer::kFarthest ? 1 : 0;
  bare::print_line("section: ", name);
  bare::print_line("section: between");
  bare::print_line("drawn: ", name, " triangles ", drawn.triangles, " pixels ", pixels);
  return ok(drawn.status);
}

/// Draws a mesh whose texture points are made from its positions.
bool measure_mapped(const char* name, MeshView mesh, const ClipTransform& transform,
                    const Method::Lighting& lighting) {
  if (mesh.vertex_count() > points.size()) return false;
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    points[i] = {static_cast<std::int16_t>((mesh.position(i).x >> 3) + 2048),
                 static_cast<std::int16_t>(2048 - (mesh.position(i).y >> 3))};
  }
  return ok(mesh.attach({points.data(), mesh.vertex_count()}, TextureScale{12})) &&
         measure(name, mesh, transform, lighting);
}

/// Draws a square of 200x200 pixels that is turned about the vertical axis: its left and right side are
/// nearer and farther by `depth`, the distance of its middle being 24000.
bool measure_square(const char* name, std::int32_t depth, const Method::Lighting& lighting) {
  const auto z = static_cast<std::int16_t>(depth);
  const auto minus = static_cast<std::int16_t>(-depth);
  static std::array<ObjectPosition, 4> corners;
  corners = {{{-8000, -8000, minus}, {8000, -8000, z}, {8000, 8000, z}, {-8000, 8000, minus}}};
  static constexpr std::array<PackedNormal, 4> kNormals{};
  static constexpr std::array<std::uint16_t, 6> kIndices{0, 1, 2, 0, 2, 3};
  static constexpr std::array<TexturePoint, 4> kCorners{{{0, 4096}, {4096, 4096}, {4096, 0}, {0, 0}}};
  MeshView mesh;
  if (!ok(MeshView::make(corners, kNormals, kIndices, mesh)) || !ok(mesh.attach(kCorners, TextureScale{12})))
    return false;
  Placement placement{Rotation::identity(), {}};
  placement.translation[2] = ObjectLength::of(-24000);
  ClipTransform transform;
  return ok(ClipTransform::make(placement,
                                {PixelLength::of(300), ObjectLength::of(1000), ObjectLength::of(60000)},
                                {kCostWidth, kCostHeight}, transform)) &&
         measure(name, mesh, transform, lighting);
}

/// Sets a white material under the light of the benchmark frame, if the method takes light.
template <class M>
bool set_light(typename M::Lighting& lighting) {
  if constexpr (requires { M::Lighting::kLights; }) {
    constexpr Coefficient kFifth = Coefficient::of(0.2);
    constexpr Coefficient kRest = Coefficient::of(0.8);
    constexpr Coefficient kHalf = Coefficient::of(0.5);
    const Material white{{kFifth, kFifth, kFifth}, {kRest, kRest, kRest}, {kHalf, kHalf, kHalf}, 16};
    const Rotation pose = Rotation::about_z({2731}) * Rotation::about_x({4551});
    static scenes::Light light;
    const Status made =
        scenes::Light::make(white, {DirectionalLight{pose.to_object(normalised(5000, 6000, 6245))}},
                            pose.to_object(normalised(0, 0, 1)), light);
    ::new (&lighting) typename M::Lighting(light);
    return ok(made);
  } else {
    return true;
  }
}

}  // namespace

int main() {
  for (std::size_t i = 0; i < 128 * 128; ++i) texels[i] = static_cast<std::uint16_t>(i * 40503u >> 3);
  static SphereMemory memory;
  SphereMeshes sphere;
  static scenes::StageSet stage;
  if (!make_sphere_meshes(32, 16, memory, sphere) ||
      !ok(scenes::set_stage({kCostWidth, kCostHeight}, 72, {}, stage))) {
    return 1;
  }
  static scenes::StageSet figure_stage;
  MeshView figure;
  if (!ok(scenes::set_character_stage({kCostHeight, kCostWidth}, figure_stage)) ||
      !make_character_mesh(figure))
    return 2;
  static Method::Lighting lighting;
  if (!set_light<Method>(lighting)) return 3;
  if (!ok(Texture<DirectTexels<>>::make(texels, {7, 7, 1}, lighting.texture))) return 4;
  return measure_mapped("sphere", sphere.planed, stage.transform, lighting) &&
                 measure_mapped("figure", figure, figure_stage.transform, lighting) &&
                 measure_square("facing", 0, lighting) && measure_square("turned", 8000, lighting)
             ? 0
             : 5;
}
