// SPDX-License-Identifier: MIT
#include <arcspan_tools/fixed_point/curve_room.hpp>
#include <arcspan_tools/fixed_point/fixed_mesh.hpp>

#include <algorithm>

namespace arcspan::tools {
namespace {

/// From the middle of an edge to that of the curve over it, as CurvedOutlines has it; 0 where normals are so
/// far apart that there is no curve.
Vec3 rise_over(const MeshData& mesh, std::size_t a, std::size_t b) {
  constexpr double kLeastCosine = 0.299;  // CurvedOutlines has 0.3, of rounded normals
  const Vec3& na = mesh.normals[a];
  const Vec3& nb = mesh.normals[b];
  if (dot(na, nb) < kLeastCosine) return {};
  const Vec3 edge = mesh.positions[b] - mesh.positions[a];
  return (nb * dot(edge, nb) - na * dot(edge, na)) * (1.0 / 8);
}

}  // namespace

Box with_curves(const Box& box, const Model& model) {
  // Rounding of positions and normals moves a curve by at most 12 of the 65534 units.
  constexpr double kRounding = 12.0 / 65534;
  Box out = box;
  double highest = 0;
  for (const ModelPart& part : model.parts) {
    const MeshData& mesh = part.mesh;
    for (const auto& t : mesh.triangles) {
      for (std::size_t edge = 0; edge < t.size(); ++edge) {
        const std::uint32_t a = t[edge];
        const std::uint32_t b = t[(edge + 1) % t.size()];
        const Vec3 rise = rise_over(mesh, a, b);
        highest = std::max(highest, length(rise));
        const Vec3 top = (mesh.positions[a] + mesh.positions[b]) * 0.5 + rise;
        out = joined(out, {top, top});
      }
    }
  }
  const auto widened = [](const Box& b, double by) {
    return Box{b.low - Vec3{by, by, by}, b.high + Vec3{by, by, by}};
  };
  if (model.rig != nullptr) out = widened(out, highest);
  const Vec3 extent = out.high - out.low;
  return widened(out, kRounding * std::max({extent.x, extent.y, extent.z}));
}

}  // namespace arcspan::tools
