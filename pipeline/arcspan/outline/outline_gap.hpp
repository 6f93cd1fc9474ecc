// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/target.hpp>

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

/// From the pixel outside to that of the surface, as OutlinePixel::column_row has them.
[[nodiscard]] constexpr std::uint32_t inward_step(GapPlace place) {
  return static_cast<std::uint32_t>(column_step(place) + row_step(place) * 65536);
}

/// The pixels of a gap as they were before blending.
template <PixelFormat F>
struct GapColours {
  typename F::Encoded outer;
  typename F::Encoded inner;
};

}  // namespace detail

/// A place where an outline runs between the centres of two neighbouring pixels: an element of the memory of
/// smooth_outlines(), which has no need of its contents. 10 bytes with pixels of up to 16 bits, 16 with 32.
template <PixelFormat F>
struct OutlineGap {
  /// What the list needs: the depth of the pixel outside, and the number of the next gap of that pixel.
  struct InList {
    std::uint16_t depth;
    std::uint16_t next;
  };
  /// @cond for smooth_outlines(), not in the reference
  /// First what the list needs, then what blending needs.
  union Held {
    InList list{};
    detail::GapColours<F> colours;
  };
  /// @endcond

  std::int16_t x = 0;  ///< the pixel outside
  std::int16_t y = 0;
  Held held{};
  std::uint16_t outline = 0;  ///< where it runs; greater values are farther outward

  /// @cond for smooth_outlines(), not in the reference
  /// Whether it is a gap of this pixel, as OutlinePixel::column_row has it.
  [[nodiscard]] ARCSPAN_INLINE constexpr bool is_of(std::uint32_t pixel) const {
    return (static_cast<std::uint16_t>(x) | std::uint32_t{static_cast<std::uint16_t>(y)} << 16) == pixel;
  }
  /// @endcond
};

namespace detail {

/// Where the outline runs in a gap.
struct GapOutline {
  GapPlace place;
  std::uint32_t outward;  ///< from the centre of the inner pixel to that of the outer one, 0...32
  std::uint32_t corner;   ///< the share of the farther pixel that it cuts off, 0...4 in 32nds

  /// The share in 32nds of the outer pixel that is inside.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t of_outer() const {
    return outward > kMiddle ? outward - kMiddle + corner : corner;
  }
  /// The share in 32nds of the inner pixel that is outside.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t of_inner() const {
    return outward < kMiddle ? kMiddle - outward + corner : corner;
  }

  /// All in one word; greater ones are farther outward.
  [[nodiscard]] constexpr std::uint16_t word() const {
    return static_cast<std::uint16_t>(outward << 5 | corner << 2 | static_cast<std::uint32_t>(place));
  }
  [[nodiscard]] static constexpr GapPlace place_of(std::uint16_t word) {
    return static_cast<GapPlace>(word & 3u);
  }
  [[nodiscard]] static constexpr GapOutline of(std::uint16_t word) {
    return {place_of(word), std::uint32_t{word} >> 5, (std::uint32_t{word} >> 2) & 7u};
  }

  static constexpr std::uint32_t kMiddle = 16;
};

}  // namespace detail

}  // namespace arcspan
