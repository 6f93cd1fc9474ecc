// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/format.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/span/depth.hpp>

#include <cstdint>

namespace arcspan::detail {

/// Draws one run of pixels: the colours of `run` through `cursor`, with the depth test of `Depth`.
template <class Format, class Object, PixelRun<Object> Run, DepthTarget Depth>
[[gnu::always_inline]] constexpr void draw_run(typename Format::Cursor cursor, const Span& span, Run& run,
                                               const Object& object, const Depth& depth, Linear z,
                                               Linear dz) {
  [[maybe_unused]] std::uint16_t* at = nullptr;
  if constexpr (Depth::kTests) at = depth.row(span.y) + span.x;
  for (std::int32_t i = 0; i < span.count; ++i) {
    if constexpr (Depth::kTests) {
      const auto nearness = static_cast<std::uint16_t>(z.raw() >> Linear::kFraction);
      if (nearness < *at) [[likely]] {
        *at = nearness;
        cursor.write(encode_at<Format>(run.colour(object), span.x + i, span.y));
      }
      ++at;
      z += dz;
    } else {
      cursor.write(encode_at<Format>(run.colour(object), span.x + i, span.y));
    }
    cursor.next();
    run.next();
  }
}

/// The same for a run in segments.
template <class Format, class Object, SegmentedRunOf<Object> Run, DepthTarget Depth>
[[gnu::always_inline]] constexpr void draw_run(typename Format::Cursor cursor, const Span& span, Run& run,
                                               const Object& object, const Depth& depth, Linear z,
                                               Linear dz) {
  [[maybe_unused]] std::uint16_t* at = nullptr;
  if constexpr (Depth::kTests) at = depth.row(span.y) + span.x;
  std::int32_t x = span.x;
  const std::int32_t end = span.x + span.count;
  run.begin(object, span.count);
  while (x < end) {
    const std::int32_t pause = x + run.enter(object, end - x);
    for (; x < pause; ++x) {
      if constexpr (Depth::kTests) {
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
