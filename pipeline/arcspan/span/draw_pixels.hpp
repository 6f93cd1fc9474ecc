// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/prepare/linear.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/span/encoded_colours.hpp>
#include <arcspan/target.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>

namespace arcspan::detail {

/// Everything that the rows of a command are drawn with and into.
template <class LightingType, PixelSink SinkType, DepthTarget DepthType, class ColoursType = NoEncodedColours>
struct RowTarget {
  using Lighting = LightingType;
  using Sink = SinkType;
  using Depth = DepthType;
  using Colours = ColoursType;
  using Format = typename Sink::Format;

  const Rect& scissor;  ///< the part of the picture that is drawn, within the bounds of sink and depth
  const Lighting& lighting;
  Sink& sink;
  const Depth& depth;
  const Colours& encoded;
};

/// Where the next pixel of a row lies: its colour, its depth in memory, and the depth of the surface there.
template <class Target>
struct PixelPlace {
  typename Target::Format::Cursor cursor;
  std::uint16_t* depths;
  Linear z;
};

/// The encoded colour of the run's current pixel, which is at column x of row y.
template <class Target, class Run>
[[nodiscard]] ARCSPAN_INLINE constexpr typename Target::Format::Encoded encoded_colour(const Run& run,
                                                                                       const Target& target,
                                                                                       std::int32_t x,
                                                                                       std::int32_t y) {
  using Format = typename Target::Format;
  if constexpr (std::same_as<typename Target::Colours, NoEncodedColours> ||
                std::same_as<Run, SegmentPixels>) {
    return encode_at<Format>(run.colour(target.lighting), x, y);
  } else {
    static_assert(EncodingRun<Run, Format, typename Target::Lighting, typename Target::Colours>,
                  "a method that uses encoded colours (kUsesEncodedColours) has runs with encoded()");
    return run.template encoded<Format>(target.lighting, target.encoded);
  }
}

/// True if pixels and depths of a row are arrays that one index can serve.
template <class Target>
concept IndexedRows = kHasManyRegisters && bool{Target::Depth::kTests} &&
                      requires(typename Target::Format::Cursor cursor) {
  cursor.pixels();
};

/// Draws span.count pixels from `place` on, each only if it is_nearer() than the depth buffer where there is
/// one, and moves `place` behind them. `dz` is the depth's gradient per pixel.
template <class Target, class Run>
ARCSPAN_INLINE constexpr void draw_pixels(PixelPlace<Target>& place, const Span& span, Run& run,
                                          const Target& target, Linear dz) {
  if constexpr (IndexedRows<Target>) {
    // One index into both rows that runs up to 0 takes the fewest instructions: it is the loop counter as
    // well.
    place.cursor.skip(span.count);
    place.depths += span.count;
    auto* pixels = place.cursor.pixels();
    std::uint16_t* depths = place.depths;
    const std::int32_t end = span.x + span.count;
    hide_value(pixels);
    hide_value(depths);
    for (auto i = static_cast<std::ptrdiff_t>(-span.count); i != 0; ++i) {
      if constexpr (!kHasWideRegisters) hide_value(i);
      const std::uint16_t depth = depth_of(place.z);
      if (is_nearer(depth, depths[i])) [[likely]] {
        depths[i] = depth;
        pixels[i] = encoded_colour(run, target, end + static_cast<std::int32_t>(i), span.y);
      }
      place.z += dz;
      run.next();
    }
    return;
  }
  constexpr bool kTests = Target::Depth::kTests;
  for (std::int32_t i = 0; i < span.count; ++i) {
    const std::uint16_t depth = depth_of(place.z);
    if (!kTests || is_nearer(depth, *place.depths)) [[likely]] {
      if constexpr (kTests) *place.depths = depth;
      place.cursor.write(encoded_colour(run, target, span.x + i, span.y));
    }
    if constexpr (kTests) {
      ++place.depths;
      place.z += dz;
    }
    place.cursor.next();
    run.next();
  }
}

/// Draws a run that consists of segments with linear colours (SegmentedRun).
template <class Target, class Run>
ARCSPAN_INLINE constexpr void draw_segments(PixelPlace<Target>& place, const Span& span, Run& run,
                                            const Target& target, Linear dz) {
  run.begin(target.lighting, span.count);
  for (std::int32_t left = span.count; left > 0;) {
    const std::int32_t count = run.enter(target.lighting, left);
    auto segment = run.segment();
    draw_pixels(place, {span.y, span.x + span.count - left, count}, segment, target, dz);
    left -= count;
  }
}

}  // namespace arcspan::detail
