// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/plain/crease.hpp>
#include <arcspan_tools/mesh/plain/positions.hpp>

#include <cmath>

namespace arcspan::tools {
namespace {

struct Face {
  Vec3 area;       ///< twice its area long
  Vec3 direction;  ///< the same at unit length
};

std::vector<Face> faces_of(const RawMesh& mesh) {
  std::vector<Face> faces;
  faces.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    const Vec3& a = t[0].position;
    const Vec3 area = cross(t[1].position - a, t[2].position - a);
    faces.push_back({area, normalised(area)});
  }
  return faces;
}

/// The positions of the corners, triangle after triangle.
std::vector<Vec3> corners_of(const RawMesh& mesh) {
  std::vector<Vec3> corners;
  corners.reserve(3 * mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    for (const RawMesh::Corner& corner : t) corners.push_back(corner.position);
  }
  return corners;
}

/// The faces around each position.
std::vector<std::vector<std::uint32_t>> faces_around(const Positions& positions) {
  std::vector<std::vector<std::uint32_t>> around(positions.points.size());
  for (std::size_t corner = 0; corner < positions.ids.size(); ++corner) {
    around[positions.ids[corner]].push_back(static_cast<std::uint32_t>(corner / 3));
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

void crease(RawMesh& mesh, double degrees) {
  const Positions positions = positions_of(corners_of(mesh));
  const std::vector<Face> faces = faces_of(mesh);
  const std::vector<std::vector<std::uint32_t>> around = faces_around(positions);
  // A face is always within 0 degrees of itself, whatever rounding makes of its cosine.
  const double least_cosine = std::cos(degrees * kDegree) - 1e-12;
  for (std::size_t face = 0; face < faces.size(); ++face) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& neighbours = around[positions.ids[3 * face + i]];
      mesh.triangles[face][i].normal = average(faces[face], neighbours, faces, least_cosine);
    }
  }
}

}  // namespace

Model with_crease(const Model& model, double degrees, const std::string& subject) {
  RawModel raw = to_raw(model);
  crease(raw.mesh, degrees);
  Model creased = weld_parts(raw, subject, TexturePointsOf::kAllParts);
  creased.dropped_faces += model.dropped_faces;
  return creased;
}

MeshData with_crease(const MeshData& mesh, double degrees, const std::string& subject) {
  Model creased = with_crease(to_model(mesh), degrees, subject);
  creased.parts[0].mesh.dropped_faces = creased.dropped_faces;
  return std::move(creased.parts[0].mesh);
}

}  // namespace arcspan::tools
