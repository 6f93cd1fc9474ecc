// SPDX-License-Identifier: MIT
// The cost of the rectangle of a fine sphere, of the frame after it, and of picking a pixel of it: sections
// for interaction_cost_test.py. The sphere has a few more vertices and triangles than the bunny of 3,674
// triangles.
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>
#include <arcspan/drawn_rect.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/lighting/colour_coefficients.hpp>
#include <arcspan/pick.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <tests/firmware/cost_stage.hpp>

using namespace arcspan;

namespace {

using Method = Arc<scenes::Light>;

[[gnu::section(".bss.frame")]] std::uint16_t colours[kCostWidth * kCostHeight];
[[gnu::section(".bss.frame")]] std::uint16_t depths[kCostWidth * kCostHeight];
[[gnu::section(".bss.frame")]] SceneMemory<MethodList<Method>, 1, 2048> memory_of_scene;

constexpr SceneLight kSun[] = {SceneLight::directional(normalised(5000, 6000, 6245))};
constexpr LightList kLights{kSun};
constexpr auto kCopper = PreparedMaterial<Method>::of(plastic({220, 140, 70}), kLights);
// The scale makes a world unit one radius of the sphere.
constexpr Camera kCamera =
    Camera::of({WorldPoint::of(0, 0, 4), {}},
               Lens::focal_length(PixelLength::from_raw(7932 * 72), WorldLength::of(2), WorldLength::of(6)),
               {kCostWidth, kCostHeight});

/// The rectangle of an object, its frame after that, and a pixel of it that is picked.
bool measure_interaction(const Object& object) {
  hal::Framebuffer<Rgb565> frame(colours, kCostWidth, kCostHeight);
  DepthBuffer depth(depths, kCostWidth, kCostHeight);
  const Scene scene{kCamera, kLights, {&object, 1}};
  frame.clear({0, 0, 0});
  depth.clear();
  Status status = prepare_scene(scene, memory_of_scene);
  arcspan_mark();
  const SceneResult drawn = draw_prepared_scene(memory_of_scene, frame, depth);
  arcspan_mark();
  bare::print_line("section: draw fine");
  bare::print_line("section: between");
  frame.clear({0, 0, 0});
  depth.clear();
  if (ok(status)) status = prepare_scene(scene, memory_of_scene);
  arcspan_mark();
  const Rect rect = drawn_rect(memory_of_scene);
  arcspan_mark();
  const SceneResult again = draw_prepared_scene(memory_of_scene, frame, depth);
  arcspan_mark();
  const Picked picked = pick(memory_of_scene, kCostWidth / 2 + 9, kCostHeight / 2 + 5);
  arcspan_mark();
  bare::print_line("section: rectangle");
  bare::print_line("section: draw in rectangle");
  bare::print_line("section: pick");
  bare::print_line("section: between");
  bare::print_line("picked: ", picked.triangle, " of ", object.mesh().triangle_count());
  return ok(status) && ok(drawn.status) && ok(again.status) && again.triangles == drawn.triangles &&
         !rect.empty() && picked.object == &object;
}

}  // namespace

int main() {
  static SphereMemory memory;
  SphereMeshes sphere;
  if (!make_sphere_meshes(64, 30, memory, sphere)) return 1;
  Object object(sphere.planed, kCopper);
  object.scale = WorldLength::of(2);
  object.rotation = Rotation::about_z({2731}) * Rotation::about_x({4551});
  return measure_interaction(object) ? 0 : 2;
}
