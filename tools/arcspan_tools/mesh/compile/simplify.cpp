// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/compile/simplify.hpp>
#include <arcspan_tools/mesh/plain/crease.hpp>
#include <arcspan_tools/mesh/plain/positions.hpp>
#include <meshoptimizer.h>

#include <algorithm>
#include <vector>

namespace arcspan::tools {
namespace {

/// As the library takes them: single precision, around the origin, so that meshes far from it lose nothing.
struct LibraryMesh {
  std::vector<float> positions;
  std::vector<unsigned> indices;
  double scale = 1;  ///< of the library's errors, which are relative to the largest extent

  [[nodiscard]] std::size_t vertices() const { return positions.size() / 3; }
};

LibraryMesh to_library(const std::vector<Vec3>& points) {
  Vec3 low = points[0];
  Vec3 high = points[0];
  for (const Vec3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  LibraryMesh out;
  out.scale = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  for (const Vec3& p : points) {
    const Vec3 unit = (p - low) * (1 / out.scale);
    for (const double c : {unit.x, unit.y, unit.z}) out.positions.push_back(static_cast<float>(c));
  }
  return out;
}

/// Shrinks the indices; returns the relative error.
double run_library(LibraryMesh& mesh, Simplification how, std::size_t triangles) {
  constexpr float kAnyError = 1;
  constexpr std::size_t kStride = 3 * sizeof(float);
  const std::vector<unsigned> from = mesh.indices;
  float error = 0;
  const std::size_t left =
      how == Simplification::kByCells
          ? meshopt_simplifySloppy(mesh.indices.data(), from.data(), from.size(), mesh.positions.data(),
                                   mesh.vertices(), kStride, 3 * triangles, kAnyError, &error)
          : meshopt_simplify(mesh.indices.data(), from.data(), from.size(), mesh.positions.data(),
                             mesh.vertices(), kStride, 3 * triangles, kAnyError, 0, &error);
  mesh.indices.resize(left);
  return static_cast<double>(error);
}

/// The vertices that are still used, in their old order.
MeshData without_unused(const MeshData& mesh, const std::vector<unsigned>& indices) {
  constexpr std::uint32_t kUnused = 0xFFFFFFFF;
  std::vector<std::uint32_t> now(mesh.positions.size(), kUnused);
  for (const unsigned index : indices) now[index] = 0;
  MeshData out;
  out.dropped_faces = mesh.dropped_faces;
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (now[i] == kUnused) continue;
    now[i] = static_cast<std::uint32_t>(out.positions.size());
    out.positions.push_back(mesh.positions[i]);
    out.normals.push_back(mesh.normals[i]);
  }
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    out.triangles.push_back({now[indices[i]], now[indices[i + 1]], now[indices[i + 2]]});
  }
  return out;
}

bool has_area(const MeshData& mesh) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&mesh](const auto& t) {
    const Vec3& a = mesh.positions[t[0]];
    return length(cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a)) > 0;
  });
}

Simplified with_normals(const MeshData& mesh, std::size_t triangles) {
  LibraryMesh library = to_library(mesh.positions);
  for (const auto& t : mesh.triangles) library.indices.insert(library.indices.end(), t.begin(), t.end());
  const double error = run_library(library, Simplification::kWithNormals, triangles);
  return {without_unused(mesh, library.indices), error * library.scale};
}

Simplified by_position(const MeshData& mesh, Simplification how, std::size_t triangles, double crease_degrees,
                       const std::string& subject) {
  Positions positions = positions_of(mesh.positions);
  LibraryMesh library = to_library(positions.points);
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t vertex : t) library.indices.push_back(positions.ids[vertex]);
  }
  const double error = run_library(library, how, triangles);
  MeshData joined;
  joined.dropped_faces = mesh.dropped_faces;
  joined.normals.resize(positions.points.size());
  joined.positions = std::move(positions.points);
  joined = without_unused(joined, library.indices);
  if (!has_area(joined)) return {};
  return {with_crease(joined, crease_degrees, subject), error * library.scale};
}

}  // namespace

const char* to_string(Simplification how) {
  switch (how) {
    case Simplification::kNone:
      return "none";
    case Simplification::kWithNormals:
      return "edge collapse, normals kept";
    case Simplification::kByPosition:
      return "edge collapse, normals made anew";
    case Simplification::kByCells:
      break;
  }
  return "clustering, normals made anew";
}

Simplified simplify(const MeshData& mesh, Simplification how, std::size_t triangles, double crease_degrees,
                    const std::string& subject) {
  switch (how) {
    case Simplification::kNone:
      return {mesh, 0};
    case Simplification::kWithNormals:
      return with_normals(mesh, triangles);
    case Simplification::kByPosition:
    case Simplification::kByCells:
      break;
  }
  return by_position(mesh, how, triangles, crease_degrees, subject);
}

}  // namespace arcspan::tools
