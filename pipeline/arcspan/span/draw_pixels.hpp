// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/prepare/linear.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/span/draw_operated.hpp>
#include <arcspan/span/encoded_colours.hpp>
#include <arcspan/span/indexed_rows.hpp>
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

/// True if the pixels of `Run` are looked up in a table of encoded colours. Segments have no N·L to look up.
template <class Target, class Run>
inline constexpr bool kLooksUpColours =
    !std::same_as<typename Target::Colours, NoEncodedColours> && !std::same_as<Run, SegmentPixels>;

/// Returns the depth of the next pixel: that of `run` if it carries one (CarriesDepth), else that of `place`.
template <class Target, class Run>
[[nodiscard]] ARCSPAN_INLINE constexpr Linear pixel_depth(const PixelPlace<Target>& place, const Run& run) {
  if constexpr (CarriesDepth<Run>) return run.depth();
  return place.z;
}

/// Returns the index of a span's first pixel in indexed rows. Used on 64-bit machines only; 0 on others.
[[nodiscard]] ARCSPAN_INLINE constexpr std::ptrdiff_t first_index(const Span& span) {
  return kHasWideRegisters ? -static_cast<std::ptrdiff_t>(span.count) : 0;
}

/// Draws span.count pixels, at least one, each only if it passes the depth test: Target::Depth::passes().
/// `dz` is the gradient of the depth per pixel.
///
/// In indexed rows `place` is one past the last pixel, and the index counts from -span.count to 0. Elsewhere
/// `place` is at the first pixel, and is moved to one past the last. `first` is first_index(span), which a
/// caller may know already.
template <class Target, class Run>
ARCSPAN_INLINE constexpr void draw_pixels(PixelPlace<Target>& place, const Span& span, Run& run,
                                          const Target& shared, Linear dz, std::ptrdiff_t first) {
  using Format = typename Target::Format;
  const CopyIfFewRegisters<Target> target = shared;
  constexpr bool kTests = Target::Depth::kTests;
  constexpr bool kIndexed = IndexedRows<Target>;
  const std::int32_t origin = kIndexed ? span.x + span.count : span.x;
  [[maybe_unused]] typename Format::Encoded* pixels = nullptr;
  std::uint16_t* depths = place.depths;
  if constexpr (kIndexed) {
    pixels = place.cursor.pixels();
    hide_value(pixels);
    hide_value(depths);
  }
  constexpr int kShift = kIndexed ? kIndexShift<Format, Run> : 0;
  // Small cores compute the count here, where its register is free.
  const std::ptrdiff_t count = kHasWideRegisters ? -first : static_cast<std::ptrdiff_t>(span.count);
  const std::ptrdiff_t last = kIndexed ? 0 : count;
  // A test at the end, which -Os would not move there.
  std::ptrdiff_t i = kIndexed ? -count * (1 << kShift) : 0;
  do {
    if constexpr (kIndexed && !kHasWideRegisters) hide_value(i);
    const std::uint16_t depth = depth_of(pixel_depth(place, run));
    std::uint16_t* const stored = kIndexed ? at_index<kShift>(depths, i) : place.depths;
    if (!kTests || Target::Depth::passes(depth, *stored)) [[likely]] {
      if constexpr (kHasOperation<Target, Run>) {
        const std::int32_t x = origin + static_cast<std::int32_t>(i >> kShift);
        const auto colour = run.colour(target.lighting);
        if constexpr (kIndexed) {
          draw_operated<Target>(colour, typename Format::Cursor(at_index<kShift>(pixels, i), 0), stored,
                                depth, x, span.y);
        } else {
          draw_operated<Target>(colour, place.cursor, stored, depth, x, span.y);
        }
      } else {
        if constexpr (kTests && Target::Depth::kWrites) *stored = depth;
        typename Format::Encoded encoded;
        if constexpr (kLooksUpColours<Target, Run>) {
          encoded = run.template encoded<Format>(target.lighting, target.encoded);
        } else if constexpr (kEncodesVarying<Format, Run, typename Target::Lighting>) {
          encoded = Format::encode_varying(run.colour(target.lighting));
        } else {
          encoded = encode_at<Format>(run.colour(target.lighting),
                                      origin + static_cast<std::int32_t>(i >> kShift), span.y);
        }
        if constexpr (kIndexed) {
          *at_index<kShift>(pixels, i) = encoded;
        } else {
          place.cursor.write(encoded);
        }
      }
    }
    if constexpr (!kIndexed && kTests) ++place.depths;
    if constexpr (kTests && !CarriesDepth<Run>) place.z += dz;
    if constexpr (!kIndexed) place.cursor.next();
    run.next();
  } while ((i += 1 << kShift) != last);
}

}  // namespace arcspan::detail
