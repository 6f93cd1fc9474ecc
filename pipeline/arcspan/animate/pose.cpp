// SPDX-License-Identifier: MIT
#include <arcspan/animate/key_frame.hpp>
#include <arcspan/animate/pose.hpp>

namespace arcspan {

namespace {

std::uint32_t limited_weight(const ClipBlend& blend) { return blend.weight > 65536 ? 65536 : blend.weight; }

}  // namespace

Status pose_nodes(const StoredAnimation& animation, const ClipBlend& blend, std::span<NodeMatrix> nodes) {
  const std::span<const StoredNode> stored = animation.nodes();
  if (nodes.size() < stored.size()) return Status::kBufferTooSmall;
  const std::uint32_t weight = limited_weight(blend);
  ClipSampler from(blend.from.clip, blend.from.time);
  ClipSampler to(weight == 0 ? StoredClip() : blend.to.clip, blend.to.time);
  for (std::size_t i = 0; i < stored.size(); ++i) {
    NodePose pose = rest_pose(stored[i]);
    from.set(i, pose);
    if (weight != 0) {
      NodePose other = rest_pose(stored[i]);
      to.set(i, other);
      pose = blended(pose, other, weight);
    }
    const NodeMatrix local = matrix_of(pose);
    const std::uint16_t parent = stored[i].parent;
    nodes[i] = parent == animation_binary::kNoParent ? local : nodes[parent] * local;
  }
  return Status::kOk;
}

Status pose_joints(std::span<const StoredJoint> skin, std::span<const NodeMatrix> nodes,
                   std::span<JointMatrix> joints) {
  if (joints.size() < skin.size()) return Status::kBufferTooSmall;
  for (std::size_t i = 0; i < skin.size(); ++i) {
    if (skin[i].node >= nodes.size()) return Status::kIndexOutOfRange;
    joints[i] = JointMatrix(nodes[skin[i].node] * matrix_of(skin[i]));
  }
  return Status::kOk;
}

Status pose_morph(const StoredAnimation& animation, std::size_t part, const ClipBlend& blend,
                  std::span<std::int16_t> weights) {
  const StoredMorph morph = animation.morph(part);
  const std::size_t count = morph.target_count();
  if (weights.size() < count) return Status::kBufferTooSmall;
  const std::uint32_t weight = limited_weight(blend);
  for (std::size_t i = 0; i < count; ++i) weights[i] = morph.weights()[i];
  ClipSampler(blend.from.clip, blend.from.time).blend_weights(part, morph.weights(), 65536, weights.data());
  if (weight == 0) return Status::kOk;
  ClipSampler(blend.to.clip, blend.to.time).blend_weights(part, morph.weights(), weight, weights.data());
  return Status::kOk;
}

}  // namespace arcspan
