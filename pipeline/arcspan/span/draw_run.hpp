// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/keep.hpp>
#include <arcspan/pixel/format.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/span/code_table.hpp>
#include <arcspan/span/depth.hpp>

#include <concepts>
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

/// A run of whole words with the depth test: both rows by one index, which ends at 0.
template <class Target, class Run>
[[gnu::always_inline]] constexpr void draw_words(typename Target::Format::Code* codes, std::uint16_t* depths,
                                                 const Span& span, Run& run, const Target& target, Linear z,
                                                 Linear dz) {
  const typename Target::Object& object = target.object;
  const std::int32_t end = span.x + span.count;
  codes += span.count;
  depths += span.count;
  keep_as_is(codes);
  keep_as_is(depths);
  for (std::int32_t i = -span.count; i != 0; ++i) {
    keep_as_is(i);
    const auto nearness = static_cast<std::uint16_t>(z.raw() >> Linear::kFraction);
    if (nearness < depths[i]) [[likely]] {
      depths[i] = nearness;
      codes[i] = run_code<typename Target::Format>(run, object, target.codes, end + i, span.y);
    }
    z += dz;
    run.next();
  }
}

/// Draws one run of pixels: the codes of `run` through `cursor`, with the depth test of `Depth` against what
/// is at `depths`.
template <class Target, class Run>
[[gnu::always_inline]] constexpr void draw_run(typename Target::Format::Cursor cursor, std::uint16_t* depths,
                                               const Span& span, Run& run, const Target& target, Linear z,
                                               Linear dz) {
  using Format = typename Target::Format;
  constexpr bool kTests = Target::kTests;
  if constexpr (kManyRegisters && kTests && requires { cursor.codes(); }) {
    draw_words(cursor.codes(), depths, span, run, target, z, dz);
    return;
  }
  for (std::int32_t i = 0; i < span.count; ++i) {
    const auto nearness = static_cast<std::uint16_t>(z.raw() >> Linear::kFraction);
    if (!kTests || nearness < *depths) [[likely]] {
      if constexpr (kTests) *depths = nearness;
      cursor.write(run_code<Format>(run, target.object, target.codes, span.x + i, span.y));
    }
    if constexpr (kTests) {
      ++depths;
      z += dz;
    }
    cursor.next();
    run.next();
  }
}

/// The same for a run in segments.
template <class Target, SegmentedRun Run>
[[gnu::always_inline]] constexpr void draw_run(typename Target::Format::Cursor cursor, std::uint16_t* depths,
                                               const Span& span, Run& run, const Target& target, Linear z,
                                               Linear dz) {
  using Format = typename Target::Format;
  constexpr bool kTests = Target::kTests;
  std::int32_t x = span.x;
  const std::int32_t end = span.x + span.count;
  run.begin(target.object, span.count);
  while (x < end) {
    const std::int32_t pause = x + run.enter(target.object, end - x);
    for (; x < pause; ++x) {
      if constexpr (kTests) {
        const auto nearness = static_cast<std::uint16_t>(z.raw() >> Linear::kFraction);
        if (nearness < *depths) [[likely]] {
          *depths = nearness;
          cursor.write(encode_at<Format>(run.colour(), x, span.y));
        }
        ++depths;
        z += dz;
      } else {
        cursor.write(encode_at<Format>(run.colour(), x, span.y));
      }
      cursor.next();
      run.next();
    }
  }
}

}  // namespace arcspan::detail
