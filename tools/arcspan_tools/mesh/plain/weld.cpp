// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/plain/mesh_data.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <bit>
#include <unordered_map>

namespace arcspan::tools {
namespace {

struct VertexHash {
  // The golden ratio's bits carry upwards only, so the upper half comes down at the end.
  static std::uint64_t mix(std::uint64_t seed, double value) {
    return (seed ^ std::bit_cast<std::uint64_t>(value)) * 0x9E3779B97F4A7C15u;
  }
  static std::uint64_t mix(std::uint64_t seed, const Vec3& v) { return mix(mix(mix(seed, v.x), v.y), v.z); }
  static std::size_t folded(std::uint64_t hash) { return static_cast<std::size_t>(hash ^ (hash >> 32)); }
  std::size_t operator()(const Vec3& v) const { return folded(mix(0, v)); }
  std::size_t operator()(const RawMesh::Corner& c) const { return folded(mix(mix(0, c.position), c.normal)); }
};

struct SameVertex {
  bool operator()(const RawMesh::Corner& a, const RawMesh::Corner& b) const {
    return a.position == b.position && a.normal == b.normal;
  }
};

// Adding +0 turns -0 into +0, so that equal vectors have equal bits.
Vec3 canonical(Vec3 v) { return v + Vec3{}; }

Vec3 area_vector(const std::array<RawMesh::Corner, 3>& t) {
  return cross(t[1].position - t[0].position, t[2].position - t[0].position);
}

using NormalAt = std::unordered_map<Vec3, Vec3, VertexHash>;

// Faces that cancel out at a position (a sheet with two sides) leave no direction: the first face's then.
NormalAt averaged_normals(const RawMesh& raw) {
  NormalAt sums;
  NormalAt first;
  for (const auto& triangle : raw.triangles) {
    const Vec3 area = area_vector(triangle);
    if (length(area) == 0) continue;
    for (const RawMesh::Corner& corner : triangle) {
      const Vec3 key = canonical(corner.position);
      first.emplace(key, area);
      sums[key] = sums[key] + area;
    }
  }
  for (auto& [position, sum] : sums) {
    const Vec3 fallback = first.at(position);
    sum = normalised(length(sum) > 1e-9 * length(fallback) ? sum : fallback);
  }
  return sums;
}

void check_limit(const std::string& subject, const char* what, std::size_t count, std::size_t limit) {
  if (count <= limit) return;
  throw Failure(subject,
                "too many " + std::string(what) + " (more than " + std::to_string(limit) + ", the limit)");
}

class Welder {
 public:
  Welder(MeshData& mesh, const NormalAt& averaged) : mesh_(mesh), averaged_(averaged) {}

  std::uint32_t vertex(const RawMesh::Corner& corner) {
    const Vec3 position = canonical(corner.position);
    const Vec3 own = canonical(normalised(corner.normal));
    const Vec3 normal = own == Vec3{} ? canonical(averaged_.at(position)) : own;
    const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
    const auto [at, is_new] = known_.try_emplace({position, normal}, next);
    if (is_new) {
      mesh_.positions.push_back(position);
      mesh_.normals.push_back(normal);
    }
    return at->second;
  }

 private:
  MeshData& mesh_;
  const NormalAt& averaged_;
  std::unordered_map<RawMesh::Corner, std::uint32_t, VertexHash, SameVertex> known_;
};

}  // namespace

MeshData weld(const RawMesh& raw, const std::string& subject) {
  check_limit(subject, "triangles", raw.triangles.size(), kMaxTriangles);
  const NormalAt averaged = averaged_normals(raw);
  MeshData mesh;
  Welder welder(mesh, averaged);
  for (const auto& triangle : raw.triangles) {
    if (length(area_vector(triangle)) == 0) {
      ++mesh.dropped_faces;
      continue;
    }
    std::array<std::uint32_t, 3> indices{};
    for (std::size_t i = 0; i < 3; ++i) indices[i] = welder.vertex(triangle[i]);
    check_limit(subject, "vertices", mesh.positions.size(), kMaxVertices);
    mesh.triangles.push_back(indices);
  }
  if (mesh.triangles.empty()) {
    throw Failure(subject, mesh.dropped_faces == 0 ? "no faces"
                                                   : "no faces with an area (" +
                                                         std::to_string(mesh.dropped_faces) + " dropped)");
  }
  return mesh;
}

}  // namespace arcspan::tools
