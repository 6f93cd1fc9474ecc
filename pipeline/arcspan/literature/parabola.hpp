// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/unroll.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan::literature {

/// A scalar at a pixel, its first difference and its second difference along the row.
struct Parabola {
  Cosine x;
  Cosine d;
  Cosine second_difference;

  constexpr void next() {
    x += d;
    d += second_difference;
  }
  /// Steps `count` pixels at once; the result is bit-identical to that of `count` calls of next().
  constexpr void skip(std::int32_t count) {
    const auto steps = static_cast<std::uint32_t>(count);
    const auto pairs = static_cast<std::int32_t>((steps * (steps - 1)) >> 1);
    x += Cosine::from_raw(wrap_add(wrap_mul(d.raw(), count), wrap_mul(second_difference.raw(), pairs)));
    d += Cosine::from_raw(wrap_mul(second_difference.raw(), count));
  }
  /// Makes every following next() step 2^bits pixels. The values are bit-identical to those of single steps.
  constexpr void stride(int bits) {
    // The sum of the n steps d, d + b, d + 2 b ... is n d + b n (n - 1) / 2.
    const std::int32_t pairs = ((1 << bits) * ((1 << bits) - 1)) >> 1;
    d = Cosine::from_raw(wrap_add(wrap_shl(d.raw(), bits), wrap_mul(second_difference.raw(), pairs)));
    second_difference = Cosine::from_raw(wrap_shl(second_difference.raw(), 2 * bits));
  }
};

/// `Count` scalars of a row's pixels, stepped by second differences.
template <std::size_t Count>
struct SecondDifferenceRun {
  std::array<Parabola, Count> of;

  [[nodiscard]] constexpr std::array<Cosine, Count> scalars() const {
    std::array<Cosine, Count> values;
    unrolled<Count>([&](auto i) { values[i] = of[i].x; });
    return values;
  }
  constexpr void next() {
    unrolled<Count>([this](auto i) { of[i].next(); });
  }
  constexpr void skip(std::int32_t count) {
    unrolled<Count>([&](auto i) { of[i].skip(count); });
  }
  constexpr void stride(int bits) {
    unrolled<Count>([&](auto i) { of[i].stride(bits); });
  }
};

}  // namespace arcspan::literature
