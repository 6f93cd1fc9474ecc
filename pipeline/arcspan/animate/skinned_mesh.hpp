// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/animate/joint_matrix.hpp>
#include <arcspan/animate/morphed_mesh.hpp>
#include <arcspan/animate/saturated_position.hpp>
#include <arcspan/animate/stored_animation.hpp>
#include <arcspan/mesh/drawable_mesh.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/numbers/direction.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/root.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

/// A mesh whose vertices follow the joints of a skin (DrawableMesh). It holds references, and computes a
/// vertex whenever it is asked for it:
///
///     p = (sum of w_k * ((M_k v) rounded to a quarter of an object unit)) rounded to an object unit
///
/// with the weights w_k in 1024ths, saturated at 16 bits. The normal is the sum of w_k * (M_k n), scaled to
/// unit length; a sum of 0 gives +z. Every core computes the same bits.
///
/// Rest is the mesh as it is before the joints move it: a MeshView, or a MorphedMesh.
template <class Rest>
class BasicSkinnedMesh {
 public:
  /// A mesh without vertices.
  constexpr BasicSkinnedMesh() = default;

  /// Makes a mesh of part `part` of an animated model. `mesh` is that part's; it and `joints`, which
  /// pose_joints() sets for the part's skin, must outlive `skinned`. Returns:
  ///
  ///   kOk                `skinned` is set; otherwise it is not changed
  ///   kInvalidArgument   the part follows no joint of the animation, or has another number of vertices
  ///   kBufferTooSmall    there are fewer `joints` than the part's skin has
  [[nodiscard]] static Status make(const Rest& mesh, const StoredAnimation& animation, std::size_t part,
                                   std::span<const JointMatrix> joints, BasicSkinnedMesh& skinned);

  [[nodiscard]] constexpr const MeshView& view() const { return mesh_->view(); }
  /// Position of vertex i, which must be below view().vertex_count(), in the pose.
  [[nodiscard]] ARCSPAN_INLINE ObjectPosition position(std::size_t i) const;
  /// Unit normal of vertex i in the pose.
  [[nodiscard]] ARCSPAN_INLINE Direction direction(std::size_t i) const;

 private:
  static constexpr Rest kNoMesh{};

  const Rest* mesh_ = &kNoMesh;
  const JointMatrix* joints_ = nullptr;
  StoredWeights weights_;
};

/// A mesh in flash that follows joints.
using SkinnedMesh = BasicSkinnedMesh<MeshView>;
/// One that morph targets change before.
using MorphedSkinnedMesh = BasicSkinnedMesh<MorphedMesh>;

