// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/plain/mesh_data.hpp>
#include <arcspan_tools/mesh/plain/model.hpp>
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

std::uint32_t smoothing_of(const RawMesh& raw, std::size_t triangle) {
  return raw.smoothing.empty() ? RawMesh::kSmooth : raw.smoothing[triangle];
}

/// A position within a smoothing group.
struct SmoothPoint {
  Vec3 position;
  std::uint32_t group;

  friend bool operator==(const SmoothPoint&, const SmoothPoint&) = default;
};
struct SmoothPointHash {
  std::size_t operator()(const SmoothPoint& p) const {
    return VertexHash::folded(VertexHash::mix(VertexHash::mix(0, p.position), p.group));
  }
};
using NormalAt = std::unordered_map<SmoothPoint, Vec3, SmoothPointHash>;

// Faces that cancel out at a position (a sheet with two sides) leave no direction: the first face's then.
NormalAt averaged_normals(const RawMesh& raw) {
  NormalAt sums;
  NormalAt first;
  for (std::size_t i = 0; i < raw.triangles.size(); ++i) {
    const Vec3 area = area_vector(raw.triangles[i]);
    const std::uint32_t group = smoothing_of(raw, i);
    if (length(area) == 0 || group == RawMesh::kFlat) continue;
    for (const RawMesh::Corner& corner : raw.triangles[i]) {
      const SmoothPoint key{canonical(corner.position), group};
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

/// Makes vertices of the corners of one mesh.
class Welder {
 public:
  explicit Welder(const NormalAt& averaged) : averaged_(averaged) {}

  void add(const std::array<RawMesh::Corner, 3>& triangle, std::uint32_t group, const std::string& subject) {
    std::array<std::uint32_t, 3> indices{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 position = canonical(triangle[i].position);
      const Vec3 own = canonical(normalised(triangle[i].normal));
      indices[i] = vertex(position, own == Vec3{} ? missing_normal(triangle, position, group) : own);
    }
    check_limit(subject, "vertices", mesh_.positions.size(), kMaxVertices);
    mesh_.triangles.push_back(indices);
  }
  [[nodiscard]] MeshData& mesh() { return mesh_; }

 private:
  [[nodiscard]] Vec3 missing_normal(const std::array<RawMesh::Corner, 3>& triangle, const Vec3& position,
                                    std::uint32_t group) const {
    return canonical(group == RawMesh::kFlat ? normalised(area_vector(triangle))
                                             : averaged_.at({position, group}));
  }

  std::uint32_t vertex(const Vec3& position, const Vec3& normal) {
    const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
    const auto [at, is_new] = known_.try_emplace({position, normal}, next);
    if (is_new) {
      mesh_.positions.push_back(position);
      mesh_.normals.push_back(normal);
    }
    return at->second;
  }

  MeshData mesh_;
  const NormalAt& averaged_;
  std::unordered_map<RawMesh::Corner, std::uint32_t, VertexHash, SameVertex> known_;
};

void require_faces(const std::string& subject, bool any, std::size_t dropped) {
  if (any) return;
  throw Failure(
      subject, dropped == 0 ? "no faces" : "no faces with an area (" + std::to_string(dropped) + " dropped)");
}

}  // namespace

MeshData weld(const RawMesh& raw, const std::string& subject) {
  Model model = weld_parts({raw, {{}}, std::vector<std::uint32_t>(raw.triangles.size()), {}}, subject);
  model.parts[0].mesh.dropped_faces = model.dropped_faces;
  return std::move(model.parts[0].mesh);
}

Model weld_parts(const RawModel& raw, const std::string& subject) {
  check_limit(subject, "triangles", raw.mesh.triangles.size(), kMaxTriangles);
  const NormalAt averaged = averaged_normals(raw.mesh);
  std::vector<Welder> welders(raw.looks.size(), Welder(averaged));
  Model model;
  for (std::size_t i = 0; i < raw.mesh.triangles.size(); ++i) {
    const auto& triangle = raw.mesh.triangles[i];
    if (length(area_vector(triangle)) == 0) {
      ++model.dropped_faces;
      continue;
    }
    welders[raw.look_of[i]].add(triangle, smoothing_of(raw.mesh, i), subject);
  }
  for (std::size_t i = 0; i < welders.size(); ++i) {
    if (welders[i].mesh().triangles.empty()) continue;
    model.parts.push_back({raw.looks[i], std::move(welders[i].mesh())});
  }
  require_faces(subject, !model.parts.empty(), model.dropped_faces);
  model.warnings = raw.warnings;
  return model;
}

}  // namespace arcspan::tools
