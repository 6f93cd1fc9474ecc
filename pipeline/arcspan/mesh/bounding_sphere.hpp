// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/numbers/root.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// A sphere that contains all vertices of a mesh, in object units.
struct BoundingSphere {
  ObjectPosition middle;
  std::uint16_t radius = 0;

  friend constexpr bool operator==(const BoundingSphere&, const BoundingSphere&) = default;
};

/// The smallest sphere around the middle of the mesh's box. It takes time linear in the number of vertices.
[[nodiscard]] constexpr BoundingSphere bounding_sphere(const MeshView& mesh) {
  const std::size_t count = mesh.vertex_count();
  if (count == 0) return {};
  std::int32_t low[3] = {INT16_MAX, INT16_MAX, INT16_MAX};
  std::int32_t high[3] = {INT16_MIN, INT16_MIN, INT16_MIN};
  for (std::size_t i = 0; i < count; ++i) {
    const ObjectPosition& p = mesh.position(i);
    const std::int32_t c[3] = {p.x, p.y, p.z};
    for (std::size_t j = 0; j < 3; ++j) {
      if (c[j] < low[j]) low[j] = c[j];
      if (c[j] > high[j]) high[j] = c[j];
    }
  }
  const auto half = [&](std::size_t j) { return static_cast<std::int16_t>((low[j] + high[j]) >> 1); };
  BoundingSphere sphere{{half(0), half(1), half(2)}, 0};
  std::uint64_t farthest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const ObjectPosition& p = mesh.position(i);
    const auto square = [](std::int32_t c) { return static_cast<std::uint64_t>(std::int64_t{c} * c); };
    const std::uint64_t away = square(std::int32_t{p.x} - sphere.middle.x) +
                               square(std::int32_t{p.y} - sphere.middle.y) +
                               square(std::int32_t{p.z} - sphere.middle.z);
    if (away > farthest) farthest = away;
  }
  if (farthest != 0) sphere.radius = static_cast<std::uint16_t>(wide_integer_root(farthest - 1) + 1);
  return sphere;
}

}  // namespace arcspan