namespace detail {

/// A vector along the normal of vertex i, 15 fraction bits, of at most unit length.
[[nodiscard]] ARCSPAN_INLINE inline OctahedralPoint long_normal(const MeshView& mesh, std::size_t i) {
  return octahedral_point(mesh.normal(i));
}
[[nodiscard]] inline OctahedralPoint long_normal(const MorphedMesh& mesh, std::size_t i) {
  const Direction n = mesh.direction(i);
  return {n.x.raw(), n.y.raw(), n.z.raw()};
}

/// Sums of three coordinates.
struct WeightedSum {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t z = 0;
};

/// The sum over the joints of a record of chunk WGHT: of coordinates(joint, row) times the weight in 1024ths.
/// It wraps where a position is far out of range.
template <class Coordinates>
[[nodiscard]] ARCSPAN_INLINE inline WeightedSum weighted_sum(const std::uint16_t* words,
                                                             const JointMatrix* joints,
                                                             const Coordinates& coordinates) {
  WeightedSum sum;
  const auto add = [&](std::uint32_t word, std::int32_t weight) {
    const JointMatrix& joint = joints[word & 0xFFu];
    sum.x = wrap_add(sum.x, wrap_mul(coordinates(joint, 0), weight));
    sum.y = wrap_add(sum.y, wrap_mul(coordinates(joint, 1), weight));
    sum.z = wrap_add(sum.z, wrap_mul(coordinates(joint, 2), weight));
  };
  const std::uint32_t first = *words;
  std::int32_t left = 1 << animation_binary::kWeightBits;
  const auto add_one = [&](std::uint32_t k) {
    const std::uint32_t word = words[k];
    const auto weight = static_cast<std::int32_t>(((word >> 8) << 2) | ((first >> (8 + 2 * k)) & 3u));
    left -= weight;
    add(word, weight);
  };
  std::uint32_t others = (first >> 8) & 3u;
  if (others == 1) {  // the most frequent case keeps everything in registers
    add_one(1);
  } else {
    for (; others != 0; --others) add_one(others);
  }
  add(first, left);
  return sum;
}

/// The unit vector along a sum of weighted normals; +z for a sum of 0. Nearly all are 1/2...1 long, because
/// the vectors that joints turn are 0.57...1 long: the table of roots serves these, normalised() the others.
[[nodiscard]] ARCSPAN_INLINE inline Direction unit_normal(const WeightedSum& sum) {
  constexpr int kBits = JointMatrix::kNormalBits + animation_binary::kWeightBits;
  const auto above = [](std::int32_t c) {
    return static_cast<std::uint32_t>(c) + (std::uint32_t{1} << kBits);
  };
  if (((above(sum.x) | above(sum.y) | above(sum.z)) >> (kBits + 1)) == 0) [[likely]] {
    const std::int32_t x = sum.x >> (kBits - 15);
    const std::int32_t y = sum.y >> (kBits - 15);
    const std::int32_t z = sum.z >> (kBits - 15);
    const auto square = [](std::int32_t c) { return static_cast<std::uint32_t>(c * c); };
    const std::uint32_t n30 = square(x) + square(y) + square(z);  // at most 3 * 2^30
    if (has_tabled_root(n30)) [[likely]] {
      const auto scale = static_cast<std::int32_t>(tabled_reciprocal_root(n30));
      const auto unit = [scale](std::int32_t c) {
        return DirectionComponent::from_raw(round_shift(c * scale, 15));
      };
      return {unit(x), unit(y), unit(z)};
    }
  }
  return normalised(sum.x, sum.y, (sum.x | sum.y | sum.z) == 0 ? 1 : sum.z);
}

}  // namespace detail

template <class Rest>
ARCSPAN_INLINE inline ObjectPosition BasicSkinnedMesh<Rest>::position(std::size_t i) const {
  const ObjectPosition& v = mesh_->position(i);  // a copy would be a call of memcpy() on Armv6-M
  const std::int32_t x = v.x;
  const std::int32_t y = v.y;
  const std::int32_t z = v.z;
  const detail::WeightedSum sum = detail::weighted_sum(
      weights_.record(i), joints_,
      [=](const JointMatrix& joint, std::size_t row) { return joint.place(row, x, y, z); });
  constexpr int kDown = JointMatrix::kPlaceBits + animation_binary::kWeightBits;
  return detail::saturated_position(round_shift(sum.x, kDown), round_shift(sum.y, kDown),
                                    round_shift(sum.z, kDown));
}

template <class Rest>
ARCSPAN_INLINE inline Direction BasicSkinnedMesh<Rest>::direction(std::size_t i) const {
  const detail::OctahedralPoint n = detail::long_normal(*mesh_, i);
  // As long as no joint scales by 128 or more, each product is below 2^30, and so is the sum, because the
  // weights add up to 1024. Otherwise the sum wraps.
  const detail::WeightedSum sum = detail::weighted_sum(
      weights_.record(i), joints_,
      [n](const JointMatrix& joint, std::size_t row) { return joint.normal(row, n.x, n.y, n.z); });
  return detail::unit_normal(sum);
}

template <class Rest>
Status BasicSkinnedMesh<Rest>::make(const Rest& mesh, const StoredAnimation& animation, std::size_t part,
                                    std::span<const JointMatrix> joints, BasicSkinnedMesh& skinned) {
  const StoredWeights weights = animation.weights(part);
  if (!weights.exist() ||
      (!weights.are_of_one_joint() && weights.vertex_count() != mesh.view().vertex_count()))
    return Status::kInvalidArgument;
  if (joints.size() < animation.skin(weights.skin()).size()) return Status::kBufferTooSmall;
  skinned.mesh_ = &mesh;
  skinned.joints_ = joints.data();
  skinned.weights_ = weights;
  return Status::kOk;
}

static_assert(DrawableMesh<SkinnedMesh> && DrawableMesh<MorphedSkinnedMesh> && DrawableMesh<MorphedMesh>);

}  // namespace arcspan
