// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/target.hpp>

#include <bit>
#include <cstdint>
#include <type_traits>

namespace arcspan {

/// A colour that Gouraud shading steps along a row: three channels in 8-bit steps with 23 fraction bits,
/// below 2^31, so that a shift without a mask gives the upper bits. A channel includes half an 8-bit step, so
/// that dropping the fraction rounds. The last 5 fraction bits of blue are 0.
///
/// `Joined` chooses the layout in registers. Both layouts have the same members and give the same pixels.
template <bool Joined>
struct BasicFineRgb;

/// The common part of both layouts.
struct FineChannels {
  static constexpr int kFraction = 23;
  static constexpr int kDropped = 5;  ///< fraction bits of blue that are always 0

  /// A gradient of blue, at most 2^31 - 32, rounded to a multiple of 2^kDropped.
  [[nodiscard]] static constexpr std::int32_t blue_step(std::int32_t step) {
    constexpr std::int32_t kUnit = 1 << kDropped;
    return wrap_add(step, kUnit / 2) & -kUnit;
  }

 protected:
  [[nodiscard]] static constexpr PackedRgb pack(std::uint32_t r, std::uint32_t g, std::uint32_t b) {
    return PackedRgb::of(r >> (kFraction - 2), g >> (kFraction - 2), b >> (kFraction - 2));
  }
};

namespace detail {

/// The lower 11 bits of `low` with the lower 5 bits of `five` above them.
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint16_t with_upper_five(std::uint32_t low, std::uint32_t five) {
#if ARCSPAN_HAS_BIT_INSERT
  if (!std::is_constant_evaluated()) {
    // gcc uses the bit-field insert instruction for assignments to bit-fields, but for no expression.
    struct Bits {
      std::uint32_t low : 11;
      std::uint32_t five : 5;
      std::uint32_t rest : 16;
    };
    auto bits = std::bit_cast<Bits>(low);
    bits.five = five & 31u;
    return static_cast<std::uint16_t>(std::bit_cast<std::uint32_t>(bits));
  }
#endif
  return static_cast<std::uint16_t>((five << 11) | (low & 0x7FFu));
}

}  // namespace detail

/// One word per channel.
template <>
struct BasicFineRgb<false> : FineChannels {
  /// Per-triangle data of a step beside the channels' gradients. This form needs none.
  struct KeptStep {};

  BasicFineRgb() = default;  // not an aggregate, so that encode({r, g, b}) takes an Rgb8

  /// The colour of three channels in 0...2^31 - 1. The last kDropped bits of blue are ignored.
  [[nodiscard]] static constexpr BasicFineRgb of(std::uint32_t r, std::uint32_t g, std::uint32_t b) {
    BasicFineRgb c{};
    c.r_ = r;
    c.g_ = g;
    c.b_ = b;
    return c;
  }
  /// The kept part of a step, from the gradients of green and blue.
  [[nodiscard]] static constexpr KeptStep keep_step(std::int32_t, std::int32_t) { return {}; }
  /// A step for advance(), from signed gradients with 23 fraction bits (that of blue from blue_step()) and
  /// the kept part.
  [[nodiscard]] static constexpr BasicFineRgb step(std::int32_t r, std::int32_t g, std::int32_t b, KeptStep) {
    BasicFineRgb c{};
    c.r_ = static_cast<std::uint32_t>(r);
    c.g_ = static_cast<std::uint32_t>(g);
    c.b_ = static_cast<std::uint32_t>(b);
    return c;
  }
  ARCSPAN_INLINE constexpr void advance(const BasicFineRgb& step) {
    r_ += step.r_;
    g_ += step.g_;
    b_ += step.b_;
  }

