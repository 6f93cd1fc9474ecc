// SPDX-License-Identifier: MIT
#include <arcspan/animate/skinned_mesh.hpp>

namespace arcspan {

Status SkinnedMesh::make(const MeshView& mesh, const StoredAnimation& animation, std::size_t part,
                         std::span<const JointMatrix> joints, SkinnedMesh& skinned) {
  const StoredWeights weights = animation.weights(part);
  if (!weights.exist() ||
      (!weights.are_of_one_joint() && weights.vertex_count() != mesh.vertex_count()))
    return Status::kInvalidArgument;
  if (joints.size() < animation.skin(weights.skin()).size()) return Status::kBufferTooSmall;
  skinned.mesh_ = &mesh;
  skinned.joints_ = joints.data();
  skinned.weights_ = weights;
  return Status::kOk;
}

}  // namespace arcspan
