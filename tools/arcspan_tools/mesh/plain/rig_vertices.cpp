// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/plain/rig_vertices.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace arcspan::tools {
namespace {

std::uint64_t mixed(std::uint64_t hash, std::uint64_t bits) {
  return (std::rotl(hash, 5) ^ bits) * 0x9E3779B97F4A7C15u;
}

std::uint64_t mixed(std::uint64_t hash, const Vec3& v) {
  for (const double c : {v.x, v.y, v.z}) hash = mixed(hash, std::bit_cast<std::uint64_t>(c + 0.0));
  return hash;
}

std::uint64_t hash_of(const RigVertex& v) {
  std::uint64_t hash = mixed(mixed(v.instance, v.position), v.normal);
  for (const std::size_t joint : v.joints) hash = mixed(hash, joint);
  for (const double weight : v.weights) hash = mixed(hash, std::bit_cast<std::uint64_t>(weight));
  for (const MorphDelta& delta : v.deltas) hash = mixed(mixed(hash, delta.position), delta.normal);
  return hash ^ (hash >> 32);
}

/// The unit normal of a triangle, zero if it has no area. It is rounded, so that triangles of one plane share
/// their vertices.
Vec3 flat_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  constexpr double kSteps = 1 << 20;
  const Vec3 n = normalised(cross(b - a, c - a)) * kSteps;
  return Vec3{std::round(n.x), std::round(n.y), std::round(n.z)} * (1 / kSteps);
}

}  // namespace

std::uint32_t RigVertices::add(const RigVertex& vertex) {
  const std::uint64_t hash = hash_of(vertex);
  const auto [begin, end] = known_.equal_range(hash);
  for (auto same = begin; same != end; ++same) {
    if (vertices_[same->second] == vertex) return same->second;
  }
  const auto number = static_cast<std::uint32_t>(vertices_.size());
  vertices_.push_back(vertex);
  known_.emplace(hash, number);
  return number;
}

void add_flat_normals(std::array<RigVertex, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  Vec3 base = flat_normal(a.position, b.position, c.position);
  std::vector<Vec3> shaped;  // of each morph target
  for (std::size_t i = 0; i < a.deltas.size(); ++i) {
    shaped.push_back(flat_normal(a.position + a.deltas[i].position, b.position + b.deltas[i].position,
                                 c.position + c.deltas[i].position));
    if (base == Vec3{}) base = shaped.back();
  }
  for (RigVertex& corner : triangle) {
    corner.normal = base;
    for (std::size_t i = 0; i < shaped.size(); ++i)
      corner.deltas[i].normal = shaped[i] == Vec3{} ? Vec3{} : shaped[i] - base;
  }
}

void JointWeights::add(std::size_t joint, double weight) {
  if (weight == 0) return;
  const auto same = std::find_if(found_.begin(), found_.end(),
                                 [joint](const Influence& other) { return other.joint == joint; });
  if (same == found_.end()) {
    found_.push_back({joint, weight});
  } else {
    same->weight += weight;
  }
}

void JointWeights::bind(RigVertex& out) const {
  std::vector<Influence> largest = found_;
  std::stable_sort(largest.begin(), largest.end(),
                   [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
  if (largest.size() > kMostWeights) largest.resize(kMostWeights);
  double sum = 0;
  for (const Influence& influence : largest) sum += influence.weight;
  for (std::size_t i = 0; i < largest.size(); ++i) {
    out.joints[i] = largest[i].joint;
    out.weights[i] = largest[i].weight / sum;
  }
}

}  // namespace arcspan::tools
