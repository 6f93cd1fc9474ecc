// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>

#include <array>
#include <cstdint>

namespace arcspan {

/// A point of world space: right-handed axes, any unit of length. Objects, cameras and point lights are
/// placed in it.
struct WorldPoint {
  WorldLength x{};
  WorldLength y{};
  WorldLength z{};

  /// A constant from decimal literals. One out of range does not compile.
  [[nodiscard]] static consteval WorldPoint of(double x, double y, double z) {
    return {WorldLength::of(x), WorldLength::of(y), WorldLength::of(z)};
  }
  friend constexpr bool operator==(const WorldPoint&, const WorldPoint&) = default;
};

namespace detail {

/// b - a, 16 fraction bits, below 2^32 in magnitude.
[[nodiscard]] constexpr std::array<std::int64_t, 3> difference(const WorldPoint& a, const WorldPoint& b) {
  return {std::int64_t{b.x.raw()} - a.x.raw(), std::int64_t{b.y.raw()} - a.y.raw(),
          std::int64_t{b.z.raw()} - a.z.raw()};
}

}  // namespace detail

}  // namespace arcspan
