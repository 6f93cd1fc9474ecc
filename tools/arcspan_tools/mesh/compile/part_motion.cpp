// SPDX-License-Identifier: MIT
#include <arcspan/mesh/bounding_sphere.hpp>

#include <arcspan_tools/fixed_point/rounding.hpp>
#include <arcspan_tools/mesh/compile/part_motion.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/text.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace arcspan::tools {
namespace {

constexpr std::size_t kMostJoints = 256;
constexpr std::size_t kStill = std::numeric_limits<std::size_t>::max();
constexpr double kWhole = 1024;

std::int16_t half_word(double value, double limit) {
  return static_cast<std::int16_t>(std::clamp(rounded(value), -limit, limit));
}

std::array<std::int16_t, 3> half_words(Vec3 v, double factor) {
  constexpr double kMost = 32767;
  return {half_word(v.x * factor, kMost), half_word(v.y * factor, kMost), half_word(v.z * factor, kMost)};
}

/// The sphere around the middle of the box of some points that holds them all.
BoundingSphere sphere_around(const std::vector<Vec3>& points) {
  Vec3 low = points[0];
  Vec3 high = points[0];
  for (const Vec3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const auto middle = [](double a, double b) { return half_word((a + b) / 2, 32767); };
  BoundingSphere sphere{{middle(low.x, high.x), middle(low.y, high.y), middle(low.z, high.z)}, 0};
  const Vec3 centre{double(sphere.middle.x), double(sphere.middle.y), double(sphere.middle.z)};
  double farthest = 0;
  for (const Vec3& p : points) farthest = std::max(farthest, length(p - centre));
  sphere.radius = static_cast<std::uint16_t>(std::min(std::ceil(farthest), 65535.0));
  return sphere;
}

/// The corners of the box in which morph targets move a vertex at all weights of `ranges`.
std::vector<Vec3> reached(const ObjectPosition& p, const std::vector<FixedMorphRecord>& records,
                          const std::vector<WeightRange>& ranges) {
  const Vec3 stored{double(p.x), double(p.y), double(p.z)};
  Box box{stored, stored};
  for (const FixedMorphRecord& record : records) {
    const auto& d = record.position;
    widen(box, {double(d[0]), double(d[1]), double(d[2])}, ranges[record.target]);
  }
  const auto& [low, high] = box;
  if (low == high) return {low};
  std::vector<Vec3> corners;
  corners.reserve(8);
  for (int i = 0; i < 8; ++i)
    corners.push_back({(i & 1) ? high.x : low.x, (i & 2) ? high.y : low.y, (i & 4) ? high.z : low.z});
  return corners;
}

}  // namespace

std::vector<std::uint16_t> fixed_weights(std::vector<double> weights) {
  while (weights.size() > 1 && weights.back() * kWhole < 0.5) weights.pop_back();
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<std::uint16_t> fixed;
  int left = static_cast<int>(kWhole);
  for (const double weight : weights) {
    fixed.push_back(static_cast<std::uint16_t>(std::floor(weight / sum * kWhole)));
    left -= fixed.back();
  }
  std::vector<std::size_t> order(weights.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto remainder = [&](std::size_t i) { return weights[i] / sum * kWhole - fixed[i]; };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return remainder(a) > remainder(b); });
  for (std::size_t i = 0; left > 0; ++i, --left) ++fixed[order[i % order.size()]];
  while (fixed.size() > 1 && fixed.back() == 0) fixed.pop_back();
  return fixed;
}

PartMotions::PartMotions(const Rig& rig, AnimationSpace& space, const std::string& subject)
    : rig_(rig), space_(space), subject_(subject), rest_(rig, rest_pose(rig)), places_(storage_places(rig)) {
  for (const Affine& place : places_) back_.push_back(*inverse(place));
  for (std::size_t i = 0; i < rig.instances.size(); ++i) ranges_.push_back(weight_ranges(rig, i));
}

bool PartMotions::follows(std::uint32_t source) const {
  if (source == kNoSource) return false;
  const RigInstance& instance = rig_.instances[rig_.vertices[source].instance];
  return instance.skin || space_.number(instance.node);
}

FixedJoint PartMotions::joint_of(const JointKey& key) {
  if (key.first == kStill) return space_.joint(std::nullopt, {});
  const RigInstance& instance = rig_.instances[key.first];
  if (!instance.skin) return space_.joint(instance.node, back_[key.first]);
  const RigSkin& skin = rig_.skins[*instance.skin];
  return space_.joint(skin.joints[key.second], skin.inverse_bind[key.second] * back_[key.first]);
}

