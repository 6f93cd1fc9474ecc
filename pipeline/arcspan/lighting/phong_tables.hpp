// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination_features.hpp>
#include <arcspan/lighting/power_table.hpp>
#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace arcspan {

/// Look-up tables for pixels with a highlight, on machines with wide registers and for R·V of one light (5 KB
/// per illumination).
class PhongTables {
 public:
  constexpr void make_tables(const std::array<PackedRgb, 256>& ramp, const PowerTable& power, bool is_white) {
    white_reach_ = is_white ? static_cast<std::uint32_t>(power.half_reach()) : 0;
    lines_ = PowerLines(power);
    for (std::size_t i = 1; i < lit_.size() / 2; ++i) lit_[i] = ramp[i < ramp.size() ? i : ramp.size() - 1];
    for (std::size_t i = lit_.size() / 2; i < lit_.size(); ++i) lit_[i] = PackedRgb::carry();
    lit_[0] = PackedRgb::carry();
  }

  /// The diffuse colour, by the top 10 bits of any N·L; PackedRgb::carry() if N·L is not known to be above 0,
  /// so that the test for saturation finds it.
  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb lit(Cosine normal_light) const {
    return lit_[static_cast<std::uint32_t>(normal_light.raw()) >> (32 - kBits)];
  }
  /// True if lit() is a colour.
  [[nodiscard]] static constexpr bool is_lit(Cosine normal_light) {
    return (normal_light.raw() >> (32 - kBits)) > 0;
  }
  /// PowerTable::half_reach() if highlights are equal in all channels, else 0.
  [[nodiscard]] constexpr std::uint32_t white_reach() const { return white_reach_; }
  /// PowerTable::at_distance().
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t power(std::uint32_t half_distance) const {
    return lines_.at_distance(half_distance);
  }

 private:
  static constexpr int kBits = 10;

  std::uint32_t white_reach_ = 0;
  PowerLines lines_{};
  std::array<PackedRgb, std::size_t{1} << kBits> lit_{};
};

/// True if Illumination has PhongTables.
template <std::size_t Lights, Highlight Model>
inline constexpr bool kHasPhongTables = kHasWideRegisters && (Lights == 1 && Model == Highlight::kPhong);

/// Used where there are no such tables.
struct NoPhongTables {};

/// The tables of an illumination: a base class, because an empty one takes no bytes.
template <bool kHasTables>
using PhongTablesFor = std::conditional_t<kHasTables, PhongTables, NoPhongTables>;

}  // namespace arcspan
