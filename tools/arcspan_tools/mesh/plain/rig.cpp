// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/plain/rig.hpp>

namespace arcspan::tools {

std::vector<bool> moved_nodes(const Rig& rig) {
  std::vector<bool> moved(rig.nodes.size());
  for (const RigClip& clip : rig.clips) {
    for (const RigChannel& channel : clip.channels)
      moved[channel.node] = moved[channel.node] || channel.path != ChannelPath::kMorphWeights;
  }
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const std::optional<std::size_t> parent = rig.nodes[i].parent;
    if (parent && moved[*parent]) moved[i] = true;
  }
  return moved;
}

std::optional<std::string> split_matrix(RigNode& node) {
  if (!node.matrix) return std::nullopt;
  const std::optional<NodeTransform> parts = split(*node.matrix);
  if (!parts) return "is a node whose matrix is not made of a translation, a rotation and a scale";
  node.rest = *parts;
  node.matrix.reset();
  return std::nullopt;
}

}  // namespace arcspan::tools
