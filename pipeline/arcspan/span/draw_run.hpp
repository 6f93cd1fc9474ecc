// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/keep.hpp>
#include <arcspan/pixel/format.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/span/code_table.hpp>
#include <arcspan/span/depth.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace arcspan::detail {

/// The code of a run's present pixel.
template <class Format, class Run, class Object, class Codes>
[[nodiscard, gnu::always_inline]] constexpr typename Format::Code run_code(const Run& run,
                                                                           const Object& object,
                                                                           const Codes& codes, std::int32_t x,
                                                                           std::int32_t y) {
  if constexpr (requires { run.template code<Format>(object, codes); } && !std::same_as<Codes, NoCodes>) {
    return run.template code<Format>(object, codes);
  } else {
    return encode_at<Format>(run.colour(object), x, y);
  }
}

/// What the rows of a command are drawn with and into.
template <class ObjectOf, PixelSink SinkOf, DepthTarget DepthOf, class CodesOf = NoCodes>
struct RowTarget {
  using Object = ObjectOf;
  using Codes = CodesOf;
  using Sink = SinkOf;
  using Depth = DepthOf;
  using Format = typename Sink::Format;
  static constexpr bool kTests = Depth::kTests;

  const Rect& clip;
  const Object& object;
  Sink& sink;
  const Depth& depth;
  const Codes& codes;
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
concept DrawsWords = kManyRegisters && bool{Target::kTests} && !SegmentedRun<Run> &&
                     requires(typename Target::Format::Cursor cursor) {
  cursor.codes();
};

/// Pixels of whole words with the depth test: both rows by one index, which ends at 0. The addresses are
/// those behind the last pixel.
template <class Target, class Run>
[[gnu::always_inline]] constexpr void draw_words(typename Target::Format::Code* codes, std::uint16_t* depths,
                                                 Linear& z, const Span& span, Run& run, const Target& target,
                                                 Linear dz) {
  const typename Target::Object& object = target.object;
  const std::int32_t end = span.x + span.count;
  keep_as_is(codes);
  keep_as_is(depths);
  for (auto i = static_cast<std::ptrdiff_t>(-span.count); i != 0; ++i) {
    if constexpr (sizeof(void*) <= 4) keep_as_is(i);  // longer ones need no help
    const auto nearness = static_cast<std::uint16_t>(z.raw() >> Linear::kFraction);
    if (nearness < depths[i]) [[likely]] {
      depths[i] = nearness;
      codes[i] = run_code<typename Target::Format>(run, object, target.codes,
                                                   end + static_cast<std::int32_t>(i), span.y);
    }
    z += dz;
    run.next();
  }
}

/// Draws the pixels of `run` and goes on to the place behind them.
template <class Target, class Run>
[[gnu::always_inline]] constexpr void draw_pixels(RowPlace<Target>& place, const Span& span, Run& run,
                                                  const Target& target, Linear dz) {
  using Format = typename Target::Format;
  constexpr bool kTests = Target::kTests;
  if constexpr (DrawsWords<Target, Run>) {
    place.cursor.skip(span.count);
    place.depths += span.count;
    draw_words(place.cursor.codes(), place.depths, place.z, span, run, target, dz);
    return;
  }
  for (std::int32_t i = 0; i < span.count; ++i) {
    const auto nearness = static_cast<std::uint16_t>(place.z.raw() >> Linear::kFraction);
    if (!kTests || nearness < *place.depths) [[likely]] {
      if constexpr (kTests) *place.depths = nearness;
      place.cursor.write(run_code<Format>(run, target.object, target.codes, span.x + i, span.y));
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
[[gnu::always_inline]] constexpr void draw_run(RowPlace<Target> place, const Span& span, Run& run,
                                               const Target& target, Linear dz) {
  if constexpr (SegmentedRun<Run>) {
    run.begin(target.object, span.count);
    for (std::int32_t left = span.count; left > 0;) {
      const std::int32_t count = run.enter(target.object, left);
      auto colours = run.segment();
      draw_pixels(place, {span.y, span.x + span.count - left, count}, colours, target, dz);
      left -= count;
    }
  } else {
    draw_pixels(place, span, run, target, dz);
  }
}

}  // namespace arcspan::detail