FixedWeights PartMotions::weights_of(std::uint32_t source, std::map<JointKey, std::size_t>& keys,
                                     FixedSkin& skin) {
  const auto number = [&](const JointKey& key) {
    const auto [at, is_new] = keys.try_emplace(key);
    if (!is_new) return static_cast<std::uint16_t>(at->second);
    const FixedJoint joint = joint_of(key);
    const auto same = std::find(skin.begin(), skin.end(), joint);
    at->second = static_cast<std::size_t>(same - skin.begin());
    if (same == skin.end()) skin.push_back(joint);
    if (skin.size() > kMostJoints) throw Failure(subject_, "a part follows more than 256 joints");
    return static_cast<std::uint16_t>(at->second);
  };
  FixedWeights out;
  if (source == kNoSource) {
    out.joints[0] = number({kStill, 0});
    return out;
  }
  const RigVertex& vertex = rig_.vertices[source];
  if (!rig_.instances[vertex.instance].skin) {
    out.joints[0] = number({vertex.instance, 0});
    return out;
  }
  std::vector<double> weights;
  for (const double weight : vertex.weights) {
    if (weight > 0) weights.push_back(weight);
  }
  const std::vector<std::uint16_t> fixed = fixed_weights(weights);
  out.count = fixed.size();
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    out.weights[i] = fixed[i];
    out.joints[i] = number({vertex.instance, vertex.joints[i]});
  }
  return out;
}

std::vector<std::int16_t> PartMotions::rest_weights(std::size_t instance) const {
  constexpr double kWeightUnit = 4096;
  constexpr double kMost = 32767;
  const RigInstance& of = rig_.instances[instance];
  std::vector<std::int16_t> fixed;
  for (const double weight : of.morph_weights) {
    if (!(std::abs(weight * kWeightUnit) <= kMost)) {
      throw Failure(subject_, formatted("a morph weight at rest (%g) of the node %zu '", weight, of.node) +
                                  rig_.nodes[of.node].name + "' is out of range (weights are below 8)");
    }
    fixed.push_back(half_word(weight * kWeightUnit, kMost));
  }
  return fixed;
}

std::optional<FixedMorph> PartMotions::morph_of(const FixedMesh& mesh) const {
  constexpr double kNormalUnit = 16384;
  FixedMorph morph;
  for (const std::uint32_t source : mesh.sources) {
    std::vector<FixedMorphRecord>& records = morph.records.emplace_back();
    if (source == kNoSource) continue;
    const RigVertex& vertex = rig_.vertices[source];
    if (morph.weights.empty()) morph.weights = rest_weights(vertex.instance);
    const Affine& place = places_[vertex.instance];
    const auto stored = [&](Vec3 normal) { return place.direction(carried_normal(rest_, vertex, normal)); };
    const double size = length(stored(vertex.normal));
    for (std::size_t i = 0; i < vertex.deltas.size(); ++i) {
      FixedMorphRecord record{i, half_words(place.direction(vertex.deltas[i].position), 1 / mesh.unit), {}};
      if (size > 0) record.normal = half_words(stored(vertex.deltas[i].normal), kNormalUnit / size);
      const bool turns = record.normal != std::array<std::int16_t, 3>{};
      if (!turns && record.position == std::array<std::int16_t, 3>{}) continue;
      morph.has_normals = morph.has_normals || turns;
      records.push_back(record);
    }
  }
  if (morph.weights.empty()) return std::nullopt;
  return morph;
}

std::vector<FixedBound> PartMotions::bounds_of(const FixedMesh& mesh, const FixedPartMotion& motion) const {
  const std::vector<FixedMorphRecord> none;
  std::map<std::size_t, std::vector<Vec3>> points;  // of each joint
  for (std::size_t i = 0; i < motion.weights.size(); ++i) {
    const std::vector<FixedMorphRecord>& records = motion.morph ? motion.morph->records[i] : none;
    const auto& ranges = ranges_[records.empty() ? 0 : rig_.vertices[mesh.sources[i]].instance];
    const std::vector<Vec3> corners = reached(mesh.positions[i], records, ranges);
    const FixedWeights& weights = motion.weights[i];
    for (std::size_t k = 0; k < weights.count; ++k) {
      std::vector<Vec3>& of = points[weights.joints[k]];
      of.insert(of.end(), corners.begin(), corners.end());
    }
  }
  std::vector<FixedBound> bounds;
  bounds.reserve(points.size());
  for (const auto& [joint, of] : points) bounds.push_back({joint, sphere_around(of)});
  return bounds;
}

FixedPartMotion PartMotions::motion(const FixedMesh& mesh) {
  FixedPartMotion motion;
  if (mesh.sources.empty()) return motion;
  motion.morph = morph_of(mesh);
  if (std::none_of(mesh.sources.begin(), mesh.sources.end(), [this](auto source) { return follows(source); }))
    return motion;
  std::map<JointKey, std::size_t> keys;
  FixedSkin skin;
  for (const std::uint32_t source : mesh.sources) motion.weights.push_back(weights_of(source, keys, skin));
  const auto same = std::find(skins_.begin(), skins_.end(), skin);
  motion.skin = static_cast<std::size_t>(same - skins_.begin());
  if (same == skins_.end()) skins_.push_back(skin);
  motion.bounds = bounds_of(mesh, motion);
  return motion;
}

}  // namespace arcspan::tools
