// SPDX-License-Identifier: MIT
#include <arcspan_tools/simulate/pose_cost.hpp>
#include <arcspan_tools/simulate/processor_cost.hpp>

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace arcspan::tools {
namespace {

Vec3 point(const ObjectPosition& p) { return {double(p.x), double(p.y), double(p.z)}; }

/// The corners of triangles that face `eye`, which is in object units. Returns the number of triangles.
template <class Take>
double for_each_front(const FixedMesh& mesh, Vec3 eye, const Take& take) {
  double fronts = 0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Vec3 a = point(mesh.positions[mesh.indices[i]]);
    const Vec3 b = point(mesh.positions[mesh.indices[i + 1]]);
    const Vec3 c = point(mesh.positions[mesh.indices[i + 2]]);
    if (dot(cross(b - a, c - a), eye - a) <= 0) continue;
    ++fronts;
    for (std::size_t k = 0; k < 3; ++k) take(mesh.indices[i + k]);
  }
  return fronts;
}

}  // namespace

PoseAmounts pose_amounts(const FixedModel& model, const FixedModel& posed, Vec3 eye, std::string_view shading,
                         double shaded) {
  const FixedAnimation& animation = *model.animation;
  PoseAmounts amounts;
  amounts.nodes = static_cast<double>(animation.nodes.size());
  std::set<std::size_t> skins;
  std::array<double, 4> corners{};  // of all front faces
  PoseAmounts::Morphs morphed_corners;
  double fronts = 0;
  double lit = 0;
  for (std::size_t part = 0; part < model.meshes.size(); ++part) {
    const FixedPartMotion& motion = animation.parts[part];
    const bool follows = !motion.weights.empty();
    if (follows) skins.insert(motion.skin);
    for (const FixedWeights& weights : motion.weights) ++amounts.positions[weights.count - 1];
    const auto targets_of = [&motion](std::size_t i) { return motion.morph->records[i].size(); };
    const FixedMesh& mesh = posed.meshes[part];
    for (std::size_t i = 0; motion.morph && i < mesh.positions.size(); ++i)
      amounts.morphed_positions.add(targets_of(i));
    std::vector<bool> is_lit(mesh.positions.size());
    fronts += for_each_front(mesh, (eye - mesh.centre) * (1 / mesh.unit), [&](std::size_t i) {
      const double once = is_lit[i] ? 0 : 1;
      is_lit[i] = true;
      lit += once;
      if (motion.morph) morphed_corners.add(targets_of(i));
      if (motion.morph && motion.morph->has_normals && once > 0 && targets_of(i) > 0)
        amounts.morphed_normals.add(targets_of(i));
      if (!follows) return;
      const std::size_t kind = motion.weights[i].count - 1;
      ++corners[kind];
      amounts.normals[kind] += once;
    });
  }
  for (const std::size_t skin : skins) amounts.joints += static_cast<double>(animation.skins[skin].size());
  if (shading != "flat") {
    if (lit > 0 && shaded > lit) {
      for (double& some : amounts.normals) some *= shaded / lit;
      amounts.morphed_normals = shaded / lit * amounts.morphed_normals;
    }
    return amounts;
  }
  amounts.normals = {};
  amounts.morphed_normals = {};
  const double share = fronts > 0 ? shaded / fronts : 0;
  for (std::size_t kind = 0; kind < corners.size(); ++kind) amounts.positions[kind] += share * corners[kind];
  amounts.morphed_positions += share * morphed_corners;
  return amounts;
}

double pose_instructions(std::string_view core, const PoseAmounts& amounts) {
  // Costs of vertices that 1 and 4 targets move; with other numbers they are on a line through both.
  const auto morphing = [core](const std::string& kind, const PoseAmounts::Morphs& morphs) {
    const double one = pose_cost(core, kind + " morph 1");
    const double more = (pose_cost(core, kind + " morph 4") - one) / 3;
    return morphs.vertices * (one - pose_cost(core, kind + " 0") - more) + morphs.targets * more;
  };
  double sum = morphing("position", amounts.morphed_positions) + morphing("normal", amounts.morphed_normals);
  sum += amounts.nodes * pose_cost(core, "node") + amounts.joints * pose_cost(core, "joint");
  for (std::size_t i = 0; i < 4; ++i) {
    // Drawing a mesh at rest, which is in the other terms, takes its own positions and normals.
    const std::string weights = std::to_string(i + 1);
    sum += amounts.positions[i] * (pose_cost(core, "position " + weights) - pose_cost(core, "position 0"));
    sum += amounts.normals[i] * (pose_cost(core, "normal " + weights) - pose_cost(core, "normal 0"));
  }
  return sum;
}

}  // namespace arcspan::tools
