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

  /// The pixels of a gap.
  struct GapPixels {
    Cursor outer;
    Cursor inner;

    [[nodiscard]] ARCSPAN_INLINE GapColours<Format> colours() const { return {outer.read(), inner.read()}; }
  };

  explicit GapBlender(Sink& sink) : sink_(sink), inward_{1, -1, words_per_row(sink), -words_per_row(sink)} {}

  /// The pixels of the gap between (x, y), which is outside, and the surface at `place`.
  [[nodiscard]] ARCSPAN_INLINE GapPixels pixels_of(std::int32_t x, std::int32_t y, GapPlace place) const {
    const Cursor outer(sink_.row(y), x);
    if constexpr (kHasWordPixels) {
      return {outer, Cursor(outer.pixels(), inward_[static_cast<std::size_t>(place)])};
    } else {
      return {outer, Cursor(sink_.row(y + row_step(place)), x + column_step(place))};
    }
  }

  /// Blends `pixels` of the gap at (x, y); `colours` are those that they had at first. The outline lies in
  /// the nearer pixel, and may cut a corner of the other one.
  [[nodiscard]] ARCSPAN_INLINE Status blend(std::int32_t x, std::int32_t y, const GapOutline& outline,
                                            GapPixels pixels, const GapColours<Format>& colours) const {
    const std::int32_t outward = outline.outward;
    const std::uint32_t corner = outline.corner;
    const std::uint32_t of_outer = outward > 0 ? static_cast<std::uint32_t>(outward) + corner : corner;
    const std::uint32_t of_inner = outward < 0 ? static_cast<std::uint32_t>(-outward) + corner : corner;
    Status status = Status::kOk;
    if (of_outer != 0) {
      pixels.outer.write(blended<Format>(pixels.outer.read(), colours.inner, of_outer));
      status = sink_.close({y, x, 1});
    }
    if (of_inner != 0 && ok(status)) {
      pixels.inner.write(blended<Format>(pixels.inner.read(), colours.outer, of_inner));
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
