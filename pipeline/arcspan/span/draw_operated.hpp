// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/colour.hpp>
#include <arcspan/pixel/dither.hpp>
#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/target.hpp>

#include <cstdint>
#include <type_traits>
#include <utility>

namespace arcspan::detail {

/// True if the pixels of `Run` are masked or blended.
template <class Target, class Run>
inline constexpr bool kHasOperation = [] {
  if constexpr (requires(const Run& run, const typename Target::Lighting& lighting) {
                  run.colour(lighting);
                }) {
    using Shade = std::remove_cvref_t<decltype(std::declval<const Run&>().colour(
        std::declval<const typename Target::Lighting&>()))>;
    return MaskedColour<Shade> || BlendedColour<Shade>;
  }
  return false;
}();

/// The pixel of a colour, at (x, y) of the picture, where `below` is now.
template <class Format, class Shade>
[[nodiscard]] ARCSPAN_INLINE constexpr typename Format::Encoded operated(const Shade& colour,
                                                                         typename Format::Encoded below,
                                                                         std::int32_t x, std::int32_t y) {
  if constexpr (!BlendedColour<Shade>) {
    return encode_at<Format>(colour, x, y);
  } else if constexpr (kOperates565<Format>) {
    return Format::word565(colour.over565(Format::word565(below)));
  } else {
    return encode_at<Format>(colour.over(PackedRgb::of(Format::decode(below))), dithered_again_at(x),
                             dithered_again_at(y));
  }
}

/// Draws a pixel that has passed the depth test, at (x, y) of the picture: unless it is masked, blended with
/// what is at the cursor.
template <class Target, class Shade>
ARCSPAN_INLINE constexpr void draw_operated(const Shade& colour, typename Target::Format::Cursor cursor,
                                            std::uint16_t* stored, std::uint16_t depth, std::int32_t x,
                                            std::int32_t y) {
  using Format = typename Target::Format;
  if constexpr (MaskedColour<Shade>) {
    if (!colour.covers(x, y)) return;
  }
  if constexpr (Target::Depth::kTests && Target::Depth::kWrites) *stored = depth;
  cursor.write(operated<Format>(colour, cursor.read(), x, y));
}

}  // namespace arcspan::detail
