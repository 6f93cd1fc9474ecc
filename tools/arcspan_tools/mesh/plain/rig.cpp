// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/plain/rig.hpp>

#include <algorithm>

namespace arcspan::tools {

bool move_alike(const RigVertex& a, const RigVertex& b) {
  return a.instance == b.instance && a.joints == b.joints && a.weights == b.weights &&
         std::equal(a.deltas.begin(), a.deltas.end(), b.deltas.begin(), b.deltas.end(),
                    [](const MorphDelta& x, const MorphDelta& y) { return x.position == y.position; });
}

bool can_open(const Rig& rig, const std::array<std::uint32_t, 3>& vertices,
              const std::array<bool, 3>& joined) {
  bool differ = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const bool alike = move_alike(rig.vertices[vertices[i]], rig.vertices[vertices[(i + 1) % 3]]);
    if (alike && joined[i]) return false;
    differ = differ || !alike;
  }
  return differ;
}

std::vector<bool> followed_nodes(const Rig& rig) {
  std::vector<bool> followed(rig.nodes.size());
  for (const RigVertex& vertex : rig.vertices) {
    const RigInstance& instance = rig.instances[vertex.instance];
    if (!instance.skin) followed[instance.node] = true;
    for (std::size_t i = 0; i < kMostWeights && instance.skin; ++i) {
      if (vertex.weights[i] > 0) followed[rig.skins[*instance.skin].joints[vertex.joints[i]]] = true;
    }
  }
  return followed;
}

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
