// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/span/encoded_colours.hpp>
#include <arcspan/target.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace arcspan::detail {

/// The code of a run's present pixel.
template <class Format, class Run, class Lighting, class Colours>
[[nodiscard]] ARCSPAN_INLINE constexpr typename Format::Encoded encode_pixel(const Run& run,
                                                                             const Lighting& lighting,
                                                                             const Colours& encoded,
                                                                             std::int32_t x, std::int32_t y) {
  if constexpr (requires { run.template encoded<Format>(lighting, encoded); } &&
                !std::same_as<Colours, NoEncodedColours>) {
    return run.template encoded<Format>(lighting, encoded);
  } else {
    return encode_at<Format>(run.colour(lighting), x, y);
  }
}

/// What the rows of a command are drawn with and into.
template <class LightingOf, PixelSink SinkOf, DepthTarget DepthOf, class EncodedColoursOf = NoEncodedColours>
struct RowTarget {
  using Lighting = LightingOf;
  using Colours = EncodedColoursOf;
  using Sink = SinkOf;
  using Depth = DepthOf;
  using Format = typename Sink::Format;
  static constexpr bool kTests = Depth::kTests;

  const Rect& clip;
  const Lighting& lighting;
  Sink& sink;
  const Depth& depth;
  const Colours& encoded;
};

/// Where a row's next pixel is drawn.
template <class Target>
struct RowPlace {
  typename Target::Format::Cursor cursor;
  std::uint16_t* depths;
  Linear z;
};

/// Whether runs of pixels are for draw_words(). Segments are runs of their own within a run.
template <class Target, class Run>
concept DrawsWords = kHasManyRegisters && bool{Target::kTests} && !SegmentedRun<Run> &&
                     requires(typename Target::Format::Cursor cursor) {
  cursor.pixels();
};

/// Pixels of whole words with the depth test: both rows by one index, which ends at 0. The addresses are
/// those behind the last pixel.
template <class Target, class Run>
ARCSPAN_INLINE constexpr void draw_words(typename Target::Format::Encoded* pixels, std::uint16_t* depths,
                                         Linear& z, const Span& span, Run& run, const Target& target,
                                         Linear dz) {
  const typename Target::Lighting& lighting = target.lighting;
  const std::int32_t end = span.x + span.count;
  hide_value(pixels);
  hide_value(depths);
  for (auto i = static_cast<std::ptrdiff_t>(-span.count); i != 0; ++i) {
    if constexpr (sizeof(void*) <= 4) hide_value(i);  // longer ones need no help
    const auto depth = static_cast<std::uint16_t>(z.raw() >> Linear::kFraction);
    if (depth < depths[i]) [[likely]] {
      depths[i] = depth;
      pixels[i] = encode_pixel<typename Target::Format>(run, lighting, target.encoded,
                                                        end + static_cast<std::int32_t>(i), span.y);
    }
    z += dz;
    run.next();
  }
}

/// Draws the pixels of `run` and goes on to the place behind them.
template <class Target, class Run>
ARCSPAN_INLINE constexpr void draw_pixels(RowPlace<Target>& place, const Span& span, Run& run,
                                          const Target& target, Linear dz) {
  using Format = typename Target::Format;
  constexpr bool kTests = Target::kTests;
  if constexpr (DrawsWords<Target, Run>) {
    place.cursor.skip(span.count);
    place.depths += span.count;
    draw_words(place.cursor.pixels(), place.depths, place.z, span, run, target, dz);
    return;
  }
  for (std::int32_t i = 0; i < span.count; ++i) {
    const auto depth = static_cast<std::uint16_t>(place.z.raw() >> Linear::kFraction);
    if (!kTests || depth < *place.depths) [[likely]] {
      if constexpr (kTests) *place.depths = depth;
      place.cursor.write(encode_pixel<Format>(run, target.lighting, target.encoded, span.x + i, span.y));
    }
    if constexpr (kTests) {
      ++place.depths;
      place.z += dz;
    }
    place.cursor.next();
    run.next();
  }
}

/// Draws one run of pixels from `place` on, with the depth test of `Depth`.
template <class Target, class Run>
ARCSPAN_INLINE constexpr void draw_run(RowPlace<Target> place, const Span& span, Run& run,
                                       const Target& target, Linear dz) {
  if constexpr (SegmentedRun<Run>) {
    run.begin(target.lighting, span.count);
    for (std::int32_t left = span.count; left > 0;) {
      const std::int32_t count = run.enter(target.lighting, left);
      auto colours = run.segment();
      draw_pixels(place, {span.y, span.x + span.count - left, count}, colours, target, dz);
      left -= count;
    }
  } else {
    draw_pixels(place, span, run, target, dz);
  }
}

}  // namespace arcspan::detail
