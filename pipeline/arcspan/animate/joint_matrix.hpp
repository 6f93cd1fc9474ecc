// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/animate/node_matrix.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// The transform by which a joint takes vertices from the mesh to the pose; 48 bytes.
class JointMatrix {
 public:
  /// Fraction bits of the entries and of place().
  static constexpr int kBits = 13;
  /// How far from the origin a joint may take a vertex, in object units. place() has room for twice as much,
  /// because the difference between two joints' places must fit, too.
  static constexpr std::int32_t kFarthest = std::int32_t{1} << (31 - kBits - 1);

  constexpr JointMatrix() = default;
  /// `matrix` with kBits fraction bits. Entries are rounded.
  explicit JointMatrix(const NodeMatrix& matrix);

  /// Coordinate `row` of a position in the pose, kBits fraction bits, plus half an object unit: so dropping
  /// the fraction rounds to the nearest unit.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t place(std::size_t row, std::int32_t x, std::int32_t y,
                                                            std::int32_t z) const {
    const Row& m = rows_[row];
    return plus_product(plus_product(plus_product(m.offset, m.x, x), m.y, y), m.z, z);
  }
  /// The most that coordinate `row` in the pose changes when a vertex moves by `length` in the mesh: object
  /// units, rounded up.
  [[nodiscard]] std::int32_t reach(std::size_t row, std::uint16_t length) const;
  /// Component `row` of a normal in the pose, kBits fraction bits more than (x, y, z), not of unit length. It
  /// wraps where it does not fit 32 bits.
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
