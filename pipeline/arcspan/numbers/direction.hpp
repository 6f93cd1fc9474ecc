// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/root.hpp>
#include <arcspan/target.hpp>

#include <bit>
#include <cstdint>

namespace arcspan {

/// A unit vector for dot products, 15 fraction bits per component.
struct Direction {
  DirectionComponent x;
  DirectionComponent y;
  DirectionComponent z;

  friend constexpr bool operator==(const Direction&, const Direction&) = default;
};

/// A unit vector as vertices carry it, for the angles between normals: 14 fraction bits per component, in
/// 16-bit words.
struct Normal {
  NormalComponent x;
  NormalComponent y;
  NormalComponent z;

  friend constexpr bool operator==(const Normal&, const Normal&) = default;
};

[[nodiscard]] constexpr Direction operator-(const Direction& v) { return {-v.x, -v.y, -v.z}; }

/// a · b of unit vectors, 2.30, exact. By Cauchy's inequality no partial sum exceeds the product of their
/// lengths, which rounding raises above 1 by less than 2^-11.
[[nodiscard]] constexpr Cosine dot(const Direction& a, const Direction& b) {
  return multiply<Cosine>(a.x, b.x) + multiply<Cosine>(a.y, b.y) + multiply<Cosine>(a.z, b.z);
}

/// `v` with components rounded to 14 fraction bits.
[[nodiscard]] constexpr Normal to_normal(const Direction& v) {
  const auto narrow = [](DirectionComponent c) {
    return NormalComponent::from_raw(static_cast<std::int16_t>(round_shift(c.raw(), 1)));
  };
  return {narrow(v.x), narrow(v.y), narrow(v.z)};
}

/// |a - b|^2 = 2 - 2 a·b, in 0...4, unsigned with 28 fraction bits. It is computed from the difference
/// vector, because 2 - 2 a·b loses a fifth of the value at an angle of one degree (docs/papers.md).
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t squared_chord(const Normal& a, const Normal& b) {
  const std::int32_t x = std::int32_t{a.x.raw()} - b.x.raw();
  const std::int32_t y = std::int32_t{a.y.raw()} - b.y.raw();
  const std::int32_t z = std::int32_t{a.z.raw()} - b.z.raw();
  return static_cast<std::uint32_t>(wrap_add(wrap_add(wrap_mul(x, x), wrap_mul(y, y)), wrap_mul(z, z)));
}

namespace detail {

/// True if the length is 1 within 1/64.
[[nodiscard]] constexpr bool is_unit(const Direction& v) {
  // Unsigned, because components of any value are asked about.
  const auto square = [](DirectionComponent c) {
    return static_cast<std::uint64_t>(std::int64_t{c.raw()} * c.raw());
  };
  constexpr std::uint64_t kOff = std::uint64_t{1} << 25;
  return square(v.x) + square(v.y) + square(v.z) - ((std::uint64_t{1} << 30) - kOff) <= 2 * kOff;
}

/// The unit vector along (x, y, z), by the ReciprocalRoot that root_of() returns for its scaled square,
/// 2^28 ... 3 * 2^30.
template <class RootOf>
[[nodiscard]] ARCSPAN_INLINE constexpr Direction unit_along(std::int32_t x, std::int32_t y, std::int32_t z,
                                                            const RootOf& root_of) {
  const std::uint32_t bits = magnitude(x) | magnitude(y) | magnitude(z);
  if (bits == 0) return {};
  // Scaled so that the largest component has 15 bits, the sum of squares fits 32 bits.
  const int shift = 17 - leading_zeros(bits);
  const auto scaled = [shift](std::int32_t c) { return shift >= 0 ? c >> shift : wrap_shl(c, -shift); };
  const std::int32_t sx = scaled(x);
  const std::int32_t sy = scaled(y);
  const std::int32_t sz = scaled(z);
  const std::uint32_t square = static_cast<std::uint32_t>(sx * sx) + static_cast<std::uint32_t>(sy * sy) +
                               static_cast<std::uint32_t>(sz * sz);
  const ReciprocalRoot root = root_of(square);
  const int down = root.exponent - DirectionComponent::kFraction;  // 15 or 16
  const auto component = [&](std::int32_t c) {
    // -2^15 <= c < 2^15, and the mantissa is at most 2^16, so that all fits. Halves are rounded up.
    const std::int32_t product = c * static_cast<std::int32_t>(root.mantissa);
    return DirectionComponent::from_raw((product + (std::int32_t{1} << (down - 1))) >> down);
  };
  return {component(sx), component(sy), component(sz)};
}

/// unit_of() of the components, shifted down until they fit 32 bits.
template <class UnitOf>
[[nodiscard]] constexpr Direction wide_unit_along(std::int64_t x, std::int64_t y, std::int64_t z,
                                                  const UnitOf& unit_of) {
  const int bits = static_cast<int>(std::bit_width(magnitude(x) | magnitude(y) | magnitude(z)));
  const int down = bits > 31 ? bits - 31 : 0;
  return unit_of(static_cast<std::int32_t>(x >> down), static_cast<std::int32_t>(y >> down),
                 static_cast<std::int32_t>(z >> down));
}

}  // namespace detail

/// The unit vector along (x, y, z), a vector of any length. The zero vector gives the zero vector.
[[nodiscard]] ARCSPAN_OUTLINE constexpr Direction normalised(std::int32_t x, std::int32_t y, std::int32_t z) {
  return detail::unit_along(x, y, z, reciprocal_root);
}

/// normalised() for what is shaded in every frame: by a table of roots, so that the length is 1 within 2^-13.
[[nodiscard]] ARCSPAN_OUTLINE constexpr Direction nearly_normalised(std::int32_t x, std::int32_t y,
                                                                    std::int32_t z) {
  return detail::unit_along(x, y, z, [](std::uint32_t square) {
    const int halved = (square >> 30) != 0 ? 1 : 0;
    return ReciprocalRoot{detail::tabled_reciprocal_root(square >> (2 * halved)), 30 + halved};
  });
}

/// normalised() for wider components.
[[nodiscard]] ARCSPAN_OUTLINE constexpr Direction normalised_wide(std::int64_t x, std::int64_t y,
                                                                  std::int64_t z) {
  return detail::wide_unit_along(x, y, z, normalised);
}

/// The unit vector half-way between two unit vectors, as Blinn's H from L and V. Zero if they are opposite.
[[nodiscard]] constexpr Direction half_way(const Direction& a, const Direction& b) {
  return normalised(wrap_add(a.x.raw(), b.x.raw()), wrap_add(a.y.raw(), b.y.raw()),
                    wrap_add(a.z.raw(), b.z.raw()));
}

}  // namespace arcspan
