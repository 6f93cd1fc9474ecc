// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/animate/skinned_mesh.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan::c {

/// The vertices of a part of a character, moved by joints, by morph targets or by both (DrawableMesh). One
/// type for all, because each that is drawn compiles the drawing code once more.
class CharacterMesh {
 public:
  CharacterMesh() = default;
  CharacterMesh(const CharacterMesh&) = delete;  // it refers to itself
  CharacterMesh& operator=(const CharacterMesh&) = delete;

  /// Of part `part`, which joints or morph targets of `animation` move; the status is that of the meshes'
  /// make(). What is given must outlive it.
  [[nodiscard]] Status make(const MeshView& rest, const StoredAnimation& animation, std::size_t part,
                            std::span<const JointMatrix> joints, std::span<const std::int16_t> weights);

  [[nodiscard]] const MeshView& view() const { return *rest_; }
  [[nodiscard]] ObjectPosition position(std::size_t i) const;
  [[nodiscard]] Direction direction(std::size_t i) const;

 private:
  const MeshView* rest_ = nullptr;
  bool follows_joints_ = false;
  bool is_morphed_ = false;
  MorphedMesh morphed_;
  SkinnedMesh skinned_;
  MorphedSkinnedMesh morphed_skinned_;
};

static_assert(DrawableMesh<CharacterMesh>);

}  // namespace arcspan::c
