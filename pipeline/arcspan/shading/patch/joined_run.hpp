// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/shading/patch/parabola.hpp>
#include <arcspan/shading/patch/patch.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// SecondDifferenceRun of two scalars on machines with wide registers: both in one, so that one addition
/// steps two values and one steps two differences. The register holds the sum of both as signed numbers, the
/// scalar `kUpper` times 2^32, so that a negative lower scalar borrows from the upper half. The bits are
/// those of SecondDifferenceRun as long as the lower scalar does not leave the range of a Cosine.
///
/// kForProduct: the upper scalar is negated, and offset by what rounds it in minus_product().
template <std::size_t kUpper, bool kForProduct>
class JoinedRun {
 public:
  [[nodiscard]] ARCSPAN_INLINE constexpr std::array<Cosine, 2> scalars() const {
    std::array<Cosine, 2> both{};
    both[1 - kUpper] = lower();
    both[kUpper] = upper();
    return both;
  }
  [[nodiscard]] ARCSPAN_INLINE constexpr Cosine lower() const {
    return Cosine::from_raw(static_cast<std::int32_t>(x_));
  }
  [[nodiscard]] ARCSPAN_INLINE constexpr Cosine upper() const {
    const std::int32_t half = upper_half_down<0>();
    return Cosine::from_raw(kForProduct ? wrap_sub(kOffset, half) : half);
  }
  /// Returns a copy from which rare code computes again, so that common code keeps nothing for it.
  [[nodiscard]] ARCSPAN_INLINE constexpr JoinedRun again() const {
    JoinedRun copy = *this;
    hide_value(copy.x_);
    return copy;
  }
  /// Returns the product of both scalars, each rounded to 15 fraction bits, times -1.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t minus_product() const requires kForProduct {
    return wrap_mul(round_shift(lower().raw(), 15), upper_half_down<15>());
  }
  ARCSPAN_INLINE constexpr void next() {
    x_ += d_;
    d_ += second_difference_;
  }

  // The other members are those of SecondDifferenceRun. Scalar 0 is started first.

  ARCSPAN_INLINE constexpr void start(std::size_t i, const PatchScalar& scalar, std::uint32_t p) {
    start_at(i, parabola_from_edge(scalar, p));
  }
  ARCSPAN_INLINE constexpr void start_at(std::size_t i, const Parabola& f) {
    if (i == 0) x_ = d_ = second_difference_ = 0;
    x_ += placed(i, i == kUpper ? f.x + Cosine::from_raw(kUpperStart) : f.x);
    d_ += placed(i, f.d);
    second_difference_ += placed(i, f.second_difference);
  }
  constexpr void skip(std::int32_t count) {
    const auto n = static_cast<std::uint64_t>(count);
    x_ += d_ * n + second_difference_ * ((n * (n - 1)) >> 1);
    d_ += second_difference_ * n;
  }
  constexpr int stride(int bits) {
    const std::uint64_t n = std::uint64_t{1} << bits;
    d_ = d_ * n + second_difference_ * ((n * (n - 1)) >> 1);
    second_difference_ = second_difference_ * n * n;
    return bits;
  }

 private:
  /// -floor(u + 1/2) = floor(-u + 1/2 - 2^-15) of multiples u of 2^-15.
  static constexpr std::int32_t kOffset = kForProduct ? (1 << 14) - 1 : 0;
  /// Added to the upper scalar: the offset, and 1 so that the borrow of the lower half cancels. That 1, of
  /// which upper_half_down() takes half away again, leaves the lower half 2^31 larger and so never negative.
  static constexpr std::int32_t kUpperStart = kForProduct ? -(kOffset + 1) : 1;

  [[nodiscard]] ARCSPAN_INLINE static constexpr std::uint64_t placed(std::size_t i, Cosine value) {
    if (i != kUpper) return static_cast<std::uint64_t>(std::int64_t{value.raw()});
    const std::uint64_t upper = static_cast<std::uint64_t>(std::int64_t{value.raw()}) << 32;
    return kForProduct ? -upper : upper;
  }
  /// Returns the upper half / 2^kShift, rounded down.
  template <int kShift>
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t upper_half_down() const {
    const auto half = static_cast<std::int64_t>(x_ - (std::uint64_t{1} << 31));
    return static_cast<std::int32_t>(half >> (32 + kShift));
  }

  std::uint64_t x_;
  std::uint64_t d_;
  std::uint64_t second_difference_;
};

}  // namespace arcspan
