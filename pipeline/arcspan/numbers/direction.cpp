// SPDX-License-Identifier: MIT
#include <arcspan/numbers/direction.hpp>
#include <arcspan/numbers/root.hpp>

#include <bit>

namespace arcspan {

namespace {

std::uint32_t magnitude(std::int32_t v) {
  return v < 0 ? 0u - static_cast<std::uint32_t>(v) : static_cast<std::uint32_t>(v);
}

}  // namespace

Direction normalised(std::int32_t x, std::int32_t y, std::int32_t z) {
  const std::uint32_t bits = magnitude(x) | magnitude(y) | magnitude(z);
  if (bits == 0) return {};
  // Scale so that the largest component has 15 bits: the sum of squares fits 32.
  const int shift = 17 - std::countl_zero(bits);
  const auto scaled = [shift](std::int32_t c) { return shift >= 0 ? c >> shift : wrap_shl(c, -shift); };
  const std::int32_t sx = scaled(x);
  const std::int32_t sy = scaled(y);
  const std::int32_t sz = scaled(z);
  const std::uint32_t square = static_cast<std::uint32_t>(sx * sx) + static_cast<std::uint32_t>(sy * sy) +
                               static_cast<std::uint32_t>(sz * sz);
  const ReciprocalRoot length = reciprocal_root(square);
  const int down = length.exponent - DirectionComponent::kFraction;  // 15 or 16
  const std::uint32_t half = std::uint32_t{1} << (down - 1);
  const auto component = [&](std::int32_t c) {
    // At most 2^31 without the sign. A half is rounded up, whatever the sign.
    const std::uint32_t product = magnitude(c) * length.mantissa;
    const auto rounded =
        static_cast<std::int32_t>((product + half - static_cast<std::uint32_t>(c < 0)) >> down);
    return DirectionComponent::from_raw(c < 0 ? -rounded : rounded);
  };
  return {component(sx), component(sy), component(sz)};
}

Direction normalised_wide(std::int64_t x, std::int64_t y, std::int64_t z) {
  const auto size = [](std::int64_t v) { return static_cast<std::uint64_t>(v < 0 ? -v : v); };
  const int bits = static_cast<int>(std::bit_width(size(x) | size(y) | size(z)));
  const int down = bits > 31 ? bits - 31 : 0;
  return normalised(static_cast<std::int32_t>(x >> down), static_cast<std::int32_t>(y >> down),
                    static_cast<std::int32_t>(z >> down));
}

Direction half_way(const Direction& a, const Direction& b) {
  return normalised(wrap_add(a.x.raw(), b.x.raw()), wrap_add(a.y.raw(), b.y.raw()),
                    wrap_add(a.z.raw(), b.z.raw()));
}

}  // namespace arcspan
