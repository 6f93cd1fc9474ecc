// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// A point of a texture. `u` runs to the right and `v` down from the top left corner, in widths and heights
/// of the texture with TextureScale::fraction_bits fraction bits. Outside 0...1 TextureWrap says what is
/// shown.
struct TexturePoint {
  std::int16_t u = 0;
  std::int16_t v = 0;

  friend constexpr bool operator==(const TexturePoint&, const TexturePoint&) = default;
};

/// The fraction bits of a mesh's texture points, 4...15: with 12, points reach from -8 to 8 in steps
/// of 1/4096.
struct TextureScale {
  static constexpr std::uint8_t kLeastBits = 4;
  static constexpr std::uint8_t kMostBits = 15;

  std::uint8_t fraction_bits = 12;

  friend constexpr bool operator==(const TextureScale&, const TextureScale&) = default;
};

}  // namespace arcspan
