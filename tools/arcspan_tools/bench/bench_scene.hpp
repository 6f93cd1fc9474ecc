// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/mesh_data.hpp>
#include <arcspan_tools/render/scene.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace arcspan::tools {

/// The project's measured scene with a sphere of `around` x `along` segments, whose silhouette has a radius
/// of `radius` pixels.
struct BenchSphere {
  std::int32_t around = 32;
  std::int32_t along = 16;
  std::int32_t radius = 72;
  friend bool operator==(const BenchSphere&, const BenchSphere&) = default;
};

/// The largest radius that a picture of the largest size holds.
inline constexpr std::int32_t kLargestBenchRadius = 708;

/// `32x16:72`: 3 to 256 segments around, 2 to 128 along, radius 1 to kLargestBenchRadius; else nothing.
[[nodiscard]] std::optional<BenchSphere> parse_bench_sphere(const std::string& text);
[[nodiscard]] std::string to_string(const BenchSphere& sphere);

/// Spheres from 4 to 1000 pixels a triangle, the headline among them.
[[nodiscard]] std::vector<BenchSphere> default_bench_spheres();

/// The scene in doubles: mesh (tilted 25 degrees about x, then 15 about z) and everything around it. The
/// picture is 320x240, or the smallest multiple of it that holds the sphere.
struct BenchScene {
  MeshData mesh;
  Scene scene;
  double focal = 0;  ///< in pixels
  double eye = 0;    ///< on the z axis
};
[[nodiscard]] BenchScene make_bench_scene(const BenchSphere& sphere);

}  // namespace arcspan::tools
