// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/colour.hpp>
#include <arcspan/pixel/dither.hpp>
#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/span/row_memory.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace arcspan::detail {

/// Everything that the rows of a command are drawn with and into.
template <class LightingType, PixelSink SinkType, DepthTarget DepthType>
struct RowTarget {
  using Lighting = LightingType;
  using Sink = SinkType;
  using Depth = DepthType;
  using Format = typename Sink::Format;

  const Rect& scissor;  ///< the part of the picture that is drawn, within the bounds of sink and depth
  const Lighting& lighting;
  Sink& sink;
  const Depth& depth;
  bool crosses = true;  ///< the current triangle may leave the columns of the scissor
};

/// Where the next pixel of a row lies: its colour, its depth in memory, and the depth of the surface there.
template <class Target>
struct PixelPlace {
  typename Target::Format::Cursor cursor;
  std::uint16_t* depths;
  Linear z;
};

/// True if the pixels and the depths of a row are arrays that one index can serve. Where it would have to be
/// added to each address, two pointers take an instruction less per pixel.
template <class Target>
concept IndexedRows = kHasManyRegisters && kScalesIndices && bool{Target::Depth::kTests} &&
                      requires(typename Target::Format::Cursor cursor) {
  cursor.pixels();
};

/// True if the pixels of `Run` are masked or blended.
template <class Target, class Run>
inline constexpr bool kHasOperation = requires(const Run& run, const typename Target::Lighting& lighting) {
  requires MaskedColour<std::remove_cvref_t<decltype(run.colour(lighting))>> ||
      BlendedColour<std::remove_cvref_t<decltype(run.colour(lighting))>>;
};

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
    if constexpr (requires {
                    requires Format::kHasAlpha;
                    colour.over_alpha(below, below);
                  }) {
      if (below >> 24 != 255) return colour.over_alpha(encode_at<Format>(colour.packed(), x, y), below);
    }
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

/// Draws span.count pixels, at least one, each only if it passes the depth test: Target::Depth::passes().
/// `dz` is the gradient of the depth per pixel.
///
/// In indexed rows `place` is one past the last pixel, and the index counts from -span.count up to 0.
/// Elsewhere `place` is at the first pixel, and is moved to one past the last.
template <class Target, class Run>
ARCSPAN_INLINE constexpr void draw_pixels(PixelPlace<Target>& place, const Span& span, Run& run,
                                          const Target& target, Linear dz) {
  using Format = typename Target::Format;
  constexpr bool kTests = Target::Depth::kTests;
  constexpr bool kIndexed = IndexedRows<Target>;
  constexpr bool kLayered = LayeredRun<Run, typename Target::Lighting>;
  // Where a row has several pieces, gcc multiplies steps by the number of pixels behind each, if it knows it.
  constexpr bool kCountsByDepth =
      !kIndexed && kTests && (kLayered || kWalksWholeRows<Run, typename Target::Lighting>);
  static_assert(!kLayered || kTests, "fog needs the depth of each pixel: draw with a depth target");
  const std::int32_t origin = kIndexed ? span.x + span.count : span.x;
  [[maybe_unused]] typename Format::Encoded* pixels = nullptr;
  std::uint16_t* depths = place.depths;
  // A member that is hidden would stay in memory.
  std::uint16_t*& walked = kCountsByDepth ? depths : place.depths;
  if constexpr (kIndexed) {
    pixels = place.cursor.pixels();
    hide_value(pixels);  // otherwise gcc replaces the index by two pointers
    hide_value(depths);
  }
  const auto count = static_cast<std::ptrdiff_t>(span.count);
  const std::ptrdiff_t last = kIndexed ? 0 : count;
  std::ptrdiff_t i = last - count;
  if constexpr (requires { run.begin(target.lighting, span.x, span.y); })
    run.begin(target.lighting, span.x, span.y);
  do {  // tests at the end, which -Os would not move there
    std::ptrdiff_t stop = last;
    if constexpr (kLayered) {
      const auto left = static_cast<std::int32_t>(last - i);
      stop = i + static_cast<std::ptrdiff_t>(
                     run.template enter_layer<kOperates565<Format>>(target.lighting, place.z, dz, left));
    }
    [[maybe_unused]] const std::uint16_t* end = nullptr;
    if constexpr (kCountsByDepth) end = depths + (stop - i);
    do {
      if constexpr (kIndexed) hide_value(i);
      const std::uint16_t depth = depth_of(place.z);
      std::uint16_t* const stored = kIndexed ? depths + i : walked;
      if (!kTests || Target::Depth::passes(depth, *stored)) [[likely]] {
        const std::int32_t x = origin + static_cast<std::int32_t>(i);
        if constexpr (kHasOperation<Target, Run>) {
          if constexpr (kIndexed) hide_value(i);  // otherwise gcc doubles it for every pixel, drawn or not
          const auto colour = run.colour(target.lighting);
          if constexpr (kIndexed) {
            draw_operated<Target>(colour, typename Format::Cursor(pixels + i, 0), depths + i, depth, x,
                                  span.y);
          } else {
            draw_operated<Target>(colour, place.cursor, stored, depth, x, span.y);
          }
        } else {
          if constexpr (kTests && Target::Depth::kWrites) *stored = depth;
          const auto encoded = encode_at<Format>(run.colour(target.lighting), x, span.y);
          if constexpr (kIndexed) {
            pixels[i] = encoded;
          } else {
            place.cursor.write(encoded);
          }
        }
      }
      if constexpr (!kIndexed && kTests) ++walked;
      if constexpr (kTests) place.z += dz;
      if constexpr (!kIndexed) place.cursor.next();
      run.next();
      ++i;
      if constexpr (kCountsByDepth) hide_value<true>(depths);
    } while (kCountsByDepth ? depths != end : i != stop);
  } while (kLayered && i != last);
  if constexpr (kCountsByDepth) place.depths = depths;
}

