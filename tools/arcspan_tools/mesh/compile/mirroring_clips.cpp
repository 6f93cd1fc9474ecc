// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/compile/mirroring_clips.hpp>
#include <arcspan_tools/mesh/compile/stored_rig.hpp>
#include <arcspan_tools/mesh/plain/rig_pose.hpp>

#include <vector>

namespace arcspan::tools {

std::optional<std::size_t> mirrored_node(const Rig& rig, const RigClip& clip) {
  constexpr std::size_t kMostPosedNodes = 1'000'000;
  const std::vector<bool> followed = followed_nodes(rig);
  const RigPoser rest(rig, rest_pose(rig));
  for (const double time : times_between(key_times(clip), 2, kMostPosedNodes / rig.nodes.size())) {
    const RigPoser poser(rig, pose_at(rig, clip, time));
    for (std::size_t i = 0; i < rig.nodes.size(); ++i) {
      if (followed[i] && poser.nodes()[i].determinant() * rest.nodes()[i].determinant() < 0) return i;
    }
  }
  return std::nullopt;
}

}  // namespace arcspan::tools
