// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/target.hpp>

#include <cstdint>
#include <type_traits>

namespace arcspan::detail {

/// An entry of a matrix, below 2^28 in magnitude, for cores whose 64-bit sums of products are cheap.
struct WholeEntry {
  std::int32_t raised;  ///< times 2^3, so that scaled_sum() needs the upper half of a sum only

  WholeEntry() = default;
  constexpr explicit WholeEntry(std::int32_t entry) : raised(entry * (1 << kRaise)) {}
  [[nodiscard]] constexpr std::int64_t value() const { return raised >> kRaise; }
  static constexpr int kRaise = 3;
  friend constexpr bool operator==(const WholeEntry&, const WholeEntry&) = default;
};

/// The same as high * 2^14 + low: `high` has 15 bits with the sign and `low` 14, so that sums of three
/// products with 16-bit positions fit 32 bits.
struct SplitEntry {
  std::int32_t high;
  std::int32_t low;

  SplitEntry() = default;
  constexpr explicit SplitEntry(std::int32_t entry) : high(entry >> 14), low(entry & 0x3FFF) {}
  [[nodiscard]] constexpr std::int64_t value() const { return std::int64_t{high} * (1 << 14) + low; }
  friend constexpr bool operator==(const SplitEntry&, const SplitEntry&) = default;
};

using MatrixEntry = std::conditional_t<kHasLongSums, WholeEntry, SplitEntry>;

/// Returns the product of a row and a position, divided by 2^14 and rounded down, modulo 2^32. Both functions
/// return the same bits.
[[nodiscard]] constexpr std::int32_t scaled_sum(const WholeEntry (&row)[3], ObjectPosition p) {
  const auto product = [](const WholeEntry& entry, std::int32_t coordinate) {
    return std::int64_t{entry.raised} *
           (coordinate * (std::int32_t{1} << (32 - 14 - WholeEntry::kRaise)));  // up to 2^61
  };
  return static_cast<std::int32_t>((product(row[0], p.x) + product(row[1], p.y) + product(row[2], p.z)) >>
                                   32);
}
[[nodiscard]] constexpr std::int32_t scaled_sum(const SplitEntry (&row)[3], ObjectPosition p) {
  const std::int32_t high =
      wrap_add(wrap_add(wrap_mul(row[0].high, p.x), wrap_mul(row[1].high, p.y)), wrap_mul(row[2].high, p.z));
  const std::int32_t low = row[0].low * p.x + row[1].low * p.y + row[2].low * p.z;
  return wrap_add(high, low >> 14);
}

}  // namespace arcspan::detail
