// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// The quadruple sagitta of an edge divided by the mean of its two values: 4 (1 / cos(psi/2) - 1).
using SagittaFactor = Fixed<std::int32_t, 18>;

/// Returns the factor of an edge with the squared chord s = `chord` (28 fraction bits) by the series
/// s/2 + 3/32 s^2 + 5/256 s^3. s is at most 0.33 (33 degrees), where the factor is below 0.18.
[[nodiscard]] ARCSPAN_INLINE constexpr SagittaFactor sagitta_factor(std::uint32_t chord) {
  const std::uint32_t s = chord >> 13;                         // 15 fraction bits
  const std::uint32_t inner = 3072u + ((s * 5u + 128u) >> 8);  // 3/32 + 5/256 s, 15 fraction bits
  return SagittaFactor::from_raw(
      static_cast<std::int32_t>(((chord + 1024) >> 11) + (((s * s) >> 12) * inner >> 15)));
}

/// Returns a factor of edges with s up to 1 (60 degrees) for surfaces without a highlight, 16 fraction bits:
/// s/2 + 0.11 s^2 + 0.035 s^3. It is above sagitta_factor() so that the surface's error has both signs.
[[nodiscard]] constexpr std::int32_t balanced_sagitta_factor(std::uint32_t chord) {
  const std::uint32_t s = chord >> 13;                         // 15 fraction bits
  const std::uint32_t inner = 3604u + ((s * 9u + 128u) >> 8);  // 0.11 + 0.035 s, 15 fraction bits
  return static_cast<std::int32_t>(((chord + 4096) >> 13) + (((s * s) >> 14) * inner >> 15));
}

/// The sagitta factors of a triangle's edges; all its scalars share them.
struct EdgeSagittaFactors {
  SagittaFactor top_middle;
  SagittaFactor top_bottom;
  SagittaFactor middle_bottom;
};

[[nodiscard]] constexpr EdgeSagittaFactors sagitta_factors_of(const TriangleChords& chords) {
  return {sagitta_factor(chords.top_middle), sagitta_factor(chords.top_bottom),
          sagitta_factor(chords.middle_bottom)};
}

}  // namespace arcspan
