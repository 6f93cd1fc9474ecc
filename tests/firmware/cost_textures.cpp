// SPDX-License-Identifier: MIT
// What users draw with textures, and a large square that is seen at an angle: the sections of one program for
// each light, for scripts/firmware-costs. The product is a model that the emulator loads into memory;
// everything else has a texture of 128x128 texels with mip levels, that of the character mapped along the
// z-axis.
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/model/model_binary.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/textured/textured.hpp>

#include <tests/firmware/cost_figure.hpp>
#include <tests/firmware/cost_places.hpp>
#include <tests/firmware/cost_record.hpp>
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
[[gnu::section(".bss.frame")]] std::uint16_t texels[21845];  // of all levels
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
  for (std::int32_t i = 0; i < size.width * size.height; ++i)
    pixels += depths[i] != DepthBuffer::kFarthest ? 1 : 0;
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

bool measure_square(const char* name, std::int32_t depth, const Method::Lighting& lighting) {
  static CostPlace place;
  return make_square(depth, place) && measure(name, place.mesh, place.transform, lighting);
}

/// Draws the model that is loaded, with its texture, which `lighting` gets.
bool measure_model(Method::Lighting& lighting) {
  static scenes::StageSet stage;
  StoredModel stored;
  const ModelRecord& model = first_record();
  if (!ok(view_model_binary(binary_of(model), stored)) || stored.part_count() != 1) return false;
  const ModelPart part = stored.part(0);
  return part.mesh.vertex_count() <= points.size() && ok(view_texture(part.texture, lighting.texture)) &&
         set_model_stage(model, stage) && measure("product", part.mesh, stage.transform, lighting);
}

bool measure_place(const char* name, bool (*make)(CostPlace&), const Method::Lighting& lighting) {
  static CostPlace place;
  return make(place) && measure(name, place.mesh, place.transform, lighting);
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
  for (std::size_t i = 0; i < std::size(texels); ++i) texels[i] = static_cast<std::uint16_t>(i * 40503u >> 3);
  static scenes::StageSet figure_stage;
  MeshView figure;
  if (!ok(scenes::set_character_stage({kCostHeight, kCostWidth}, figure_stage)) ||
      !make_character_mesh(figure))
    return 1;
  static Method::Lighting lighting;
  if (!set_light<Method>(lighting)) return 2;
  if (!ok(Texture<DirectTexels<>>::make(texels, {7, 7, 8}, lighting.texture))) return 3;
  return measure_mapped("character", figure, figure_stage.transform, lighting) &&
                 measure_place("room", make_room, lighting) &&
                 measure_place("dashboard", make_dashboard, lighting) &&
                 measure_square("facing", 0, lighting) && measure_square("turned", 8000, lighting) &&
                 measure_model(lighting)
             ? 0
             : 4;
}
