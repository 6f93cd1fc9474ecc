// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/outline/gap_blender.hpp>
#include <arcspan/outline/outline_gap.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan::detail {

/// Blends gaps as they are found, as a GapList has them, without memory. The depth of a pixel outside of an
/// outline becomes a mark then: a bit for each side on which it is done. Marks are 1...15; no surface is that
/// near, because the depths of vertices start at ClipTransform::kDepthMargin.
template <PixelSink Sink>
class GapMarks {
 public:
  explicit GapMarks(Sink& sink) : blender_(sink) {}

  /// False if what is stored as the depth of a pixel is one, and no mark.
  [[nodiscard]] ARCSPAN_INLINE static bool may_be_own(std::uint16_t stored) { return is_mark(stored); }
  /// A pixel outside of an outline: its depth, the farthest if it is lost, and its marks.
  struct Outer {
    std::uint16_t depth;
    std::uint16_t marks;
  };
  [[nodiscard]] ARCSPAN_INLINE static Outer outer_of(std::uint16_t stored, std::uint32_t) {
    return is_mark(stored) ? Outer{DepthBuffer::kFarthest, stored} : Outer{stored, 0};
  }

  /// Blends the outline of `pixel` (OutlinePixel::column_row), which is `outer`. `at` is its depth in the
  /// buffer, `inner` that of the pixel on the other side of the outline. Of several outlines in one gap the
  /// first counts.
  ARCSPAN_INLINE void put(std::uint32_t pixel, const GapOutline& outline, Outer outer, std::uint16_t* at,
                          const std::uint16_t* inner) {
    const GapPlace place = outline.place;
    const unsigned marks = outer.marks;
    if ((marks & bit_of(place)) != 0 || (is_mark(*inner) && (*inner & bit_of(opposite(place))) != 0)) return;
    *at = static_cast<std::uint16_t>(marks | bit_of(place));
    if (!ok(status_)) return;
    const auto x = static_cast<std::int32_t>(pixel & 0xFFFFu);
    const auto y = static_cast<std::int32_t>(pixel >> 16);
    const auto outside = blender_.outer(x, y);
    status_ = blender_.blend(x, y, outline, {outside.read(), blender_.inner(outside, x, y, place).read()});
  }

  [[nodiscard]] Status status() const { return status_; }

 private:
  [[nodiscard]] static constexpr bool is_mark(std::uint32_t depth) { return depth - 1u < 15u; }
  [[nodiscard]] static constexpr unsigned bit_of(GapPlace place) {
    return 1u << static_cast<std::uint8_t>(place);
  }

  const GapBlender<Sink> blender_;
  Status status_ = Status::kOk;
};

}  // namespace arcspan::detail
