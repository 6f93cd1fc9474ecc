// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>

#include <compare>
#include <concepts>
#include <cstdint>

namespace arcspan {

/// floor(a / 2^bits + 1/2), bits in 1...31. All products of the pipeline are rounded like this, except where
/// a name or comment says otherwise.
[[nodiscard]] constexpr std::int32_t round_shift(std::int32_t a, int bits) {
  return wrap_add(a, std::int32_t{1} << (bits - 1)) >> bits;
}

namespace detail {
/// Never defined: a consteval function calls it to reject a constant, which then does not compile.
void constant_out_of_range();
}  // namespace detail

/// A fixed-point number with F fraction bits: the integer `raw()` stands for the number raw() / 2^F. Formats
/// do not mix and there are no implicit conversions. There is no operator/, so that a division of these
/// numbers in the span stage does not compile.
template <std::signed_integral R, int F>
requires(F >= 0 && F < static_cast<int>(8 * sizeof(R))) class Fixed {
 public:
  using Rep = R;
  static constexpr int kFraction = F;

  /// Like an integer: `Fixed x;` has no value, so that declaring tables and commands costs no instructions;
  /// `Fixed{}` is 0.
  Fixed() = default;

  /// The number raw / 2^F.
  [[nodiscard]] static constexpr Fixed from_raw(R raw) {
    Fixed result{};
    result.raw_ = raw;
    return result;
  }

  /// A constant from a decimal literal, rounded to nearest. A literal out of range does not compile.
  [[nodiscard]] static consteval Fixed of(double value) {
    const double scaled = value * static_cast<double>(std::int64_t{1} << F);
    const double rounded = scaled < 0 ? scaled - 0.5 : scaled + 0.5;
    constexpr double kLimit = static_cast<double>(std::int64_t{1} << (8 * sizeof(R) - 1));
    if (!(rounded > -kLimit - 1 && rounded < kLimit)) detail::constant_out_of_range();
    return from_raw(static_cast<R>(rounded));
  }

  [[nodiscard]] constexpr R raw() const { return raw_; }

  /// Sums wrap (see wrap_add); each format states the range in which they do not.
  [[nodiscard]] friend constexpr Fixed operator+(Fixed a, Fixed b) {
    return from_raw(static_cast<R>(wrap_add(a.raw_, b.raw_)));
  }
  [[nodiscard]] friend constexpr Fixed operator-(Fixed a, Fixed b) {
    return from_raw(static_cast<R>(wrap_sub(a.raw_, b.raw_)));
  }
  [[nodiscard]] friend constexpr Fixed operator-(Fixed a) { return Fixed{} - a; }
  constexpr Fixed& operator+=(Fixed other) { return *this = *this + other; }
  constexpr Fixed& operator-=(Fixed other) { return *this = *this - other; }

  friend constexpr auto operator<=>(Fixed, Fixed) = default;

 private:
  R raw_;
};

/// a * b in format `To`, rounded, by one 32-bit multiply. |a.raw() * b.raw()| must be below 2^31 less half a
/// unit of the result; otherwise the result wraps (multiply_wide() takes any).
template <class To, class A, class B>
[[nodiscard]] constexpr To multiply(A a, B b) {
  constexpr int kShift = A::kFraction + B::kFraction - To::kFraction;
  static_assert(kShift >= 0 && kShift < 32);
  const std::int32_t product = wrap_mul(a.raw(), b.raw());
  if constexpr (kShift == 0) {
    return To::from_raw(static_cast<typename To::Rep>(product));
  } else {
    return To::from_raw(static_cast<typename To::Rep>(round_shift(product, kShift)));
  }
}

/// `a` in format `To`: rounded if it has fewer fraction bits, otherwise exact. The result must fit `To`.
template <class To, class A>
[[nodiscard]] constexpr To convert(A a) {
  constexpr int kShift = A::kFraction - To::kFraction;
  if constexpr (kShift > 0) {
    return To::from_raw(static_cast<typename To::Rep>(round_shift(a.raw(), kShift)));
  } else {
    return To::from_raw(static_cast<typename To::Rep>(wrap_shl(a.raw(), -kShift)));
  }
}

}  // namespace arcspan
