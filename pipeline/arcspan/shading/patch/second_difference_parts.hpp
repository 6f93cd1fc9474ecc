// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/target.hpp>

#include <cstdint>
#include <type_traits>

/// Two parts of the second difference along the rows of a patch, from which every row starts.
namespace arcspan {

/// The parts are kept in the command.
struct KeptParts {
  std::int32_t coarse_part;  ///< raw value >> 8
  std::int32_t half_part;    ///< raw value >> 1

  constexpr void set(Cosine second_difference) {
    coarse_part = second_difference.raw() >> 8;
    half_part = second_difference.raw() >> 1;
  }
  [[nodiscard]] constexpr std::int32_t coarse(Cosine) const { return coarse_part; }
  [[nodiscard]] constexpr std::int32_t half(Cosine) const { return half_part; }
};

/// The parts are computed for every row.
struct ComputedParts {
  constexpr void set(Cosine) {}
  [[nodiscard]] constexpr std::int32_t coarse(Cosine second_difference) const {
    return second_difference.raw() >> 8;
  }
  [[nodiscard]] constexpr std::int32_t half(Cosine second_difference) const {
    return second_difference.raw() >> 1;
  }
};

/// Kept on machines with wide registers, because a shift is an instruction of its own on x86-64. Small cores
/// shift while they add, or need the memory.
using SecondDifferenceParts = std::conditional_t<kHasWideRegisters, KeptParts, ComputedParts>;

}  // namespace arcspan
