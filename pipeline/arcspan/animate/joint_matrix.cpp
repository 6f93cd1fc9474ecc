// SPDX-License-Identifier: MIT
#include <arcspan/animate/joint_matrix.hpp>
#include <arcspan/numbers/root.hpp>

#include <bit>

namespace arcspan {

namespace {

constexpr int kEntryBits = animation_binary::kMatrixBits;
constexpr int kMostBits = 14;

std::uint32_t magnitude(std::int32_t v) {
  return v < 0 ? 0u - static_cast<std::uint32_t>(v) : static_cast<std::uint32_t>(v);
}

/// Fraction bits with which each entry fits 16 bits, and each row times a position plus its offset 32 bits.
int fraction_bits(const NodeMatrix& matrix) {
  std::uint32_t entries = 0;
  std::uint64_t rows = 0;  // with kEntryBits fraction bits
  for (std::size_t i = 0; i < 3; ++i) {
    std::uint64_t row = std::uint64_t{magnitude(matrix.offset[i].raw())}
                        << (kEntryBits - ObjectLength::kFraction);
    for (const std::int32_t entry : matrix.entries[i]) {
      entries |= magnitude(entry);
      row += std::uint64_t{magnitude(entry)} << 15;
    }
    rows |= row;
  }
  const int by_entry = kEntryBits + 15 - static_cast<int>(std::bit_width(entries));
  const int by_row = kEntryBits + 30 - static_cast<int>(std::bit_width(rows));
  const int bits = by_entry < by_row ? by_entry : by_row;
  return bits < kMostBits ? bits : kMostBits;
}

/// `entry` with `down` fraction bits fewer, rounded. Only rounding can lead out of 16 bits.
std::int32_t short_entry(std::int32_t entry, int down) {
  const std::int64_t rounded = (std::int64_t{entry} + (std::int64_t{1} << (down - 1))) >> down;
  return rounded > 32767 ? 32767 : static_cast<std::int32_t>(rounded);
}

}  // namespace

JointMatrix::JointMatrix(const NodeMatrix& matrix) {
  const int bits = fraction_bits(matrix);
  down_ = bits - kPlaceBits;
  const std::int64_t half = std::int64_t{1} << (down_ - 1);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto entry = [&](std::size_t j) { return short_entry(matrix.entries[i][j], kEntryBits - bits); };
    const std::int64_t offset = std::int64_t{matrix.offset[i].raw()} * (std::int64_t{1} << bits);
    rows_[i] = {entry(0), entry(1), entry(2),
                static_cast<std::int32_t>((offset >> ObjectLength::kFraction) + half)};
  }
}

std::int32_t JointMatrix::reach(std::size_t row, std::uint16_t length) const {
  const Row& m = rows_[row];
  const auto square = [](std::int32_t c) { return static_cast<std::uint32_t>(c * c); };  // at most 2^30
  const std::uint32_t most = integer_root(square(m.x) + square(m.y) + square(m.z)) + 1;  // at most 56757
  return static_cast<std::int32_t>((most * length) >> (down_ + kPlaceBits)) + 1;
}

}  // namespace arcspan
