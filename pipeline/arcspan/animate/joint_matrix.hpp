// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/animate/node_matrix.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// The transform by which a joint moves vertices: from their places in the mesh to those in the pose. It has
/// 52 bytes.
class JointMatrix {
 public:
  /// Fraction bits of place(), the position by one joint alone, which is then weighted.
  static constexpr int kPlaceBits = 2;
  /// Fraction bits of normal(), likewise.
  static constexpr int kNormalBits = 13;

  constexpr JointMatrix() = default;
  /// `matrix` in short numbers: with so many fraction bits (5...14) that the sum for any 16-bit position is
  /// below 2^31 in magnitude. Entries are rounded.
  explicit JointMatrix(const NodeMatrix& matrix);

  /// Coordinate `row` of a position in the pose, kPlaceBits fraction bits.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t place(std::size_t row, std::int32_t x, std::int32_t y,
                                                            std::int32_t z) const {
    const Row& m = rows_[row];
    return (m.offset + m.x * x + m.y * y + m.z * z) >> down_;
  }
  /// How far apart coordinates `row` of two places may be whose positions are `length` apart: object units,
  /// rounded up.
  [[nodiscard]] std::int32_t reach(std::size_t row, std::uint16_t length) const;
  /// Component `row` of a normal in the pose, kNormalBits fraction bits. (x, y, z) has 15 fraction bits and
  /// at most unit length; the result is not of unit length.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t normal(std::size_t row, std::int32_t x, std::int32_t y,
                                                             std::int32_t z) const {
    const Row& m = rows_[row];
    return (m.x * x + m.y * y + m.z * z) >> (down_ + (kPlaceBits + 15 - kNormalBits));
  }

 private:
  /// In words, because 16-bit entries take more instructions to load.
  struct Row {
    std::int32_t x;  ///< entries, 16 bits with the sign
    std::int32_t y;
    std::int32_t z;
    std::int32_t offset;  ///< with the fraction bits of the entries, and a half of what is dropped
  };

  Row rows_[3] = {};
  std::int32_t down_ = 0;  ///< fraction bits of the entries, less kPlaceBits
};
static_assert(sizeof(JointMatrix) == 52);

}  // namespace arcspan
