// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/plain/crease.hpp>
#include <arcspan_tools/mesh/plain/positions.hpp>

#include <cmath>
#include <numbers>

namespace arcspan::tools {
namespace {

struct Face {
  Vec3 area;       ///< twice its area long
  Vec3 direction;  ///< the same at unit length
};

std::vector<Face> faces_of(const MeshData& mesh) {
  std::vector<Face> faces;
  faces.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    const Vec3& a = mesh.positions[t[0]];
    const Vec3 area = cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
    faces.push_back({area, normalised(area)});
  }
  return faces;
}

/// The faces around each position.
std::vector<std::vector<std::uint32_t>> faces_around(const MeshData& mesh, const Positions& positions) {
  std::vector<std::vector<std::uint32_t>> around(positions.points.size());
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
    for (const std::uint32_t vertex : mesh.triangles[face]) {
      around[positions.ids[vertex]].push_back(static_cast<std::uint32_t>(face));
    }
  }
  return around;
}

Vec3 average(const Face& own, const std::vector<std::uint32_t>& around, const std::vector<Face>& faces,
             double least_cosine) {
  Vec3 sum;
  for (const std::uint32_t other : around) {
    if (dot(own.direction, faces[other].direction) >= least_cosine) sum = sum + faces[other].area;
  }
  // Only faces that cancel each other out, at creases above 90 degrees, leave no direction.
  return length(sum) > 1e-9 * length(own.area) ? normalised(sum) : own.direction;
}

}  // namespace

MeshData with_crease(const MeshData& mesh, double degrees, const std::string& subject) {
  const Positions positions = positions_of(mesh);
  const std::vector<Face> faces = faces_of(mesh);
  const std::vector<std::vector<std::uint32_t>> around = faces_around(mesh, positions);
  // A face is always within 0 degrees of itself, whatever rounding makes of its cosine.
  const double least_cosine = std::cos(degrees * std::numbers::pi / 180) - 1e-12;
  RawMesh raw;
  raw.triangles.reserve(faces.size());
  for (std::size_t face = 0; face < faces.size(); ++face) {
    std::array<RawMesh::Corner, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t vertex = mesh.triangles[face][i];
      const auto& neighbours = around[positions.ids[vertex]];
      corners[i] = {mesh.positions[vertex], average(faces[face], neighbours, faces, least_cosine)};
    }
    raw.triangles.push_back(corners);
  }
  MeshData creased = weld(raw, subject);
  creased.dropped_faces += mesh.dropped_faces;
  return creased;
}

}  // namespace arcspan::tools
