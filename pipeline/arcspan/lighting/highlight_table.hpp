// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/power_table.hpp>
#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// The highlight that a pixel adds to its colour, specular * c^n, looked up by the closeness of the cosine c
/// to 1: how far the half distance (1 - c) / 2 is below PowerTable::half_reach(). Closeness is scaled so that
/// the product of two scalars gives it with a shift of neither:
///
///     closeness = origin + (N·L >> 15) * (scaled(N·V) >> 15)      (Phong)
///     closeness = origin + scaled(N·H) / 2                        (Blinn)
///
/// where `origin` belongs to the light. At 0 or below there is no highlight; at c = 1 closeness is reach(),
/// at most 2^25. An interval of the table has 18 bits, 16 of which are multiplied: a pixel takes products of
/// two 16-bit words and additions only.
class HighlightTable {
  /// Sets the lines through value(i) at the end of each interval, in 8-bit steps with 8 fraction bits.
  template <class Value>
  constexpr void set_lines(const Value& value) {
    std::uint32_t here = value(0);
    for (std::uint32_t i = 0; i < kIntervals; ++i) {
      const std::uint32_t next = value(i + 1);
      const std::uint32_t rise = next - here;
      lines_[static_cast<std::size_t>(i)] = ((here - rise * i) << 16) | rise;
      here = next;
    }
  }

 public:
  static constexpr int kReachBits = 25;

  constexpr HighlightTable() = default;

  /// `specular` has a coefficient per channel, 0...255 in 8-bit steps with 5 fraction bits.
  constexpr HighlightTable(const PowerTable& power, const std::array<std::uint32_t, 3>& specular) {
    const auto half_reach = static_cast<std::uint32_t>(power.half_reach());  // 30 fraction bits
    // The factor is 2^25 / half_reach, but below 1: for exponents up to 104 the reach is all of the table.
    // Otherwise it ends with an interval, so that the line there meets the peak.
    const std::uint32_t intervals = half_reach >> kIntervalBits;
    const std::uint64_t used = intervals < kIntervals ? intervals : kIntervals;
    const std::uint64_t factor = (used << (kIntervalBits + 31)) / half_reach;
    constexpr std::uint64_t kMostFactor = (std::uint64_t{1} << 31) - 1;
    factor_ = static_cast<std::int32_t>(factor < kMostFactor ? factor : kMostFactor);
    reach_ = scaled(Cosine::from_raw(power.half_reach())).raw();
    const std::uint32_t most = largest_channel(specular);
    const auto value = [&](std::uint32_t i) {  // at closeness i << kIntervalBits, 8 fraction bits
      const std::int32_t closeness = static_cast<std::int32_t>(i << kIntervalBits);
      if (closeness >= reach_) return (most * power(0) + (1u << 11)) >> 12;
      const std::uint64_t beyond = static_cast<std::uint64_t>(reach_ - closeness) << 31;
      const auto half_distance = static_cast<std::int32_t>(beyond / static_cast<std::uint64_t>(factor_));
      return half_distance < power.half_reach() ? (most * power(half_distance) + (1u << 11)) >> 12 : 0u;
    };
    set_lines(value);
    for (std::size_t c = 0; c < 3; ++c) share_[c] = most == 0 ? 0 : (specular[c] << 15) / most;
    white_ = specular[0] == specular[1] && specular[1] == specular[2] ? PackedRgb::grey(1).lanes : 0;
  }

  /// From half its brightness on, the highlight gets all of it, and below it none (toon.hpp).
  constexpr void harden();
  /// `c` times the factor of closeness, which is below 1.
  [[nodiscard]] constexpr Cosine scaled(Cosine c) const {
    return Cosine::from_raw(wrap_shl(multiply_high(c.raw(), factor_), 1));
  }
  /// The closeness at c = 1.
  [[nodiscard]] constexpr std::int32_t reach() const { return reach_; }

  /// The largest channel of the highlight in 8-bit steps with 24 fraction bits. `closeness` is above 0; a
  /// larger one than reach(), of a cosine that rounding has raised above 1, counts as the largest.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t value(std::int32_t closeness) const {
    const std::uint32_t inside = clamped_unsigned<kReachBits, 0>(closeness);
    const std::uint32_t line = lines_[inside >> kIntervalBits];
    return line + (line & 0xFFFFu) * (inside >> (kIntervalBits - 16));
  }
  /// The colour whose largest channel is `most`, in 8-bit steps with 8 fraction bits; clamped to 255.
  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb colour(std::uint32_t most) const {
    const std::uint32_t white = (most >> 6) * white_;
    if (white != 0) [[likely]]
      return {white};
    return PackedRgb::of(channel(0, most) >> 6, channel(1, most) >> 6, channel(2, most) >> 6);
  }
  /// colour() of several highlights' sum, `most` is up to 4 * 255; each channel is clamped on its own.
  [[nodiscard]] ARCSPAN_OUTLINE ARCSPAN_COLD constexpr PackedRgb colour_of_sum(std::uint32_t most) const {
    const auto level = [&](std::size_t c) {
      return clamped_unsigned<10, 4>(static_cast<std::int32_t>(channel(c, most >> 2)));
    };
    return PackedRgb::of(level(0), level(1), level(2));
  }
  /// Channel `c` of colour(), in the same unit.
  [[nodiscard]] constexpr std::uint32_t channel(std::size_t c, std::uint32_t most) const {
    return (most * share_[c]) >> 15;
  }

 private:
  static constexpr std::uint32_t kIntervals = 128;
  static constexpr int kIntervalBits = 18;
  static_assert((kIntervals << kIntervalBits) == (std::uint32_t{1} << kReachBits));

  /// The line through the values at both ends of an interval: in the lower half of a word its rise over the
  /// interval, 8 fraction bits, in the upper half its value at closeness 0, modulo 2^16. As a part of a sum
  /// the lower half is below 2^-8 of a step.
  std::array<std::uint32_t, kIntervals> lines_{};
  std::uint32_t white_ = 0;               ///< 1 in all channels if these are equal, else 0
  std::array<std::uint32_t, 3> share_{};  ///< a channel's part of the largest one, 15 fraction bits
  std::int32_t factor_ = 0;               ///< 31 fraction bits
  std::int32_t reach_ = 0;
};

}  // namespace arcspan
