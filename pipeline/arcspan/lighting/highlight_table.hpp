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

inline constexpr int kRampFine = 8;  ///< bits of a ramp's position within an interval

/// A ramp's values over an interval, by the position in the ramp: from `here`, less `fall`, 8 fraction bits
/// of an 8-bit step each; the values have 16.
class RampLine {
 public:
  constexpr RampLine() = default;
  constexpr RampLine(std::uint32_t, std::uint32_t here, std::uint32_t fall)
      : here_(static_cast<std::uint16_t>(here)), fall_(static_cast<std::uint16_t>(fall)) {}
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t operator()(std::uint32_t position) const {
    const std::uint32_t fraction = position & ((1u << kRampFine) - 1);
    return (std::uint32_t{here_} << kRampFine) - fall_ * fraction;
  }

 private:
  std::uint16_t here_ = 0;
  std::uint16_t fall_ = 0;
};

/// The same in twice the memory, drawn back to position 0: nothing is left to mask or to shift.
class LongRampLine {
 public:
  constexpr LongRampLine() = default;
  constexpr LongRampLine(std::uint32_t interval, std::uint32_t here, std::uint32_t fall)
      : origin_((here + fall * interval) << kRampFine), rise_(0 - fall) {}
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t operator()(std::uint32_t position) const {
    return origin_ + rise_ * position;
  }

 private:
  std::uint32_t origin_ = 0;
  std::uint32_t rise_ = 0;  ///< wraps
};

}  // namespace detail

/// What a highlight adds to a pixel, by how far its cosine c is from 1: specular * c^n in a table with linear
/// interpolation. Distances are scaled so that PowerTable's reach is kReach, whatever the exponent: a pixel
/// takes an index and a fraction of them by two shifts.
class HighlightTable {
 public:
  static constexpr std::int32_t kReach = std::int32_t{1} << 26;

  constexpr HighlightTable() = default;

  /// `specular` has a coefficient per channel in 8-bit steps, 5 fraction bits, 0...255.
  constexpr HighlightTable(const PowerTable& power, const std::array<std::uint32_t, 3>& specular) {
    const auto reach = static_cast<std::uint32_t>(power.half_reach());
    const int zeros = std::countl_zero(reach);
    up_ = zeros > 3 ? zeros - 3 : 0;
    scale_ = static_cast<std::int32_t>(((std::uint64_t{1} << 58) - 1) / (std::uint64_t{reach} << up_));
    const std::uint32_t most = largest_channel(specular);
    const auto value = [&](std::uint32_t i) {  // 8 fraction bits of an 8-bit step
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

  /// Whether (1 - c) / 2 with 30 fraction bits can be scaled: up to 4 times the reach, or 8, by the exponent.
  [[nodiscard]] constexpr bool fits(std::int32_t half_distance) const {
    return half_distance < (INT32_MAX >> up_);
  }
  /// Such a distance as operator() takes it.
  [[nodiscard]] constexpr std::int32_t scaled(std::int32_t half_distance) const {
    return multiply_high(wrap_shl(half_distance, up_), scale_);
  }

  /// Whether a scaled distance has a highlight that is the same in all channels and asks for no clamp: of
  /// white highlights nearly all, by one comparison.
  [[nodiscard]] ARCSPAN_INLINE constexpr bool is_white(std::int32_t distance) const {
    return static_cast<std::uint32_t>(distance) < white_reach_;
  }

  /// What is added at a scaled distance below kReach; negative ones are cosines that rounding has lifted
  /// above 1.
  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb operator()(std::int32_t distance) const {
    if (is_white(distance)) [[likely]] {
      return PackedRgb::grey(level(static_cast<std::uint32_t>(distance)) >> 14);
    }
    const std::uint32_t here = level(distance < 0 ? 0u : static_cast<std::uint32_t>(distance));
    const auto share = [this, here](std::size_t c) { return ((here >> 8) * share_[c]) >> 21; };
    return PackedRgb::of(share(0), share(1), share(2));
  }

 private:
  static constexpr std::uint32_t kIntervals = 128;
  static constexpr int kFine = detail::kRampFine;
  static constexpr int kPositionShift = 11;  // 2^26 / (kIntervals << kFine)
  using Line = std::conditional_t<kHasWideRegisters, detail::LongRampLine, detail::RampLine>;

  /// 16 fraction bits of an 8-bit step; distance < kReach.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t level(std::uint32_t distance) const {
    return lines_[distance >> (kPositionShift + kFine)](distance >> kPositionShift);
  }

  std::array<Line, kIntervals> lines_{};
  std::uint32_t white_reach_ = 0;         ///< kReach if all channels are the same, else 0
  std::array<std::uint32_t, 3> share_{};  ///< of the largest channel, 15 fraction bits
  std::int32_t scale_ = 0;
  int up_ = 0;
};

}  // namespace arcspan
