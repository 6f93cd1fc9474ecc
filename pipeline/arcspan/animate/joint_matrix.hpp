// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/animate/node_matrix.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// The transform by which a joint moves vertices: from their places in the mesh to those in the pose. It has
/// 48 bytes.
class JointMatrix {
 public:
  /// Fraction bits of the entries and of place().
  static constexpr int kBits = 13;
  /// place() is exact up to so many object units, and wraps beyond twice as many.
  static constexpr std::int32_t kFarthest = std::int32_t{1} << (31 - kBits - 1);

  constexpr JointMatrix() = default;
  /// `matrix` with kBits fraction bits. Entries are rounded.
  explicit JointMatrix(const NodeMatrix& matrix);

  /// Coordinate `row` of a position in the pose, and half an object unit, which rounds it when the fraction
  /// is dropped.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t place(std::size_t row, std::int32_t x, std::int32_t y,
                                                            std::int32_t z) const {
    const Row& m = rows_[row];
    return plus_product(plus_product(plus_product(m.offset, m.x, x), m.y, y), m.z, z);
  }
  /// How far apart coordinates `row` of two places may be whose positions are `length` apart: object units,
  /// rounded up.
  [[nodiscard]] std::int32_t reach(std::size_t row, std::uint16_t length) const;
  /// Component `row` of a normal in the pose: it has kBits fraction bits more than (x, y, z). The result is
  /// not of unit length, and wraps.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t normal(std::size_t row, std::int32_t x, std::int32_t y,
                                                             std::int32_t z) const {
    const Row& m = rows_[row];
    return plus_product(plus_product(wrap_mul(m.x, x), m.y, y), m.z, z);
  }

 private:
  /// In words, because 16-bit entries take more instructions to load.
  struct Row {
    std::int32_t x;
    std::int32_t y;
    std::int32_t z;
    std::int32_t offset;  ///< with half an object unit
  };

  Row rows_[3] = {};
};
static_assert(sizeof(JointMatrix) == 48);

}  // namespace arcspan
