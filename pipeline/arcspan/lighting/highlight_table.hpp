// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/power_table.hpp>
#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace arcspan {

namespace detail {

/// The line through the two values of an interval of HighlightTable, as a function of the whole distance: in
/// the lower half of the word its fall per distance, in 8-bit steps with 24 fraction bits, in the upper half
/// its value at distance 0, modulo 2^16, with 8 fraction bits. As a part of the sum the lower half is below
/// 2^-11 of a step.
class HighlightLine {
 public:
  static constexpr int kIntervalBits = 19;

  constexpr HighlightLine() = default;
  /// `here` and `next` are the values at both ends of an interval, in 8-bit steps with 8 fraction bits. The
  /// fall is rounded down, so that the line ends at most 2^-5 of a step above `next` and never below, where a
  /// value of 0 would wrap.
  constexpr HighlightLine(std::uint32_t interval, std::uint32_t here, std::uint32_t next) {
    const std::uint32_t fall = (here - next) >> (kIntervalBits - 16);
    line_ = (here << 16) + fall * (interval << kIntervalBits) + fall;
  }
  /// The value at a distance within the interval, in 8-bit steps with 24 fraction bits.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t operator()(std::uint32_t distance) const {
    return line_ - (line_ & 0xFFFFu) * distance;
  }

 private:
  std::uint32_t line_ = 0;
};

/// HighlightLine in two words, one of which is its slope: an instruction less where words are not short of
/// room. The values are the same.
class WideHighlightLine {
 public:
  constexpr WideHighlightLine() = default;
  constexpr WideHighlightLine(std::uint32_t interval, std::uint32_t here, std::uint32_t next)
      : origin_(HighlightLine(interval, here, next)(0)),
        slope_(HighlightLine(interval, here, next)(1) - origin_) {}
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t operator()(std::uint32_t distance) const {
    return origin_ + slope_ * distance;
  }

 private:
  std::uint32_t origin_ = 0;
  std::uint32_t slope_ = 0;
};

}  // namespace detail

/// The colour that a highlight adds to a pixel, specular * c^n, from a table over the cosine c's distance
/// from 1 with linear interpolation. Distances are scaled so that PowerTable::half_reach() becomes kReach for
/// every exponent: a shift of a distance gives the index of its line.
class HighlightTable {
 public:
  static constexpr std::int32_t kReach = std::int32_t{1} << 26;  ///< least scaled distance without highlight

  constexpr HighlightTable() = default;

  /// `specular` has a coefficient per channel, 0...255 in 8-bit steps with 5 fraction bits.
  constexpr HighlightTable(const PowerTable& power, const std::array<std::uint32_t, 3>& specular) {
    const auto reach = static_cast<std::uint32_t>(power.half_reach());
    const int zeros = std::countl_zero(reach);
    up_ = zeros > 3 ? zeros - 3 : 0;
    scale_ = static_cast<std::int32_t>(((std::uint64_t{1} << 58) - 1) / (std::uint64_t{reach} << up_));
    const std::uint32_t most = largest_channel(specular);
    const auto value = [&](std::uint32_t i) {  // in 8-bit steps, 8 fraction bits
      const auto distance = static_cast<std::int32_t>((std::uint64_t{i} * reach) / kIntervals);
      return (most * power(distance) + (1u << 11)) >> 12;
    };
    std::uint32_t here = value(0);
    for (std::uint32_t i = 0; i < kIntervals; ++i) {
      const std::uint32_t next = i + 1 < kIntervals ? value(i + 1) : 0;
      lines_[static_cast<std::size_t>(i)] = Line(i, here, next);
      here = next;
    }
    for (std::size_t c = 0; c < 3; ++c) share_[c] = most == 0 ? 0 : (specular[c] << 15) / most;
    white_reach_ = specular[0] == specular[1] && specular[1] == specular[2] ? kReach : 0;
  }

