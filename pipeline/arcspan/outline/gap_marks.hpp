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

  /// True if a pixel with this depth, which is no mark, is nearer than `z`.
  [[nodiscard]] ARCSPAN_INLINE static bool is_hidden(std::uint16_t depth, std::uint16_t z) {
    return is_nearer(depth, z) && !is_mark(depth);
  }

  /// Blends the outline of pixel (x, y), which is outside. `at` is the pixel's depth in the buffer, `inner`
  /// that of the pixel on the other side of the outline. Of several outlines in one gap the first counts.
  ARCSPAN_INLINE void put(std::int32_t x, std::int32_t y, GapOutline outline, std::uint16_t,
                          std::uint16_t* at, const std::uint16_t* inner) {
    const GapPlace place = outline.place;
    const unsigned marks = is_mark(*at) ? *at : 0u;
    if ((marks & bit_of(place)) != 0 || (is_mark(*inner) && (*inner & bit_of(opposite(place))) != 0)) return;
    *at = static_cast<std::uint16_t>(marks | bit_of(place));
    if (!ok(status_)) return;
    const auto pixels = blender_.pixels_of(x, y, place);
    const Status status = blender_.blend(x, y, outline, pixels, pixels.colours());
    if (!ok(status)) status_ = status;
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
