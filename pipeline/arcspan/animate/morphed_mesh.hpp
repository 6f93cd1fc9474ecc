// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/animate/stored_animation.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/numbers/direction.hpp>
#include <arcspan/status.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

/// A mesh whose vertices are moved by morph targets (DrawableMesh). It holds references, and computes a
/// vertex whenever it is asked for it:
///
///     p = v + sum of weight * what the target adds, rounded once and saturated at 16 bits
///
/// Normals likewise, then scaled to unit length; a sum of 0 gives +z. Every core computes the same bits.
class MorphedMesh {
 public:
  /// A mesh without vertices.
  constexpr MorphedMesh() = default;

  /// Makes a mesh of part `part` of an animated model. `mesh` is that part's; it and `weights`, which
  /// pose_morph() sets, must outlive `morphed`. Returns:
  ///
  ///   kOk                `morphed` is set; otherwise it is not changed
  ///   kInvalidArgument   the part has no morph targets, or `mesh` has another number of vertices
  ///   kBufferTooSmall    there are fewer `weights` than the part has targets
  [[nodiscard]] static Status make(const MeshView& mesh, const StoredAnimation& animation, std::size_t part,
                                   std::span<const std::int16_t> weights, MorphedMesh& morphed);

  [[nodiscard]] constexpr const MeshView& view() const { return *mesh_; }
  /// Position of vertex i, which must be below view().vertex_count().
  [[nodiscard]] ObjectPosition position(std::size_t i) const;
  /// Unit normal of vertex i.
  [[nodiscard]] Direction direction(std::size_t i) const;

 private:
  static constexpr MeshView kNoMesh{};

  const MeshView* mesh_ = &kNoMesh;
  const std::int16_t* weights_ = nullptr;
  StoredMorph morph_;
};

}  // namespace arcspan