  [[nodiscard]] constexpr std::uint32_t r() const { return r_; }
  [[nodiscard]] constexpr std::uint32_t g() const { return g_; }
  [[nodiscard]] constexpr std::uint32_t b() const { return b_ >> kDropped << kDropped; }
  [[nodiscard]] constexpr PackedRgb packed() const { return pack(r_, g_, b_); }
  /// The colour as an Rgb565 pixel.
  [[nodiscard]] constexpr std::uint16_t rgb565() const {
    constexpr int kToSixBits = kFraction + 2;  // a shift from the top of a word needs no mask
    const std::uint32_t red_green = ((r_ >> (kToSixBits + 1)) << 6) | (g_ >> kToSixBits);
    return static_cast<std::uint16_t>((red_green << 5) | (b_ >> (kToSixBits + 1)));
  }

 private:
  std::uint32_t r_;
  std::uint32_t g_;
  std::uint32_t b_;
};

/// Red in one word; green and blue in one number of 64 bits. From the top, it has 26 bits of blue, 31 of
/// green and 7 that are 0. The upper five bits of blue and the upper six of green are then at the two ends of
/// the upper word, and a rotation joins them as in a 5-6-5 pixel. This takes two instructions per pixel less
/// than one word per channel.
template <>
struct BasicFineRgb<true> : FineChannels {
  /// The steps of green and blue, joined like the channels.
  using KeptStep = std::uint64_t;

  BasicFineRgb() = default;

  // The members are those of BasicFineRgb<false>.

  [[nodiscard]] static constexpr BasicFineRgb of(std::uint32_t r, std::uint32_t g, std::uint32_t b) {
    BasicFineRgb c{};
    c.r_ = r;
    c.blue_green_ = joined(((b >> kDropped) << kUpperGreen) | (g >> kLowerGreen), g << kUnused);
    return c;
  }
  [[nodiscard]] static constexpr KeptStep keep_step(std::int32_t g, std::int32_t b) {
    return joined((static_cast<std::uint32_t>(b) << 1) + static_cast<std::uint32_t>(g >> kLowerGreen),
                  static_cast<std::uint32_t>(g) << kUnused);
  }
  [[nodiscard]] static constexpr BasicFineRgb step(std::int32_t r, std::int32_t, std::int32_t,
                                                   KeptStep kept) {
    BasicFineRgb c{};
    c.r_ = static_cast<std::uint32_t>(r);
    c.blue_green_ = kept;
    return c;
  }
  ARCSPAN_INLINE constexpr void advance(const BasicFineRgb& step) {
    r_ += step.r_;
    blue_green_ += step.blue_green_;
  }

  [[nodiscard]] constexpr std::uint32_t r() const { return r_; }
  [[nodiscard]] constexpr std::uint32_t g() const {
    return static_cast<std::uint32_t>(blue_green_ >> kUnused) & 0x7FFFFFFFu;
  }
  [[nodiscard]] constexpr std::uint32_t b() const {
    return static_cast<std::uint32_t>(blue_green_ >> (32 + kUpperGreen)) << kDropped;
  }
  [[nodiscard]] constexpr PackedRgb packed() const { return pack(r(), g(), b()); }
  [[nodiscard]] constexpr std::uint16_t rgb565() const {
    const auto ends = static_cast<std::uint32_t>(blue_green_ >> 32);
    return detail::with_upper_five((ends << 5) | (ends >> 27), r_ >> (kFraction + 3));
  }

 private:
  static constexpr int kUpperGreen = 6;                 ///< bits of green in the upper word
  static constexpr int kLowerGreen = 31 - kUpperGreen;  ///< bits of green in the lower word
  static constexpr int kUnused = 32 - kLowerGreen;      ///< bits of the lower word that are 0

  [[nodiscard]] static constexpr std::uint64_t joined(std::uint32_t high, std::uint32_t low) {
    return (std::uint64_t{high} << 32) | low;
  }

  std::uint32_t r_;
  std::uint64_t blue_green_;
};

/// The layout for this processor: joined if a register has 64 bits, or if there is an instruction that
/// inserts bits.
using FineRgb = BasicFineRgb<kHasWideRegisters || ARCSPAN_HAS_BIT_INSERT != 0>;

}  // namespace arcspan
