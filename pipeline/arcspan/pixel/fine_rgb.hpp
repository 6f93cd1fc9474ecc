// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/target.hpp>

#include <bit>
#include <cstdint>
#include <type_traits>

namespace arcspan {

/// Three channels of an 8-bit step with 23 fraction bits, to which half a step has been added, so that
/// dropping them rounds; of blue's the last 5 are 0. Below 2^31: the upper bits of a channel are a level
/// without a mask. `Joined` is how they are kept, not what they are.
template <bool Joined>
struct BasicFineRgb;

namespace detail {

/// What both forms share.
struct FineChannels {
  static constexpr int kFraction = 23;
  /// Bits that blue lacks.
  static constexpr int kDropped = 5;

  /// A gradient of blue's, at most 2^31 - 32, rounded to what it has bits for.
  [[nodiscard]] static constexpr std::int32_t blue_step(std::int32_t step) {
    constexpr std::int32_t kUnit = 1 << kDropped;
    return wrap_add(step, kUnit / 2) & -kUnit;
  }

 protected:
  [[nodiscard]] static constexpr PackedRgb pack(std::uint32_t r, std::uint32_t g, std::uint32_t b) {
    return PackedRgb::of(r >> (kFraction - 2), g >> (kFraction - 2), b >> (kFraction - 2));
  }
};

/// The lower 11 bits of `low`, and `five` above them.
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint16_t with_upper_five(std::uint32_t low, std::uint32_t five) {
#if ARCSPAN_HAS_BIT_INSERT
  if (!std::is_constant_evaluated()) {
    // gcc takes the instruction that inserts bits for an assignment to some, and for no expression.
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

/// A word each.
template <>
struct BasicFineRgb<false> : detail::FineChannels {
  /// What a triangle keeps of its steps beside the channels' gradients.
  struct KeptStep {};

  BasicFineRgb() = default;  // no aggregate: encode({r, g, b}) means an Rgb8

  /// Channels in 0...2^31 - 1. Blue's last bits stay as they are, since no step changes them.
  [[nodiscard]] static constexpr BasicFineRgb of(std::uint32_t r, std::uint32_t g, std::uint32_t b) {
    BasicFineRgb c{};
    c.r_ = r;
    c.g_ = g;
    c.b_ = b;
    return c;
  }
  [[nodiscard]] static constexpr KeptStep keep_step(std::int32_t, std::int32_t) { return {}; }
  /// A step for advance(), by signed gradients with 23 fraction bits, blue's made by blue_step().
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
  /// The code rrrrrggggggbbbbb: what comes down from a word's top needs no mask.
  [[nodiscard]] constexpr std::uint16_t rgb565() const {
    constexpr int kSix = kFraction + 2;
    const std::uint32_t red_green = ((r_ >> (kSix + 1)) << 6) | (g_ >> kSix);
    return static_cast<std::uint16_t>((red_green << 5) | (b_ >> (kSix + 1)));
  }

 private:
  std::uint32_t r_;
  std::uint32_t g_;
  std::uint32_t b_;
};

/// Red in a word. Green and blue share two, one number of 64 bits: 26 of blue, 31 of green and 7 that are 0.
/// Blue's upper five and green's upper six are then at the ends of one word, which a rotation joins as a
/// 5-6-5 code has them: two instructions a pixel less than with a word each.
template <>
struct BasicFineRgb<true> : detail::FineChannels {
  /// Green's and blue's step, joined as the channels are.
  using KeptStep = std::uint64_t;

  BasicFineRgb() = default;

  /// As of a word each, and so are the others.
  [[nodiscard]] static constexpr BasicFineRgb of(std::uint32_t r, std::uint32_t g, std::uint32_t b) {
    BasicFineRgb c{};
    c.r_ = r;
    c.blue_green_ = joined(((b >> kDropped) << kSix) | (g >> kGreenBelow), g << kUnused);
    return c;
  }
  /// Of green's and blue's gradients, the latter made by blue_step().
  [[nodiscard]] static constexpr KeptStep keep_step(std::int32_t g, std::int32_t b) {
    return joined((static_cast<std::uint32_t>(b) << 1) + static_cast<std::uint32_t>(g >> kGreenBelow),
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
    return static_cast<std::uint32_t>(blue_green_ >> (32 + kSix)) << kDropped;
  }
  [[nodiscard]] constexpr PackedRgb packed() const { return pack(r(), g(), b()); }
  [[nodiscard]] constexpr std::uint16_t rgb565() const {
    const auto ends = static_cast<std::uint32_t>(blue_green_ >> 32);
    return detail::with_upper_five((ends << 5) | (ends >> 27), r_ >> (kFraction + 3));
  }

 private:
  static constexpr int kSix = 6;                    ///< bits of green in the upper word
  static constexpr int kGreenBelow = 31 - kSix;     ///< and in the lower one
  static constexpr int kUnused = 32 - kGreenBelow;  ///< of that

  [[nodiscard]] static constexpr std::uint64_t joined(std::uint32_t high, std::uint32_t low) {
    return (std::uint64_t{high} << 32) | low;
  }

  std::uint32_t r_;
  std::uint64_t blue_green_;
};

/// Joined where 64 bits are one register, or where there are registers enough and an instruction that inserts
/// bits.
using FineRgb = BasicFineRgb<kHasWideRegisters || ARCSPAN_HAS_BIT_INSERT != 0>;

}  // namespace arcspan
