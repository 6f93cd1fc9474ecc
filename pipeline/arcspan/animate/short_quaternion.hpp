// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/root.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>

/// Quaternions of four integers x, y, z, w below 2^15 in magnitude. Their length does not matter: what is
/// made of them is divided by it, so that they do not drift.
namespace arcspan::detail {

/// Sets `q` to a multiple of (c[0] ... c[3]) whose largest component has 15 bits, or less if it has less.
/// Components are below 2^62 in magnitude.
template <class Component>
void shorten(const Component (&c)[4], std::int32_t (&q)[4]) {
  std::uint64_t bits = 0;
  for (const Component v : c) bits |= magnitude(std::int64_t{v});
  const int width = static_cast<int>(std::bit_width(bits));
  const int down = width > 15 ? width - 15 : 0;
  const Component half = down == 0 ? Component{0} : static_cast<Component>(Component{1} << (down - 1));
  for (std::size_t i = 0; i < 4; ++i) {
    q[i] = limited((c[i] + half) >> down, 32767);
  }
}

/// Sets `unit` to a multiple of `q` whose length is 2^15 within 2; to 0 if `q` is 0. Components of 2^15 are
/// one less.
inline void make_unit(const std::int32_t (&q)[4], std::int32_t (&unit)[4]) {
  std::uint32_t square = 0;
  for (const std::int32_t c : q) square += static_cast<std::uint32_t>(c * c);
  const ReciprocalRoot inverse = reciprocal_root(square);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::int64_t product = std::int64_t{q[i]} * static_cast<std::int32_t>(inverse.mantissa);
    unit[i] = limited(static_cast<std::int32_t>(product >> (inverse.exponent - 15)), 32767);
  }
}

/// A quaternion between two of the same length, `weight` 32768ths of the way from a to b, the shorter one:
/// linear, which is within 0.04 degrees of the arc for rotations by 30 degrees, 0.12 for 45.
inline void interpolate(const std::int32_t (&a)[4], const std::int32_t (&b)[4], std::int32_t weight,
                        std::int32_t (&q)[4]) {
  std::int64_t dot = 0;
  for (std::size_t i = 0; i < 4; ++i) dot += a[i] * b[i];
  const std::int32_t signed_weight = dot < 0 ? -weight : weight;
  std::int32_t c[4];
  for (std::size_t i = 0; i < 4; ++i) c[i] = a[i] * (32768 - weight) + b[i] * signed_weight;
  shorten(c, q);
}

}  // namespace arcspan::detail
