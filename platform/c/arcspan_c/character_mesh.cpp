// SPDX-License-Identifier: MIT
#include <arcspan_c/character_mesh.hpp>

namespace arcspan::c {

Status CharacterMesh::make(const MeshView& rest, const StoredAnimation& animation, std::size_t part,
                           std::span<const JointMatrix> joints, std::span<const std::int16_t> weights) {
  rest_ = &rest;
  follows_joints_ = animation.weights(part).exist();
  is_morphed_ = animation.morph(part).target_count() != 0;
  Status status = Status::kOk;
  if (is_morphed_) status = MorphedMesh::make(rest, animation, part, weights, morphed_);
  if (!ok(status) || !follows_joints_) return status;
  return is_morphed_ ? MorphedSkinnedMesh::make(morphed_, animation, part, joints, morphed_skinned_)
                     : SkinnedMesh::make(rest, animation, part, joints, skinned_);
}

ObjectPosition CharacterMesh::position(std::size_t i) const {
  if (!follows_joints_) return morphed_.position(i);
  return is_morphed_ ? morphed_skinned_.position(i) : skinned_.position(i);
}

Direction CharacterMesh::direction(std::size_t i) const {
  if (!follows_joints_) return morphed_.direction(i);
  return is_morphed_ ? morphed_skinned_.direction(i) : skinned_.direction(i);
}

}  // namespace arcspan::c
