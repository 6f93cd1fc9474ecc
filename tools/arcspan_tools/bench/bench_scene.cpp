// SPDX-License-Identifier: MIT
#include <arcspan_tools/bench/bench_scene.hpp>
#include <arcspan_tools/mesh/plain/generate.hpp>

#include <cmath>
#include <numbers>

namespace arcspan::tools {
namespace {

/// Of the silhouette in a picture of 320x240; leaves a margin of two rows.
constexpr std::int32_t kRadiusOfSmallest = 118;

Vec3 tilted(Vec3 v) {
  const auto turn = [](double& a, double& b, double angle) {
    const double c = std::cos(angle * kDegree);
    const double s = std::sin(angle * kDegree);
    const double turned = c * a - s * b;
    b = s * a + c * b;
    a = turned;
  };
  turn(v.y, v.z, 25);
  turn(v.x, v.y, 15);
  return v;
}

std::optional<std::int64_t> number_between(const std::string& text, std::int64_t low, std::int64_t high) {
  const std::optional<std::int64_t> value = parse_integer(text);
  return value && *value >= low && *value <= high ? value : std::nullopt;
}

}  // namespace

std::optional<BenchSphere> parse_bench_sphere(const std::string& text) {
  const std::size_t cross = text.find('x');
  const std::size_t colon = text.find(':');
  if (cross == std::string::npos || colon == std::string::npos || colon < cross) return std::nullopt;
  const auto around = number_between(text.substr(0, cross), 3, 256);
  const auto along = number_between(text.substr(cross + 1, colon - cross - 1), 2, 128);
  const auto radius = number_between(text.substr(colon + 1), 1, kLargestBenchRadius);
  if (!around || !along || !radius) return std::nullopt;
  return BenchSphere{static_cast<std::int32_t>(*around), static_cast<std::int32_t>(*along),
                     static_cast<std::int32_t>(*radius)};
}

std::string to_string(const BenchSphere& sphere) {
  return std::to_string(sphere.around) + "x" + std::to_string(sphere.along) + ":" +
         std::to_string(sphere.radius);
}

std::vector<BenchSphere> default_bench_spheres() {
  return {{64, 32, 36},  {32, 16, 36}, {64, 32, 108}, {32, 16, 72},
          {32, 16, 108}, {16, 8, 72},  {32, 16, 236}, {16, 8, 236}};
}

BenchScene make_bench_scene(const BenchSphere& sphere) {
  BenchScene made;
  made.mesh = generate({GeneratedMesh::Kind::kSphere, sphere.around, sphere.along});
  for (Vec3& p : made.mesh.positions) p = tilted(p);
  for (Vec3& n : made.mesh.normals) n = tilted(n);
  made.eye = 4;
  // The tangent cone of a sphere four radii away has the tangent 1 / sqrt(15).
  made.focal = std::sqrt(15.0) * sphere.radius;
  const std::int32_t scale = (sphere.radius + kRadiusOfSmallest - 1) / kRadiusOfSmallest;
  Scene& scene = made.scene;
  scene.size = {320 * scale, 240 * scale};
  scene.camera.eye = Vec3{0, 0, made.eye};
  scene.camera.target = Vec3{0, 0, 0};
  scene.camera.fov_degrees = 360 / std::numbers::pi * std::atan(scene.size.height / (2 * made.focal));
  scene.lights = {SceneLight{0.5, 0.6, 0.6245}};
  scene.surface = {{220.0 / 255, 140.0 / 255, 70.0 / 255}, 0.2, 0.8, 0.5, 16};
  scene.highlight = Highlight::kPhong;
  scene.background = {0, 0, 0};
  return made;
}

}  // namespace arcspan::tools