/// Draws the pixels of `run`, which begins at the first pixel of `span`, in the current row of `memory` or
/// `below` rows under it. `z` is the depth of the first pixel, `dz` its gradient.
template <class Target, class Run>
[[nodiscard]] ARCSPAN_INLINE constexpr Status draw_span(const Span& span, Run& run, Linear z, Linear dz,
                                                        const Target& target, const RowMemory<Target>& memory,
                                                        std::int32_t below = 0) {
  static_assert(!PiecewiseRun<Run, typename Target::Lighting>, "draw_pieces() draws these");
  if constexpr (IndexedRows<Target>) {
    PixelPlace<Target> place{memory.pixels.behind(span, below), memory.depths.behind(span, below), z};
    draw_pixels(place, span, run, target, dz);
  } else {
    PixelPlace<Target> place{memory.pixels.open(span, below), memory.depths.at(span, below), z};
    draw_pixels(place, span, run, target, dz);
  }
  return target.sink.close(span);
}

/// draw_span() of a PiecewiseRun, in the current row of `memory`. The run begins `hidden` pixels left of the
/// span, and its row ends `beyond` pixels right of it: both are 0 if it starts anywhere.
template <class Target, class Run>
[[nodiscard]] ARCSPAN_INLINE constexpr Status draw_pieces(const Span& span, std::int32_t hidden,
                                                          std::int32_t beyond, Run& run, Linear z, Linear dz,
                                                          const Target& target,
                                                          const RowMemory<Target>& memory) {
  PixelPlace<Target> place{memory.pixels.open(span), memory.depths.at(span), z};
  std::int32_t left = hidden + span.count + beyond;
  do {
    std::int32_t count = run.enter(target.lighting, left);
    left -= count;
    if (hidden != 0) [[unlikely]] {
      const std::int32_t passed = count < hidden ? count : hidden;
      for (std::int32_t i = passed; i > 0; --i) run.next();
      hidden -= passed;
      count -= passed;
      if (count == 0) continue;
    }
    const std::int32_t behind = left - beyond;  // pixels of the span behind this piece
    if (behind < 0) [[unlikely]]
      count += behind;
    if constexpr (IndexedRows<Target>) {
      place.cursor.skip(count);
      place.depths += count;
    }
    const std::int32_t end = span.x + span.count - (behind < 0 ? 0 : behind);
    draw_pixels(place, {span.y, end - count, count}, run, target, dz);
  } while (left > beyond);
  return target.sink.close(span);
}

}  // namespace arcspan::detail
