// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/outline/blend.hpp>
#include <arcspan/outline/outline_gap.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace arcspan::detail {

/// Blends the two pixels of a gap in a sink.
template <PixelSink Sink>
class GapBlender {
 public:
  using Format = typename Sink::Format;
  using Cursor = typename Format::Cursor;

  explicit GapBlender(Sink& sink) : sink_(sink), inward_{1, -1, words_per_row(sink), -words_per_row(sink)} {}

  /// Pixel (x, y), which is outside.
  [[nodiscard]] ARCSPAN_INLINE Cursor outer(std::int32_t x, std::int32_t y) const {
    return {sink_.row(y), x};
  }
  /// The pixel of the surface that is at `place` from there.
  [[nodiscard]] ARCSPAN_INLINE Cursor inner(const Cursor& outer, std::int32_t x, std::int32_t y,
                                            GapPlace place) const {
    if constexpr (kHasWordPixels) {
      return {outer.pixels(), inward_[static_cast<std::size_t>(place)]};
    } else {
      return {sink_.row(y + row_step(place)), x + column_step(place)};
    }
  }

  /// Blends the gap at (x, y); `colours` are those that its pixels had at first. The outline lies in the
  /// nearer pixel, and may cut a corner of the other one.
  [[nodiscard]] ARCSPAN_INLINE Status blend(std::int32_t x, std::int32_t y, const GapOutline& outline,
                                            const GapColours<Format>& colours) const {
    const std::uint32_t of_outer = outline.of_outer();
    const std::uint32_t of_inner = outline.of_inner();
    Cursor at = outer(x, y);
    Status status = Status::kOk;
    if (of_outer != 0) {
      at.write(blended<Format>(at.read(), colours.inner, of_outer));
      status = sink_.close({y, x, 1});
    }
    if (of_inner != 0 && ok(status)) {
      Cursor beyond = inner(at, x, y, outline.place);
      beyond.write(blended<Format>(beyond.read(), colours.outer, of_inner));
      status = sink_.close({y + row_step(outline.place), x + column_step(outline.place), 1});
    }
    return status;
  }

 private:
  [[nodiscard]] static std::int32_t words_per_row(const Sink& sink) {
    return sink.stride_bytes() / std::int32_t{sizeof(typename Format::Word)};
  }
  /// Rows are a whole number of pixels apart.
  static constexpr bool kHasWordPixels =
      std::is_integral_v<typename Format::Word> && requires(Cursor cursor) {
    cursor.pixels();
  };

  Sink& sink_;
  const std::int32_t inward_[4];  ///< words from the outer pixel of a gap to the inner one, by its place
};

}  // namespace arcspan::detail
