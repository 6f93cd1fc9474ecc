// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/adaptive/linear_light.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// Returns an upper bound of the squared radius of the smallest circle around the three normals, which are
/// at most 16 degrees apart; 28 fraction bits, of which 25 are used. The circle passes through all three,
/// or has the widest edge as its diameter if the triangle of the normals is obtuse.
///
/// With c the longest chord and e = max(0, a^2 + b^2 - c^2), the squared radius is at most c^2/4 + e/12.
[[nodiscard]] constexpr std::uint32_t squared_radius(const TriangleChords& chords) {
  const std::uint32_t widest = chords.widest();
  const std::uint32_t others = chords.top_middle + chords.top_bottom + chords.middle_bottom - widest;
  const std::uint32_t excess = others > widest ? others - widest : 0;
  // The last term, about 4%, covers the higher terms at 16 degrees.
  return (widest >> 2) + (excess >> 3) - (excess >> 5) + (widest >> 6);
}

/// N·L at the vertices of a triangle whose normals are at most 16 degrees apart, and what follows for
/// linear light.
struct LinearLevels {
  std::int32_t a;  ///< LinearLight::level()
  std::int32_t b;
  std::int32_t c;
  std::uint32_t radius2;  ///< squared_radius() of the normals

  ARCSPAN_INLINE constexpr LinearLevels(const TriangleChords& chords, Cosine at_a, Cosine at_b, Cosine at_c)
      : a(LinearLight::level(at_a)),
        b(LinearLight::level(at_b)),
        c(LinearLight::level(at_c)),
        radius2(squared_radius(chords)) {}

  [[nodiscard]] constexpr std::int32_t most() const {
    const std::int32_t upper = a > b ? a : b;
    return upper > c ? upper : c;
  }
  [[nodiscard]] constexpr std::uint32_t range() const {
    const std::int32_t lower = a < b ? a : b;
    return static_cast<std::uint32_t>(most() - (lower < c ? lower : c));
  }
  /// Returns a bound of four times the error of linear light, 28 fraction bits: R^2 N·L with the largest
  /// N·L. Where N·L is positive, it is above the plane through its vertices by at most R^2/2 of itself and
  /// never below; lifting the plane by R^2/4 leaves R^2/4 either way.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t quadruple_error() const {
    if (most() <= 0) return 0;
    return (radius2 >> 9) * ((static_cast<std::uint32_t>(most()) >> 6) + 1);
  }
  /// Returns a level of the lifted plane.
  [[nodiscard]] constexpr std::int32_t lifted(std::int32_t level) const {
    const auto lift = static_cast<std::int32_t>(radius2 >> (28 - LinearLight::kFraction + 2));
    return level + (wrap_mul(level, lift) >> LinearLight::kFraction);
  }
};

}  // namespace arcspan
