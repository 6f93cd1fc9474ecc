// SPDX-License-Identifier: MIT
#include <arcspan/animate/joint_matrix.hpp>
#include <arcspan/numbers/root.hpp>

namespace arcspan {

JointMatrix::JointMatrix(const NodeMatrix& matrix) {
  constexpr int kDown = animation_binary::kMatrixBits - kBits;
  constexpr std::int32_t kHalf = std::int32_t{1} << (kBits - 1);
  for (std::size_t i = 0; i < 3; ++i) {
    // The sum before the shift would wrap.
    const auto entry = [&](std::size_t j) { return ((matrix.entries[i][j] >> (kDown - 1)) + 1) >> 1; };
    const std::int32_t offset = wrap_shl(matrix.offset[i].raw(), kBits - ObjectLength::kFraction);
    rows_[i] = {entry(0), entry(1), entry(2), wrap_add(offset, kHalf)};
  }
}

std::int32_t JointMatrix::reach(std::size_t row, std::uint16_t length) const {
  const Row& m = rows_[row];
  const auto square = [](std::int32_t c) { return static_cast<std::uint64_t>(std::int64_t{c} * c); };
  const std::uint64_t sum = square(m.x) + square(m.y) + square(m.z);
  const std::uint64_t most = wide_integer_root(sum) + 1;  // at most 2^21
  return static_cast<std::int32_t>((most * length) >> kBits) + 1;
}

}  // namespace arcspan
