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

bool is_open(const RawMesh& mesh, std::size_t triangle) {
  return mesh.smoothing.empty() || mesh.smoothing[triangle] == RawMesh::kSmooth;
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

/// Gives corners of the triangles for which `wanted` holds normals of their own making, from such triangles.
template <class Wanted, class Replaced>
void crease(RawMesh& mesh, double degrees, const Wanted& wanted, const Replaced& replaced) {
  const Positions positions = positions_of(corners_of(mesh));
  const std::vector<Face> faces = faces_of(mesh);
  std::vector<std::vector<std::uint32_t>> around(positions.points.size());
  for (std::size_t corner = 0; corner < positions.ids.size(); ++corner) {
    if (wanted(corner / 3)) around[positions.ids[corner]].push_back(static_cast<std::uint32_t>(corner / 3));
  }
  // A face is always within 0 degrees of itself, whatever rounding makes of its cosine.
  const double least_cosine = std::cos(degrees * kDegree) - 1e-12;
  for (std::size_t face = 0; face < faces.size(); ++face) {
    for (std::size_t i = 0; wanted(face) && i < 3; ++i) {
      Vec3& normal = mesh.triangles[face][i].normal;
      if (!replaced(normal)) continue;
      normal = average(faces[face], around[positions.ids[3 * face + i]], faces, least_cosine);
    }
  }
}

bool is_missing(const Vec3& normal) { return normal == Vec3{}; }

}  // namespace

bool add_creased_normals(RawMesh& mesh, double degrees) {
  if (degrees >= kSmoothEverything) return false;
  bool any = false;
  for (std::size_t i = 0; i < mesh.triangles.size() && !any; ++i) {
    for (const RawMesh::Corner& corner : mesh.triangles[i]) {
      any = any || (is_open(mesh, i) && is_missing(corner.normal));
    }
  }
  if (any)
    crease(
        mesh, degrees, [&mesh](std::size_t i) { return is_open(mesh, i); }, is_missing);
  return any;
}

Model with_crease(const Model& model, double degrees, const std::string& subject) {
  RawModel raw = to_raw(model);
  const auto all = [](const auto&) { return true; };
  crease(raw.mesh, degrees, all, all);
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
