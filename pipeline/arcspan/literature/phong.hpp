// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/literature/linear_normal_method.hpp>
#include <arcspan/target.hpp>

namespace arcspan {

namespace detail {

/// n / |n| by a root bit by bit and three divisions, as S0 counts it. Components have 15 fraction bits; the
/// zero vector stays zero.
struct UnitByDivision {
  [[nodiscard]] static constexpr Direction of(std::int32_t x, std::int32_t y, std::int32_t z) {
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

/// n / |n| by one reciprocal root and three multiplies, without a loop or a division. Components have 15
/// fraction bits and a magnitude below 1; the relative error is at most 2^-15, and half a unit is rounded
/// away. The zero vector stays zero.
struct UnitByReciprocalRoot {
  [[nodiscard]] static constexpr Direction of(std::int32_t x, std::int32_t y, std::int32_t z) {
    const std::int32_t square = wrap_add(wrap_add(wrap_mul(x, x), wrap_mul(y, y)), wrap_mul(z, z));
    // Setting bit 2 keeps the shift below positive; it adds 2^-28 to |n|^2.
    const ReciprocalRoot root = reciprocal_root(static_cast<std::uint32_t>(square) | 4u);
    // c / |n| = c mantissa 2^-exponent has no fraction bits; 15 are wanted. The product is below 2^31.
    const auto scaled = [&root](std::int32_t c) {
      const std::int32_t product = wrap_mul(c, static_cast<std::int32_t>(root.mantissa >> 1));
      return DirectionComponent::from_raw(round_shift(product, root.exponent - 16));
    };
    return {scaled(x), scaled(y), scaled(z)};
  }
};

/// The colour of a linear normal: the illumination of that normal divided by its length.
template <class Unit>
struct NormalisedColour {
  template <class Illumination>
  [[nodiscard]] ARCSPAN_INLINE static constexpr PackedRgb colour(const Illumination& illumination,
                                                                 const LinearNormal& n) {
    return illumination.colour(illumination.scalars(Unit::of(round_shift(n.x.raw(), Linear::kFraction),
                                                             round_shift(n.y.raw(), Linear::kFraction),
                                                             round_shift(n.z.raw(), Linear::kFraction))));
  }
};

}  // namespace detail

/// Classic Phong shading (S0 [2]), for comparison. The normal is interpolated linearly on the screen. Each
/// pixel normalises it by a root and three divisions, then takes the products with L, H or V and the power.
/// The other methods exist to avoid these divisions in the span stage.
template <class Illumination>
struct Phong : LinearNormalMethod<Illumination, detail::NormalisedColour<detail::UnitByDivision>> {};

/// Phong as one would write it today: a reciprocal root (a table-free polynomial and two Newton steps) and
/// three multiplies in place of the root and the divisions. Apart from rounding the picture is that of Phong.
template <class Illumination>
struct PhongReciprocal
    : LinearNormalMethod<Illumination, detail::NormalisedColour<detail::UnitByReciprocalRoot>> {};

}  // namespace arcspan
