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

namespace detail {

inline constexpr int kNormalDown = 15 - JointMatrix::kBits;

/// A vector along the normal of vertex i, of at most unit length. It has JointMatrix::kBits fraction bits,
/// which leaves room in 32 bits for joints that scale it.
[[nodiscard]] ARCSPAN_INLINE inline OctahedralPoint long_normal(const MeshView& mesh, std::size_t i) {
  return octahedral_point<kNormalDown>(mesh.normal(i));
}
[[nodiscard]] inline OctahedralPoint long_normal(const MorphedMesh& mesh, std::size_t i) {
  const Direction n = mesh.direction(i);
  return {n.x.raw() >> kNormalDown, n.y.raw() >> kNormalDown, n.z.raw() >> kNormalDown};
}

/// Three coordinates.
struct WeightedSum {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t z = 0;
};

/// The sum over the joints of a record of chunk WGHT: of coordinates(joint, row) times the weight in 1024ths,
/// which add up to 1. It wraps where coordinates do.
template <class Coordinates>
[[nodiscard]] ARCSPAN_INLINE inline WeightedSum weighted_sum(const std::uint16_t* words,
                                                             const JointMatrix* joints,
                                                             const Coordinates& coordinates) {
  constexpr int kDown = animation_binary::kWeightBits;
  const std::uint32_t first = *words;
  const std::uint32_t others = (first >> 8) & 3u;
  const JointMatrix& joint = joints[first & 0xFFu];
  const auto weight = [=](std::uint32_t k) {
    return static_cast<std::int32_t>(((std::uint32_t{words[k]} >> 8) << 2) | ((first >> (8 + 2 * k)) & 3u));
  };
  const auto other = [=](std::uint32_t k) -> const JointMatrix& { return joints[words[k] & 0xFFu]; };
  if (others == 1) [[likely]] {  // the most frequent case, row by row, keeps everything in registers
    const JointMatrix* const from = hidden(&joint);  // gcc would compute rows for all cases beforehand
    const JointMatrix& to = other(1);
    const std::int32_t w = weight(1);
    const auto between = [&](std::size_t row) {
      const std::int32_t c = coordinates(*from, row);
      return wrap_add(c, wrap_mul(wrap_sub(coordinates(to, row), c) >> kDown, w));
    };
    const std::int32_t x = between(0);
    const std::int32_t y = between(1);
    return {x, y, between(2)};
  }
  if (others == 0) return {coordinates(joint, 0), coordinates(joint, 1), coordinates(joint, 2)};
  WeightedSum sum;
  std::int32_t left = 1 << kDown;
  const auto add = [&](const JointMatrix& m, std::int32_t w) {
    sum.x = wrap_add(sum.x, wrap_mul(coordinates(m, 0) >> kDown, w));
    sum.y = wrap_add(sum.y, wrap_mul(coordinates(m, 1) >> kDown, w));
    sum.z = wrap_add(sum.z, wrap_mul(coordinates(m, 2) >> kDown, w));
  };
  for (std::uint32_t k = others; k != 0; --k) {
    const std::int32_t w = weight(k);
    left -= w;
    add(other(k), w);
  }
  add(joint, left);
  return sum;
}

/// The unit vector along a sum of weighted normals; +z for a sum of 0. Nearly all are 1/2...1 long, because
/// the vectors that joints turn are 0.57...1 long: these need no scaling before the root is looked up.
[[nodiscard]] ARCSPAN_INLINE inline Direction unit_normal(const WeightedSum& sum) {
  constexpr int kDown = 2 * JointMatrix::kBits - 15;
  const std::int32_t x = sum.x >> kDown;
  const std::int32_t y = sum.y >> kDown;
  const std::int32_t z = sum.z >> kDown;
  const auto above = [](std::int32_t c) { return static_cast<std::uint32_t>(c) + 32768u; };
  if ((above(x) | above(y) | above(z)) < 65536) [[likely]] {
    const auto square = [](std::int32_t c) { return static_cast<std::uint32_t>(c * c); };
    const std::uint32_t n30 = square(x) + square(y) + square(z);  // at most 3 * 2^30
    if (has_tabled_root(n30)) [[likely]] {
      const auto scale = static_cast<std::int32_t>(tabled_reciprocal_root(n30));
      const auto unit = [scale](std::int32_t c) { return DirectionComponent::from_raw((c * scale) >> 15); };
      return {unit(x), unit(y), unit(z)};
    }
  }
  return nearly_normalised(sum.x, sum.y, (sum.x | sum.y | sum.z) == 0 ? 1 : sum.z);
}

}  // namespace detail

/// A mesh whose vertices follow the joints of a skin (DrawableMesh). It holds references, and computes a
/// vertex whenever it is asked for it:
///
///     p = sum of w_k * (M_k v)
///
/// with the rounded matrices M_k and the weights w_k in 1024ths. The sum is off by less than 1/8 of an object
/// unit; it is rounded to a whole unit and saturated at 16 bits. The position is wrong, because sums wrap,
/// where a joint alone would take the vertex farther than JointMatrix::kFarthest. The normal is the sum of
/// w_k * (M_k n), scaled to unit length; a sum of 0 gives +z. The normal is wrong where joints scale by 16 or
/// more. Every core computes the same bits.
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

  [[nodiscard]] constexpr const MeshView& view() const { return mesh_->view(); }
  /// Position of vertex i, which must be below view().vertex_count(), in the pose.
  [[nodiscard]] ARCSPAN_INLINE ObjectPosition position(std::size_t i) const {
    const ObjectPosition& v = mesh_->position(i);  // a copy would be a call of memcpy() on Armv6-M
    const std::int32_t x = v.x;
    const std::int32_t y = v.y;
    const std::int32_t z = v.z;
    const detail::WeightedSum sum = detail::weighted_sum(
        weights_.record(i), joints_,
        [=](const JointMatrix& joint, std::size_t row) { return joint.place(row, x, y, z); });
    return detail::saturated_position<JointMatrix::kBits>(sum.x, sum.y, sum.z);
  }
  /// Unit normal of vertex i in the pose.
  [[nodiscard]] ARCSPAN_INLINE Direction direction(std::size_t i) const {
    const detail::OctahedralPoint n = detail::long_normal(*mesh_, i);
    const detail::WeightedSum sum = detail::weighted_sum(
        weights_.record(i), joints_,
        [n](const JointMatrix& joint, std::size_t row) { return joint.normal(row, n.x, n.y, n.z); });
    return detail::unit_normal(sum);
  }

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

static_assert(DrawableMesh<SkinnedMesh> && DrawableMesh<MorphedSkinnedMesh> && DrawableMesh<MorphedMesh>);

}  // namespace arcspan
