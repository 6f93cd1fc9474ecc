// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/literature/dichotomy.hpp>

/// Every variant of dichotomy that S3 gives figures for and that the command does not offer:
/// `entry(name, Class)`.
#define ARCSPAN_FOR_EACH_DICHOTOMY_VARIANT(entry)                                   \
  entry("dichotomy-root4", DichotomyRoot4) entry("dichotomy-root8", DichotomyRoot8) \
      entry("dichotomy-linear4", DichotomyLinear4) entry("dichotomy-linear16", DichotomyLinear16)

namespace arcspan {

/// 1/sqrt(2 + z) itself, by root and division, as S3 has it before it puts a polynomial there.
struct RootItself {
  [[nodiscard]] static constexpr std::int32_t above_half(std::uint32_t s) {
    const ReciprocalRoot root = reciprocal_root(((4u << 16) - s) << 12);  // 1/sqrt(28 fraction bits)
    const std::uint32_t p = root.mantissa << (32 - root.exponent);
    return p < (1u << 17) ? 0 : static_cast<std::int32_t>(p - (1u << 17));
  }
};

template <class Illumination>
using DichotomyRoot4 = Dichotomy<Illumination, RootItself, 2>;
template <class Illumination>
using DichotomyRoot8 = Dichotomy<Illumination, RootItself, 3>;
template <class Illumination>
using DichotomyLinear4 = Dichotomy<Illumination, LinearPolynomial, 2>;
template <class Illumination>
using DichotomyLinear16 = Dichotomy<Illumination, LinearPolynomial, 4>;

}  // namespace arcspan
