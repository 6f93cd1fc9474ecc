// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/shading/power_table.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// What a highlight adds to a pixel, by how far its cosine c is from 1: specular * c^n in a table with linear
/// interpolation. Distances are scaled so that PowerTable's reach is kReach, whatever the exponent: a pixel
/// takes an index and a fraction of them by two shifts.
class SpecularRamp {
 public:
  static constexpr std::int32_t kReach = std::int32_t{1} << 26;

  constexpr SpecularRamp() = default;

  /// `specular` has a coefficient per channel in 8-bit steps, 5 fraction bits, 0...255.
  constexpr SpecularRamp(const PowerTable& power, const std::array<std::uint32_t, 3>& specular) {
    const auto reach = static_cast<std::uint32_t>(power.half_reach());
    const int zeros = std::countl_zero(reach);
    up_ = zeros > 3 ? zeros - 3 : 0;
    scale_ = static_cast<std::int32_t>(((std::uint64_t{1} << 58) - 1) / (std::uint64_t{reach} << up_));
    const std::uint32_t most = largest_channel(specular);
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const auto distance = static_cast<std::uint32_t>((std::uint64_t{i} * reach) / kIntervals);
      const std::uint32_t inside = distance < reach ? distance : reach - 1;
      values_[i] =
          static_cast<std::uint16_t>((most * power(static_cast<std::int32_t>(inside)) + (1u << 11)) >> 12);
    }
    for (std::size_t c = 0; c < 3; ++c) share_[c] = most == 0 ? 0 : (specular[c] << 15) / most;
    grey_ = specular[0] == specular[1] && specular[1] == specular[2];
  }

  /// Whether (1 - c) / 2 with 30 fraction bits can be scaled: up to 4 times the reach, or 8, by the exponent.
  [[nodiscard]] constexpr bool fits(std::int32_t half_distance) const {
    return half_distance < (INT32_MAX >> up_);
  }
  /// Such a distance as operator() takes it.
  [[nodiscard]] constexpr std::int32_t scaled(std::int32_t half_distance) const {
    return multiply_high(wrap_shl(half_distance, up_), scale_);
  }

  /// What is added at a scaled distance below kReach; negative ones are cosines that rounding has lifted
  /// above 1.
  [[nodiscard, gnu::always_inline]] constexpr PackedRgb operator()(std::int32_t distance) const {
    constexpr int kFine = 8;
    constexpr int kIndexShift = 19;  // 2^26 / kIntervals
    const std::uint32_t inside = distance < 0 ? 0u : static_cast<std::uint32_t>(distance);
    const auto index = static_cast<std::size_t>(inside >> kIndexShift);
    const std::uint32_t fraction = (inside >> (kIndexShift - kFine)) & 0xFFu;
    const std::uint32_t here = values_[index];
    const std::uint32_t level = (here << kFine) - (here - values_[index + 1]) * fraction;  // 16 fraction bits
    if (grey_) return PackedRgb::grey(level >> 14);
    const auto share = [this, level](std::size_t c) { return ((level >> 8) * share_[c]) >> 21; };
    return PackedRgb::of(share(0), share(1), share(2));
  }

 private:
  static constexpr std::uint32_t kIntervals = 128;

  std::array<std::uint16_t, kIntervals + 1> values_{};  ///< 8 fraction bits of an 8-bit step
  bool grey_ = true;
  std::array<std::uint32_t, 3> share_{};  ///< of the largest channel, 15 fraction bits
  std::int32_t scale_ = 0;
  int up_ = 0;
};

}  // namespace arcspan
