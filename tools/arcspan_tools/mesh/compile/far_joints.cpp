// SPDX-License-Identifier: MIT
#include <arcspan/animate/joint_matrix.hpp>

#include <arcspan_tools/mesh/compile/far_joints.hpp>
#include <arcspan_tools/mesh/compile/part_motion.hpp>
#include <arcspan_tools/mesh/compile/stored_rig.hpp>
#include <arcspan_tools/mesh/plain/rig_pose.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

namespace arcspan::tools {
namespace {

/// How many vertices are posed for all clips together, aimed at.
constexpr std::size_t kMostCheckedVertices = 2'000'000;

/// A vertex of the rig, and how many of its joints, the first ones, still have a weight when it is stored.
struct SharedVertex {
  std::uint32_t source = 0;
  std::size_t joints = 0;
};

/// The vertices of a model that follow several joints, each once.
std::vector<SharedVertex> shared_vertices(const FixedModel& model) {
  std::set<std::uint32_t> sources;
  for (const FixedMesh& mesh : model.meshes) sources.insert(mesh.sources.begin(), mesh.sources.end());
  std::vector<SharedVertex> shared;
  for (const std::uint32_t source : sources) {
    if (source == kNoSource) continue;
    std::vector<double> weights;
    for (const double weight : model.rig->vertices[source].weights) {
      if (weight > 0) weights.push_back(weight);
    }
    if (weights.size() > 1) shared.push_back({source, fixed_weights(weights).size()});
  }
  return shared;
}

/// The first joint that takes a vertex so far from the origin, or from where its first joint takes it, that
/// the pipeline's weighted sum may overflow; nothing if none does. `mesh` has the unit and the origin.
std::optional<std::size_t> far_joint(const RigPoser& poser, const RigVertex& vertex, std::size_t joints,
                                     const FixedMesh& mesh) {
  const double room = 2.0 * JointMatrix::kFarthest * mesh.unit;
  const auto is_far = [room](Vec3 v) {
    return !(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) < room);
  };
  const Vec3 shaped = poser.shaped_position(vertex);
  const auto place = [&](std::size_t i) {
    return poser.place(vertex.instance, vertex.joints[i]).point(shaped);
  };
  for (std::size_t i = 0; joints > 1 && i < joints; ++i) {
    if (is_far(place(i) - mesh.centre) || is_far(place(i) - place(0))) return vertex.joints[i];
  }
  return std::nullopt;
}

}  // namespace

void check_joints_are_near(const FixedModel& model, const std::string& subject) {
  const Rig& rig = *model.rig;
  const std::vector<SharedVertex> shared = shared_vertices(model);
  const auto check = [&](const RigPose& pose, const std::string& when) {
    const RigPoser poser(rig, pose);
    for (const auto& [source, joints] : shared) {
      const RigVertex& vertex = rig.vertices[source];
      const std::optional<std::size_t> joint = far_joint(poser, vertex, joints, model.meshes[0]);
      if (!joint) continue;
      const std::size_t node = rig.skins[*rig.instances[vertex.instance].skin].joints[*joint];
      throw Failure(
          subject,
          "the node " + std::to_string(node) + " '" + rig.nodes[node].name +
              "' moves a vertex of several joints 4 extents of the model or more away from the middle of "
              "the model, or from where another joint moves it, " +
              when + "; --pose leaves the nodes out");
    }
  };
  if (shared.empty()) return;
  check(rest_pose(rig), "at rest");
  const std::size_t most = std::max<std::size_t>(
      kMostCheckedVertices / (shared.size() * std::max<std::size_t>(rig.clips.size(), 1)), 16);
  for (const RigClip& clip : rig.clips) {
    for (const double time : times_between(key_times(clip), 2, most))
      check(pose_at(rig, clip, time), "in the clip '" + clip.name + "'");
  }
}

}  // namespace arcspan::tools
