// SPDX-License-Identifier: MIT
#include <arcspan_tools/fixed_point/rounding.hpp>
#include <arcspan_tools/fixed_point/stored_pose.hpp>
#include <arcspan_tools/mesh/compile/animation_error.hpp>
#include <arcspan_tools/mesh/compile/make_animation.hpp>
#include <arcspan_tools/mesh/compile/stored_rig.hpp>
#include <arcspan_tools/mesh/compile/thin_keys.hpp>
#include <arcspan_tools/mesh/plain/rig_pose.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

namespace arcspan::tools {
namespace {

/// Vertices that are posed at most, which take about a second.
constexpr std::size_t kMostPosedVertices = 2'000'000;

double degrees_between(Vec3 a, Vec3 b) { return std::atan2(length(cross(a, b)), dot(a, b)) / kDegree; }

class ErrorSearch {
 public:
  explicit ErrorSearch(const FixedModel& model) : model_(model), rest_(*model.rig, rest_pose(*model.rig)) {}

  void measure(const RigPose& pose, const StoredPose& stored, const std::string& clip, double seconds) {
    const RigPoser poser(*model_.rig, pose);
    for (std::size_t part = 0; part < model_.meshes.size(); ++part) {
      const FixedMesh& mesh = model_.meshes[part];
      for (std::size_t i = 0; i < mesh.sources.size(); ++i) {
        if (mesh.sources[i] == kNoSource) continue;
        const RigVertex& vertex = model_.rig->vertices[mesh.sources[i]];
        const Vec3 right = (poser.position(vertex) - mesh.centre) * (1 / mesh.unit);
        const StoredPose::Vertex found = stored.vertex(part, i);
        const double error = length(found.position - right);
        if (error > worst_.position) {
          worst_.position = error;
          worst_.clip = clip;
          worst_.seconds = seconds;
        }
        const Vec3 normal = posed_normal(rest_, poser, vertex);
        if (length(normal) > 0 && length(found.normal) > 0)
          worst_.normal_degrees = std::max(worst_.normal_degrees, degrees_between(normal, found.normal));
      }
    }
  }
  [[nodiscard]] const AnimationError& worst() const { return worst_; }

 private:
  const FixedModel& model_;
  RigPoser rest_;
  AnimationError worst_;
};

RigClip in_microseconds(RigClip clip) {
  for (RigChannel& channel : clip.channels) channel = in_microseconds(channel);
  return clip;
}

/// The keys of the file's clip and of the stored one, and times between.
std::vector<double> times_of(const RigClip& clip, const FixedClip& stored, std::size_t most) {
  // Components are farthest off spherical interpolation 0.21 after a key and before one.
  constexpr std::size_t kParts = 5;
  std::set<double> keys = key_times(clip);
  for (const FixedChannel& channel : stored.channels) {
    for (const std::uint32_t time : channel.times) keys.insert(time / 1e6);
  }
  std::vector<double> times = times_between(keys, kParts, most);
  for (double& time : times) time = rounded(time * 1e6) / 1e6;
  return times;
}

}  // namespace

AnimationError animation_error(const FixedModel& model) {
  const Rig& rig = *model.rig;
  ErrorSearch search(model);
  search.measure(rest_pose(rig), StoredPose(model), "", 0);
  const std::size_t most = std::max<std::size_t>(
      kMostPosedVertices / std::max<std::size_t>(model.vertex_count() * rig.clips.size(), 1), 2);
  const std::map<std::string, std::string> names = stored_clip_names(rig);
  for (const RigClip& clip : rig.clips) {
    const std::string& name = names.at(clip.name);
    const auto& clips = model.animation->clips;
    const auto same =
        std::find_if(clips.begin(), clips.end(), [&](const FixedClip& c) { return c.name == name; });
    if (same == clips.end()) continue;
    // Neither side is asked between two microseconds, where a step may be of one of them only.
    const RigClip right = in_microseconds(clip);
    for (const double time : times_of(right, *same, most))
      search.measure(pose_at(rig, right, time), StoredPose(model, *same, time), clip.name, time);
  }
  return search.worst();
}

}  // namespace arcspan::tools
