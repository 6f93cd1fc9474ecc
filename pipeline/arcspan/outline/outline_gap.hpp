// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/pixel_format.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

namespace detail {

/// Where the pixel of the surface lies, as seen from the pixel outside of the outline.
enum class GapPlace : std::uint8_t { kRight, kLeft, kBelow, kAbove };

[[nodiscard]] constexpr GapPlace opposite(GapPlace place) {
  return static_cast<GapPlace>(static_cast<std::uint8_t>(place) ^ 1u);
}
[[nodiscard]] constexpr std::int32_t column_step(GapPlace place) {
  return place == GapPlace::kRight ? 1 : place == GapPlace::kLeft ? -1 : 0;
}
[[nodiscard]] constexpr std::int32_t row_step(GapPlace place) {
  return place == GapPlace::kBelow ? 1 : place == GapPlace::kAbove ? -1 : 0;
}

}  // namespace detail

/// A place where an outline runs between the centres of two neighbouring pixels: an element of the memory of
/// smooth_outlines(), which has no need of its contents. 12 bytes with pixels of up to 16 bits, 16 with 32.
template <PixelFormat F>
struct OutlineGap {
  /// What the list needs: the depth of the pixel outside, and the number of the next gap of that pixel.
  struct InList {
    std::uint16_t depth;
    std::uint16_t next;
  };
  /// What blending needs, afterwards: the pixels as they were.
  struct InBlending {
    typename F::Encoded outer;
    typename F::Encoded inner;
  };
  union Held {
    InList list;
    InBlending blending;
  };

  std::int16_t x;  ///< the pixel outside
  std::int16_t y;
  Held held;
  std::int8_t outward;  ///< of the outline from the middle of both centres, towards the outer one: -16...16 / 32
  std::uint8_t corner;  ///< share of the pixel that the outline only cuts a corner of, in 32nds
  detail::GapPlace place;
};

}  // namespace arcspan
