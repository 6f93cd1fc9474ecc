// SPDX-License-Identifier: MIT
// The cost of a scene of 20 spheres with 20 materials, and of the benchmark frame drawn as a scene of one
// object, at once and in bands, and by draw_mesh(): sections for scene_cost_test.py.
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/scene.hpp>

#include <tests/firmware/cost_stage.hpp>

#include <array>
#include <utility>

// The shading method, which CMakeLists.txt defines.
#include ARCSPAN_METHOD_HEADER

using namespace arcspan;

namespace {

using Method = ARCSPAN_METHOD<scenes::Light>;

[[gnu::section(".bss.frame")]] std::uint16_t colours[kCostWidth * kCostHeight];
[[gnu::section(".bss.frame")]] std::uint16_t depths[kCostWidth * kCostHeight];
[[gnu::section(".bss.frame")]] SceneMemory<MethodList<Method>, 20, 2048> memory_of_scene;
[[gnu::section(".bss.frame")]] SceneMemory<MethodList<Method>, 1, 512, 1024> memory_with_rows;
[[gnu::section(".bss.frame")]] SceneMemory<MethodList<Method>, 1, 0, 1024> memory_of_rows;
[[gnu::section(".bss.frame")]] CachedVertex<Method> cache[512];

// Camera, light and material of set_stage(), of which this is the frame "32x16 72".
constexpr SceneLight kSun[] = {SceneLight::directional(normalised(5000, 6000, 6245))};
constexpr LightList kLights{kSun};
constexpr std::size_t kSpheres = 20;

constexpr Material material(std::size_t i) {
  constexpr auto share = [](std::size_t amount) {
    return Coefficient::from_raw(static_cast<std::int32_t>(amount));
  };
  constexpr Coefficient kHalf = Coefficient::of(0.5);
  if (i == 0) {
    return {
        {Coefficient::of(0.2 * 220 / 255), Coefficient::of(0.2 * 140 / 255), Coefficient::of(0.2 * 70 / 255)},
        {Coefficient::of(0.8 * 220 / 255), Coefficient::of(0.8 * 140 / 255), Coefficient::of(0.8 * 70 / 255)},
        {kHalf, kHalf, kHalf},
        16};
  }
  return {{share(1000 + 200 * i), share(4000), share(5000 - 200 * i)},
          {share(8000 + 900 * i), share(26000 - 900 * i), share(12000)},
          {kHalf, kHalf, kHalf},
          16};
}

template <std::size_t... I>
consteval std::array<PreparedMaterial<Method>, kSpheres> prepared(std::index_sequence<I...>) {
  return {PreparedMaterial<Method>::of(material(I), kLights)...};
}
constexpr auto kMaterials = prepared(std::make_index_sequence<kSpheres>());

// The scale makes a world unit one radius of the sphere.
constexpr Camera kCamera =
    Camera::of({WorldPoint::of(0, 0, 4), {}},
               Lens::focal_length(PixelLength::from_raw(7932 * 72), WorldLength::of(2), WorldLength::of(6)),
               {kCostWidth, kCostHeight});
constexpr Rotation kPose = Rotation::about_z({2731}) * Rotation::about_x({4551});

bool measure(const char* name, const Camera& camera, std::span<const Object> objects) {
  hal::Framebuffer<Rgb565> frame(colours, kCostWidth, kCostHeight);
  DepthBuffer depth(depths, kCostWidth, kCostHeight);
  frame.clear({0, 0, 0});
  depth.clear();
  arcspan_mark();
  const Status prepared = prepare_scene({camera, kLights, objects}, memory_of_scene);
  arcspan_mark();
  const SceneResult drawn = draw_prepared_scene(memory_of_scene, frame, depth);
  arcspan_mark();
  bare::print_line("section: prepare ", name);
  bare::print_line("section: draw ", name);
  bare::print_line("section: between");
  bare::print_line("drawn: ", name, " ", drawn.objects, " ", drawn.triangles);
  return ok(prepared) && ok(drawn.status);
}

/// Prepares, clears and draws the picture in bands of 24 rows.
template <class Memory>
bool measure_bands(const char* name, std::span<const Object> objects, Memory& memory) {
  constexpr std::int32_t kRows = 24;
  hal::Framebuffer<Rgb565> band(colours, kCostWidth, kRows);
  DepthBuffer depth(depths, kCostWidth, kRows);
  arcspan_mark();
  Status status = prepare_scene({kCamera, kLights, objects}, memory);
  for (std::int32_t top = 0; ok(status) && top < kCostHeight; top += kRows) {
    band.move_to(top);
    depth.move_to(top);
    status = draw_prepared_scene(memory, band, depth, Rgb8{}).status;
  }
  arcspan_mark();
  bare::print_line("section: ", name);
  bare::print_line("section: between");
  return ok(status);
}

/// The benchmark frame by draw_mesh(), with the transform and the illumination of the scene's object.
bool measure_mesh(const Object& object) {
  hal::Framebuffer<Rgb565> frame(colours, kCostWidth, kCostHeight);
  DepthBuffer depth(depths, kCostWidth, kCostHeight);
  frame.clear({0, 0, 0});
  depth.clear();
  const detail::SceneFrame prepared = memory_of_scene.frame();
  const ClipTransform& transform = prepared.entries[0].transform;
  const auto& lighting = *static_cast<const Method::Lighting*>(memory_of_scene.lighting());
  arcspan_mark();
  const DrawResult drawn = draw_mesh<Method>(object.mesh(), transform, lighting, frame, depth, cache);
  arcspan_mark();
  bare::print_line("section: draw mesh");
  bare::print_line("section: between");
  return ok(drawn.status);
}

}  // namespace

int main() {
  static SphereMemory memory[2];
  SphereMeshes fine;
  SphereMeshes coarse;
  if (!make_sphere_meshes(32, 16, memory[0], fine) || !make_sphere_meshes(16, 8, memory[1], coarse)) return 1;
  Object one(fine.planed, kMaterials[0]);
  one.scale = WorldLength::of(2);
  one.rotation = kPose;
  if (!measure("one", kCamera, {&one, 1}) || !measure_mesh(one)) return 2;
  if (!measure_bands("bands", {&one, 1}, memory_of_scene) ||
      !measure_bands("bands, rows", {&one, 1}, memory_with_rows) ||
      !measure_bands("bands, rows only", {&one, 1}, memory_of_rows))
    return 4;

  static std::array<Object, kSpheres> objects = [&]<std::size_t... I>(std::index_sequence<I...>) {
    return std::array<Object, kSpheres>{Object(coarse.planed, kMaterials[I])...};
  }
  (std::make_index_sequence<kSpheres>());
  for (std::size_t i = 0; i < kSpheres; ++i) {
    const auto column = static_cast<std::int32_t>(i % 5);
    const auto row = static_cast<std::int32_t>(i / 5);
    objects[i].scale = WorldLength::of(0.75);
    objects[i].rotation = kPose;
    objects[i].position = {WorldLength::from_raw((column - 2) * 55000),
                           WorldLength::from_raw((2 * row - 3) * 27000),
                           WorldLength::from_raw(static_cast<std::int32_t>(i) * 2000)};
  }
  return measure("twenty", kCamera, objects) ? 0 : 3;
}