  /// True if scaled() can take `half_distance`. The limit is 4 to 8 times PowerTable::half_reach(), depending
  /// on the exponent.
  [[nodiscard]] constexpr bool fits(std::int32_t half_distance) const {
    return half_distance < (INT32_MAX >> up_);
  }
  /// The distance that operator() takes, for half_distance = (1 - c) / 2 with 30 fraction bits.
  [[nodiscard]] constexpr std::int32_t scaled(std::int32_t half_distance) const {
    return multiply_high(wrap_shl(half_distance, up_), scale_);
  }
  /// The cosine times 2^26 / half_reach(): its product with another cosine is a scaled distance. Below 1.22
  /// for n <= 64, which slopes of pieces of rows need (PieceSteps::drop).
  [[nodiscard]] constexpr Cosine scaled_factor(Cosine cosine) const {
    return Cosine::from_raw(wrap_shl(multiply_high(cosine.raw(), scale_), up_));
  }

  /// True if the highlight at a scaled distance is equal in all channels and the distance needs no clamping.
  /// One comparison; nearly always true for white highlights.
  [[nodiscard]] ARCSPAN_INLINE constexpr bool is_white(std::int32_t distance) const {
    return static_cast<std::uint32_t>(distance) < white_reach_;
  }

  /// True if highlights are equal in all channels.
  [[nodiscard]] constexpr bool is_always_white() const { return white_reach_ != 0; }

  /// The highlight of an is_always_white() table at any scaled distance, as a value of all channels
  /// (PackedRgb): no comparison on processors that saturate.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t white(std::int32_t distance) const {
    return level(clamped_unsigned<26, 0>(distance)) >> 22;
  }

  /// The highlight at a scaled distance below kReach. A negative distance, of a cosine that rounding has
  /// raised above 1, counts as 0.
  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb operator()(std::int32_t distance) const {
    if (is_white(distance)) [[likely]] {
      return PackedRgb::grey(level(static_cast<std::uint32_t>(distance)) >> 22);
    }
    return in_shares(level(distance < 0 ? 0u : static_cast<std::uint32_t>(distance)) >> 16);
  }
  /// The highlight times `weight`, 0...1 with 15 fraction bits.
  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb operator()(std::int32_t distance,
                                                              std::uint32_t weight) const {
    if (is_white(distance)) [[likely]] {
      return PackedRgb::grey(((level(static_cast<std::uint32_t>(distance)) >> 16) * weight) >> 21);
    }
    return in_shares((value(distance) * weight) >> 15);
  }

  /// The largest channel of the highlight at a scaled distance below kReach, in 8-bit steps with 8 fraction
  /// bits. A negative distance counts as 0.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t value(std::int32_t distance) const {
    return level(distance < 0 ? 0u : static_cast<std::uint32_t>(distance)) >> 16;
  }
  /// The colour of a sum of values times weights, in 8-bit steps with 8 fraction bits, below 2^31; clamped.
  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb of_sum(std::uint32_t sum) const {
    const std::uint32_t most = clamped_unsigned<16, 0>(static_cast<std::int32_t>(sum));
    return white_reach_ != 0 ? PackedRgb::grey(most >> 6) : in_shares(most);
  }

 private:
  static constexpr std::uint32_t kIntervals = 128;
  static_assert(kReach == static_cast<std::int32_t>(kIntervals << detail::HighlightLine::kIntervalBits));

  /// The colour whose largest channel is `most`, in 8-bit steps with 8 fraction bits.
  [[nodiscard]] constexpr PackedRgb in_shares(std::uint32_t most) const {
    const auto share = [this, most](std::size_t c) { return (most * share_[c]) >> 21; };
    return PackedRgb::of(share(0), share(1), share(2));
  }

  /// The largest channel of the highlight in 8-bit steps, 24 fraction bits; distance < kReach.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t level(std::uint32_t distance) const {
    return lines_[distance >> detail::HighlightLine::kIntervalBits](distance);
  }

  using Line = std::conditional_t<kHasWideRegisters, detail::WideHighlightLine, detail::HighlightLine>;
  std::array<Line, kIntervals> lines_{};
  std::uint32_t white_reach_ = 0;         ///< kReach if all channels are equal, else 0
  std::array<std::uint32_t, 3> share_{};  ///< a channel's part of the largest one, 15 fraction bits
  std::int32_t scale_ = 0;
  int up_ = 0;
};

}  // namespace arcspan
