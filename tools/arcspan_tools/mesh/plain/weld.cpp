// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/plain/mesh_data.hpp>
#include <arcspan_tools/mesh/plain/model.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <unordered_map>
#include <utility>

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
};

/// A vertex as it is joined with others.
struct Vertex {
  Vec3 position;
  Vec3 normal;
  Uv texture_point;
  Rgb8 colour;
  std::uint32_t source;

  friend bool operator==(const Vertex&, const Vertex&) = default;
};
struct JoinHash {
  std::size_t operator()(const Vertex& v) const {
    const std::uint64_t of_vectors = VertexHash::mix(VertexHash::mix(0, v.position), v.normal);
    const std::uint64_t of_point =
        VertexHash::mix(VertexHash::mix(of_vectors, v.texture_point.u), v.texture_point.v);
    return VertexHash::folded(
        VertexHash::mix(VertexHash::mix(of_point, v.colour.r * 65536.0 + v.colour.g * 256.0 + v.colour.b),
                        static_cast<double>(v.source)));
  }
};

// Adding +0 turns -0 into +0, so that equal vectors have equal bits.
Vec3 canonical(Vec3 v) { return v + Vec3{}; }
Uv canonical(Uv p) { return {p.u + 0.0, p.v + 0.0}; }

Vec3 area_vector(const std::array<RawMesh::Corner, 3>& t) {
  return cross(t[1].position - t[0].position, t[2].position - t[0].position);
}

/// Whether the triangle of a rig may have an area in another pose than that at rest.
bool has_area_elsewhere(const std::array<RawMesh::Corner, 3>& t, const Rig* rig) {
  std::array<RawMesh::Corner, 3> stored = t;
  for (RawMesh::Corner& corner : stored) {
    if (rig == nullptr || corner.source == kNoSource) return false;
    corner.position = rig->vertices[corner.source].position;
  }
  if (length(area_vector(stored)) > 0) return true;
  std::array<bool, 3> joined{};
  for (std::size_t i = 0; i < 3; ++i) joined[i] = stored[i].position == stored[(i + 1) % 3].position;
  return can_open(*rig, {t[0].source, t[1].source, t[2].source}, joined);
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
  Welder(const NormalAt& averaged, bool with_points, bool with_colours, bool with_sources)
      : averaged_(averaged),
        with_points_(with_points),
        with_colours_(with_colours),
        with_sources_(with_sources) {}

  void add(const std::array<RawMesh::Corner, 3>& triangle, std::uint32_t group, const std::string& subject) {
    std::array<std::uint32_t, 3> indices{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 position = canonical(triangle[i].position);
      const Vec3 own = canonical(normalised(triangle[i].normal));
      const Vec3 normal = own == Vec3{} ? missing_normal(triangle, position, group) : own;
      const Uv point = with_points_ ? canonical(triangle[i].texture_point.value_or(Uv{})) : Uv{};
      const Rgb8 colour = triangle[i].colour.value_or(Rgb8{});
      indices[i] = index_of({position, normal, point, colour, triangle[i].source});
    }
    // A part that moves stays one, because its vertices are numbered from those of the rig.
    if (with_sources_) check_limit(subject, "vertices", mesh_.positions.size(), kMaxVertices);
    mesh_.triangles.push_back(indices);
  }
  [[nodiscard]] MeshData& mesh() { return mesh_; }

 private:
  [[nodiscard]] Vec3 missing_normal(const std::array<RawMesh::Corner, 3>& triangle, const Vec3& position,
                                    std::uint32_t group) const {
    if (group == RawMesh::kFlat) return canonical(normalised(area_vector(triangle)));
    const auto found = averaged_.find({position, group});
    return found == averaged_.end() ? Vec3{} : canonical(found->second);
  }

  std::uint32_t index_of(const Vertex& vertex) {
    const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
    const auto [at, is_new] = known_.try_emplace(vertex, next);
    if (is_new) {
      mesh_.positions.push_back(vertex.position);
      mesh_.normals.push_back(vertex.normal);
      if (with_points_) mesh_.texture_points.push_back(vertex.texture_point);
      if (with_colours_) mesh_.colours.push_back(vertex.colour);
      if (with_sources_) mesh_.sources.push_back(vertex.source);
    }
    return at->second;
  }

  MeshData mesh_;
  const NormalAt& averaged_;
  bool with_points_;
  bool with_colours_;
  bool with_sources_;
  std::unordered_map<Vertex, std::uint32_t, JoinHash> known_;
};

