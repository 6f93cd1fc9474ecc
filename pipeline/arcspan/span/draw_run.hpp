// SPDX-License-Identifier: MIT
#pragma once

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
template <class ObjectOf, PixelSink Sink, DepthTarget Depth, class CodesOf = NoCodes>
struct RowTarget {
  using Object = ObjectOf;
  using Codes = CodesOf;
  using Format = typename Sink::Format;

  const Rect& clip;
  const Object& object;
  Sink& sink;
  const Depth& depth;
  const Codes& codes;
};

/// Draws one run of pixels: the codes of `run` through `cursor`, with the depth test of `Depth`.
template <class Target, class Run>
[[gnu::always_inline]] constexpr void draw_run(typename Target::Format::Cursor cursor, const Span& span,
                                               Run& run, const Target& target, Linear z, Linear dz) {
  using Format = typename Target::Format;
  constexpr bool kTests = std::remove_cvref_t<decltype(target.depth)>::kTests;
  [[maybe_unused]] std::uint16_t* at = nullptr;
  if constexpr (kTests) at = target.depth.row(span.y) + span.x;
  for (std::int32_t i = 0; i < span.count; ++i) {
    if constexpr (kTests) {
      const auto nearness = static_cast<std::uint16_t>(z.raw() >> Linear::kFraction);
      if (nearness < *at) [[likely]] {
        *at = nearness;
        cursor.write(run_code<Format>(run, target.object, target.codes, span.x + i, span.y));
      }
      ++at;
      z += dz;
    } else {
      cursor.write(run_code<Format>(run, target.object, target.codes, span.x + i, span.y));
    }
    cursor.next();
    run.next();
  }
}

/// The same for a run in segments.
template <class Target, SegmentedRun Run>
[[gnu::always_inline]] constexpr void draw_run(typename Target::Format::Cursor cursor, const Span& span,
                                               Run& run, const Target& target, Linear z, Linear dz) {
  using Format = typename Target::Format;
  constexpr bool kTests = std::remove_cvref_t<decltype(target.depth)>::kTests;
  [[maybe_unused]] std::uint16_t* at = nullptr;
  if constexpr (kTests) at = target.depth.row(span.y) + span.x;
  std::int32_t x = span.x;
  const std::int32_t end = span.x + span.count;
  run.begin(target.object, span.count);
  while (x < end) {
    const std::int32_t pause = x + run.enter(target.object, end - x);
    for (; x < pause; ++x) {
      if constexpr (kTests) {
        const auto nearness = static_cast<std::uint16_t>(z.raw() >> Linear::kFraction);
        if (nearness < *at) [[likely]] {
          *at = nearness;
          cursor.write(encode_at<Format>(run.colour(), x, span.y));
        }
        ++at;
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
