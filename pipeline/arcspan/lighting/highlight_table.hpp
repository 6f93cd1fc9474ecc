// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/power_table.hpp>
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

inline constexpr int kPositionBits = 16;  ///< fraction bits of a position in the table, in intervals

/// The line through an interval's two values, in 4 bytes: the value at its begin in the upper half, the
/// decrease to its end in the lower, both in 8-bit steps with 8 fraction bits. As a part of the sum the lower
/// half is below 2^-8 of a step.
class ShortHighlightLine {
 public:
  constexpr ShortHighlightLine() = default;
  constexpr ShortHighlightLine(std::uint32_t, std::uint32_t here, std::uint32_t fall)
      : line_((here << kPositionBits) | fall) {}
  /// The value at a position of the table within the interval, in 8-bit steps with 24 fraction bits.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t operator()(std::uint32_t position) const {
    const std::uint32_t fraction = position & 0xFFFFu;
    return line_ - (line_ & 0xFFFFu) * fraction;
  }

 private:
  std::uint32_t line_ = 0;
};

/// Like ShortHighlightLine, in 8 bytes: the line is extended to position 0 of the table, which saves a mask
/// and a shift per value.
class LongHighlightLine {
 public:
  constexpr LongHighlightLine() = default;
  constexpr LongHighlightLine(std::uint32_t interval, std::uint32_t here, std::uint32_t fall)
      : origin_(((here + fall * interval) << kPositionBits) + fall), rise_(0 - fall) {}
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t operator()(std::uint32_t position) const {
    return origin_ + rise_ * position;
  }

 private:
  std::uint32_t origin_ = 0;  ///< modulo 2^32, as is the sum
  std::uint32_t rise_ = 0;    ///< minus the fall
};

}  // namespace detail

/// The colour that a highlight adds to a pixel, specular * c^n, from a table over the cosine c's distance
/// from 1 with linear interpolation. Distances are scaled so that PowerTable::half_reach() becomes kReach for
/// every exponent: two shifts of a distance give the index and the fraction.
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
      const auto distance = static_cast<std::uint32_t>((std::uint64_t{i} * reach) / kIntervals);
      const std::uint32_t inside = distance < reach ? distance : reach - 1;
      return (most * power(static_cast<std::int32_t>(inside)) + (1u << 11)) >> 12;
    };
    std::uint32_t here = value(0);
    for (std::uint32_t i = 0; i < kIntervals; ++i) {
      const std::uint32_t next = value(i + 1);
      lines_[static_cast<std::size_t>(i)] = Line(i, here, here - next);
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

  /// True if the highlight at a scaled distance is equal in all channels and the distance needs no clamping.
  /// One comparison; nearly always true for white highlights.
  [[nodiscard]] ARCSPAN_INLINE constexpr bool is_white(std::int32_t distance) const {
    return static_cast<std::uint32_t>(distance) < white_reach_;
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
    const std::uint32_t here = level(distance < 0 ? 0u : static_cast<std::uint32_t>(distance)) >> 16;
    return in_shares((here * weight) >> 15);
  }

 private:
  static constexpr std::uint32_t kIntervals = 128;
  static constexpr int kPositionShift = 3;  // 2^3 = kReach / (kIntervals << kPositionBits)
  using Line = std::conditional_t<kHasWideRegisters, detail::LongHighlightLine, detail::ShortHighlightLine>;

  /// The colour whose largest channel is `most`, in 8-bit steps with 8 fraction bits.
  [[nodiscard]] constexpr PackedRgb in_shares(std::uint32_t most) const {
    const auto share = [this, most](std::size_t c) { return (most * share_[c]) >> 21; };
    return PackedRgb::of(share(0), share(1), share(2));
  }

  /// The largest channel of the highlight in 8-bit steps, 24 fraction bits; distance < kReach.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t level(std::uint32_t distance) const {
    return lines_[distance >> (kPositionShift + detail::kPositionBits)](distance >> kPositionShift);
  }

  std::array<Line, kIntervals> lines_{};
  std::uint32_t white_reach_ = 0;         ///< kReach if all channels are equal, else 0
  std::array<std::uint32_t, 3> share_{};  ///< a channel's part of the largest one, 15 fraction bits
  std::int32_t scale_ = 0;
  int up_ = 0;
};

}  // namespace arcspan
