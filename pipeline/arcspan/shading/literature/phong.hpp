// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/shading/literature/linear_normal_method.hpp>
#include <arcspan/target.hpp>

namespace arcspan {

namespace detail {

/// The colour of a linear normal: the illumination of that normal divided by its length.
struct NormalisedColour {
  template <class Illumination>
  [[nodiscard]] ARCSPAN_INLINE static constexpr PackedRgb colour(const Illumination& illumination,
                                                                 const LinearNormal& n) {
    return illumination.colour(illumination.scalars(normalised_by_division(n)));
  }

 private:
  /// n / |n|, components with 15 fraction bits; the zero vector stays zero.
  [[nodiscard]] static constexpr Direction normalised_by_division(const LinearNormal& n) {
    const std::int32_t x = round_shift(n.x.raw(), Linear::kFraction);
    const std::int32_t y = round_shift(n.y.raw(), Linear::kFraction);
    const std::int32_t z = round_shift(n.z.raw(), Linear::kFraction);
    const std::int32_t square = wrap_add(wrap_add(wrap_mul(x, x), wrap_mul(y, y)), wrap_mul(z, z));
    const auto root = static_cast<std::int32_t>(nearest_root(static_cast<std::uint32_t>(square)));
    const std::int32_t length = root + static_cast<std::int32_t>(root == 0);
    const auto divided = [length](std::int32_t c) {
      const std::int32_t half = c < 0 ? -(length >> 1) : length >> 1;
      return DirectionComponent::from_raw(wrap_add(wrap_shl(c, 15), half) / length);
    };
    return {divided(x), divided(y), divided(z)};
  }
};

}  // namespace detail

/// Classic Phong shading (S0 [2]), for comparison. The normal is interpolated linearly on the screen. Each
/// pixel normalises it by a root and three divisions, then takes the products with L, H or V and the power.
/// The other methods exist to avoid these divisions in the span stage.
template <class Illumination>
struct Phong : LinearNormalMethod<Illumination, detail::NormalisedColour> {};

}  // namespace arcspan