void require_faces(const std::string& subject, bool any, std::size_t dropped) {
  if (any) return;
  throw Failure(
      subject, dropped == 0 ? "no faces" : "no faces with an area (" + std::to_string(dropped) + " dropped)");
}

/// Texture points are stored from 0 on where the texture is clamped, otherwise from near their middle.
bool is_in_texture_range(const std::vector<Uv>& points, const TextureSampler& sampler) {
  const auto is_in_range = [&points](double Uv::*coordinate, TextureWrap wrap) {
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), [&](const Uv& a, const Uv& b) {
      return a.*coordinate < b.*coordinate;
    });
    if (wrap != TextureWrap::kClamp) return (*high).*coordinate - (*low).*coordinate <= kMostTextures;
    return std::max((*high).*coordinate, -((*low).*coordinate)) <= kMostTextures / 2;
  };
  return points.empty() || (is_in_range(&Uv::u, sampler.u) && is_in_range(&Uv::v, sampler.v));
}

/// For each look, whether a corner of its triangles has what `has` asks for.
template <class Has>
std::vector<bool> looks_with(const RawModel& raw, const Has& has) {
  std::vector<bool> found(raw.looks.size());
  for (std::size_t i = 0; i < raw.mesh.triangles.size(); ++i) {
    for (const RawMesh::Corner& corner : raw.mesh.triangles[i]) {
      if (has(corner)) found[raw.look_of[i]] = true;
    }
  }
  return found;
}

}  // namespace

MeshData weld(const RawMesh& raw, const std::string& subject) {
  Model model = weld_parts({raw, {{}}, std::vector<std::uint32_t>(raw.triangles.size()), {}}, subject);
  check_limit(subject, "vertices", model.vertex_count(), kMaxVertices);
  model.parts[0].mesh.dropped_faces = model.dropped_faces;
  return std::move(model.parts[0].mesh);
}

Model weld_parts(const RawModel& raw, const std::string& subject, TexturePointsOf points) {
  check_limit(subject, "triangles", raw.mesh.triangles.size(), kMaxTriangles);
  const NormalAt averaged = averaged_normals(raw.mesh);
  const std::vector<bool> has_points =
      looks_with(raw, [](const RawMesh::Corner& corner) { return corner.texture_point.has_value(); });
  const std::vector<bool> has_colours =
      looks_with(raw, [](const RawMesh::Corner& corner) { return corner.colour.has_value(); });
  const std::vector<bool> has_sources =
      looks_with(raw, [](const RawMesh::Corner& corner) { return corner.source != kNoSource; });
  std::vector<Welder> welders;
  for (std::size_t i = 0; i < raw.looks.size(); ++i) {
    const bool wanted = points == TexturePointsOf::kAllParts || raw.looks[i].material.texture != nullptr;
    welders.emplace_back(averaged, wanted && has_points[i], has_colours[i], has_sources[i]);
  }
  Model model;
  model.rig = raw.rig;
  for (std::size_t i = 0; i < raw.mesh.triangles.size(); ++i) {
    const auto& triangle = raw.mesh.triangles[i];
    if (length(area_vector(triangle)) == 0 && !has_area_elsewhere(triangle, raw.rig.get())) {
      ++model.dropped_faces;
      continue;
    }
    welders[raw.look_of[i]].add(triangle, smoothing_of(raw.mesh, i), subject);
  }
  std::size_t without_points = 0;
  std::size_t out_of_range = 0;
  for (std::size_t i = 0; i < welders.size(); ++i) {
    if (welders[i].mesh().triangles.empty()) continue;
    ModelPart& part = model.parts.emplace_back(ModelPart{raw.looks[i], std::move(welders[i].mesh())});
    const bool in_range = is_in_texture_range(part.mesh.texture_points, part.look.material.sampler);
    if (!in_range) part.mesh.texture_points.clear();
    if (has_points[i] && in_range) continue;
    const bool had_texture = std::exchange(part.look.material.texture, nullptr) != nullptr;
    if (!in_range) {
      ++out_of_range;
    } else if (had_texture) {
      ++without_points;
    }
  }
  require_faces(subject, !model.parts.empty(), model.dropped_faces);
  model.warnings = raw.warnings;
  const auto warn = [&model](const char* what, std::size_t parts) {
    if (parts > 0) model.warnings.push_back(what + (" (" + std::to_string(parts) + ")"));
  };
  warn("parts with a texture but without texture coordinates are drawn without it", without_points);
  warn(
      "parts whose texture coordinates are more than 4000 apart, or 2000 from a clamped texture, are drawn "
      "without their texture",
      out_of_range);
  return model;
}

}  // namespace arcspan::tools
