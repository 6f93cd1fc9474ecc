// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/outline/gap_blender.hpp>
#include <arcspan/outline/outline_gap.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan::detail {

/// The gaps of a picture or a band. While it is made, the depth of a pixel outside of an outline holds the
/// number of its latest gap: if there is such a gap and it names the pixel, it is one, otherwise a depth. So
/// no map is needed. Pixels are only read until the list is complete, so that the result does not depend
/// on what was blended before, nor on the rows that a band leaves out.
template <PixelSink Sink>
class GapList {
 public:
  using Format = typename Sink::Format;
  using Gap = OutlineGap<Format>;
  using Held = typename Gap::Held;

  GapList(Sink& sink, const DepthBuffer& depth, std::span<Gap> memory)
      : blender_(sink),
        depth_(depth),
        gaps_(memory.data()),
        most_(memory.size() < kMost ? static_cast<std::uint32_t>(memory.size()) : kMost) {}

  /// True if a pixel with this depth, which is no gap's, is nearer than `z`.
  [[nodiscard]] ARCSPAN_INLINE bool is_hidden(std::uint16_t depth, std::uint16_t z) const {
    return depth >= count_ && is_nearer(depth, z);
  }

  /// Puts the outline of pixel (x, y), which is outside, with depth `z`, unless the pixel is nearer. `at` is
  /// the pixel's depth in the buffer, `inner` that of the pixel on the other side of the outline. Of several
  /// outlines in one gap the outermost counts; of two surfaces that meet in it the first.
  ARCSPAN_INLINE void put(std::int32_t x, std::int32_t y, GapOutline outline, std::uint16_t z,
                          std::uint16_t* at, const std::uint16_t* inner) {
    std::uint32_t number = *at;
    std::uint32_t depth = number;
    if (number >= count_ || !is_gap_of(number, x, y)) [[likely]] {
      number = kNone;
    } else {
      depth = gaps_[number].held.list.depth;
    }
    if (is_nearer(static_cast<std::uint16_t>(depth), z)) return;
    if (number != kNone && moved_outward(number, outline.word())) return;
    if (*inner < count_ && has_opposite(*inner, x, y, outline.place)) return;
    if (count_ == most_) [[unlikely]] {
      apply();
      was_full_ = true;
      number = kNone;
    }
    Gap& gap = gaps_[count_];
    gap.x = static_cast<std::int16_t>(x);
    gap.y = static_cast<std::int16_t>(y);
    gap.held =
        Held(typename Gap::InList{static_cast<std::uint16_t>(depth), static_cast<std::uint16_t>(number)});
    gap.outline = outline.word();
    *at = static_cast<std::uint16_t>(count_++);
  }

  /// Restores the depths, blends the pixels of all gaps, and empties the list.
  ARCSPAN_OUTLINE void apply() {
    for (std::uint32_t i = 0; i < count_; ++i) restore(gaps_[i]);
    Status status = status_;
    for (std::uint32_t i = 0; i < count_ && ok(status); ++i) status = blend(gaps_[i]);
    status_ = status;
    count_ = 0;
  }

  /// That of the sink; kBufferTooSmall if the list was full.
  [[nodiscard]] Status status() const { return ok(status_) && was_full_ ? Status::kBufferTooSmall : status_; }

 private:
  static constexpr std::uint32_t kNone = 0xFFFF;
  static constexpr std::uint32_t kMost = kNone;  ///< no cleared depth is a number

  /// `number` is below count_.
  [[nodiscard]] ARCSPAN_INLINE bool is_gap_of(std::uint32_t number, std::int32_t x, std::int32_t y) const {
    return gaps_[number].x == x && gaps_[number].y == y;
  }

  /// Looks for the gap in the same place among those of a pixel. If there is one, moves its outline outward
  /// if the new one is, and returns true.
  ARCSPAN_OUTLINE bool moved_outward(std::uint32_t number, std::uint16_t outline) {
    for (; number != kNone; number = gaps_[number].held.list.next) {
      Gap& gap = gaps_[number];
      if (GapOutline::place_of(gap.outline) != GapOutline::place_of(outline)) continue;
      if (outline > gap.outline) gap.outline = outline;
      return true;
    }
    return false;
  }

  /// True if the pixel on the other side of the outline has a gap for the same place. `number`, below count_,
  /// is what its depth holds.
  ARCSPAN_OUTLINE bool has_opposite(std::uint32_t number, std::int32_t x, std::int32_t y,
                                    GapPlace place) const {
    if (!is_gap_of(number, x + column_step(place), y + row_step(place))) return false;
    for (; number != kNone; number = gaps_[number].held.list.next)
      if (GapOutline::place_of(gaps_[number].outline) == opposite(place)) return true;
    return false;
  }

  void restore(Gap& gap) {
    depth_.row(gap.y)[gap.x] = gap.held.list.depth;
    const auto pixels = blender_.pixels_of(gap.x, gap.y, GapOutline::place_of(gap.outline));
    gap.held = Held(pixels.colours());
  }
  [[nodiscard]] ARCSPAN_INLINE Status blend(const Gap& gap) const {
    const GapOutline outline = GapOutline::of(gap.outline);
    const auto pixels = blender_.pixels_of(gap.x, gap.y, outline.place);
    return blender_.blend(gap.x, gap.y, outline, pixels, gap.held.colours);
  }

  const GapBlender<Sink> blender_;
  const DepthBuffer& depth_;
  Gap* const gaps_;
  const std::uint32_t most_;
  std::uint32_t count_ = 0;
  Status status_ = Status::kOk;
  bool was_full_ = false;
};

}  // namespace arcspan::detail
