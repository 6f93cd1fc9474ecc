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
/// smooth_outlines(), which has no need of its contents. 10 bytes with pixels of up to 16 bits, 16 with 32.
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
  /// One after the other.
  union Held {
    InList list;
    InBlending blending;

    constexpr Held() : list{} {}
    constexpr explicit Held(const InList& l) : list(l) {}
    constexpr explicit Held(const InBlending& b) : blending(b) {}
  };

  std::int16_t x;  ///< the pixel outside
  std::int16_t y;
  Held held{};
  std::uint16_t outline;  ///< where it runs; greater values are farther outward
};

namespace detail {

/// Where the outline runs in a gap, in one word: greater ones are farther outward.
class GapOutline {
 public:
  /// `outward`: its distance from the middle of both centres, towards the outer one, -16...16 in 32nds of a
  /// pixel. `corner`: the share of the farther pixel that it cuts off, 0...4 in 32nds.
  constexpr GapOutline(GapPlace place, std::int32_t outward, std::uint32_t corner)
      : word_((static_cast<std::uint32_t>(outward + 16) << 5) | (corner << 2) |
              static_cast<std::uint32_t>(place)) {}
  constexpr explicit GapOutline(std::uint16_t word) : word_(word) {}

  [[nodiscard]] constexpr std::uint16_t word() const { return static_cast<std::uint16_t>(word_); }
  [[nodiscard]] constexpr GapPlace place() const { return static_cast<GapPlace>(word_ & 3u); }
  [[nodiscard]] constexpr std::uint32_t corner() const { return (word_ >> 2) & 7u; }
  [[nodiscard]] constexpr std::int32_t outward() const { return static_cast<std::int32_t>(word_ >> 5) - 16; }

 private:
  std::uint32_t word_;
};

}  // namespace detail

}  // namespace arcspan
