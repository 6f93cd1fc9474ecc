// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/outline/gap_blender.hpp>
#include <arcspan/outline/outline_gap.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

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

  GapList(Sink& sink, const DepthBuffer& depth, std::span<Gap> memory)
      : blender_(sink),
        depth_(depth),
        gaps_(memory.data()),
        most_(memory.size() < kMost ? static_cast<std::uint32_t>(memory.size()) : kMost) {}

  /// False if what is stored as the depth of a pixel certainly is one, and no number.
  [[nodiscard]] ARCSPAN_INLINE bool may_be_own(std::uint16_t stored) const { return stored < count_; }
  /// A pixel outside of an outline: its depth, and the number of its latest gap or -1.
  struct Outer {
    std::uint16_t depth;
    std::int32_t number;
  };
  /// That of `pixel` (OutlinePixel::column_row), in whose depth `stored` is.
  [[nodiscard]] ARCSPAN_INLINE Outer outer_of(std::uint16_t stored, std::uint32_t pixel) const {
    if (stored >= count_ || !gaps_[stored].is_of(pixel)) [[likely]]
      return {stored, -1};
    return {gaps_[stored].held.list.depth, stored};
  }

  /// Puts the outline of `pixel`, which is `outer`. `at` is its depth in the buffer, `inner` that of the
  /// pixel on the other side of the outline. Of several outlines in one gap the outermost counts; of two
  /// surfaces that meet in it the first.
  ARCSPAN_INLINE void put(std::uint32_t pixel, const GapOutline& outline, Outer outer, std::uint16_t* at,
                          const std::uint16_t* inner) {
    if (outer.number >= 0 && moved_outward(static_cast<std::uint32_t>(outer.number), outline.word())) return;
    if (*inner < count_ && has_opposite(*inner, pixel, outline.place)) return;
    if (count_ == most_) [[unlikely]] {
      apply();
      was_full_ = true;
      outer.number = -1;
    }
    Gap& gap = gaps_[count_];
    gap.x = static_cast<std::int16_t>(pixel);
    gap.y = static_cast<std::int16_t>(pixel >> 16);
    gap.held = {.list = {outer.depth, static_cast<std::uint16_t>(outer.number)}};
    gap.outline = outline.word();
    *at = static_cast<std::uint16_t>(count_++);
  }

  /// Restores the depths, blends the pixels of all gaps, and empties the list.
  ARCSPAN_OUTLINE void apply() {
    const std::span<Gap> gaps(gaps_, count_);
    for (Gap& gap : gaps) restore(gap);
    Status status = status_;
    for (const Gap& gap : gaps) {
      if (!ok(status)) break;
      status = blender_.blend(gap.x, gap.y, GapOutline::of(gap.outline), gap.held.colours);
    }
    status_ = status;
    count_ = 0;
  }

  /// That of the sink; kBufferTooSmall if the list was full.
  [[nodiscard]] Status status() const { return ok(status_) && was_full_ ? Status::kBufferTooSmall : status_; }

 private:
  static constexpr std::uint16_t kNone = 0xFFFF;
  static constexpr std::uint32_t kMost = kNone;  ///< no cleared depth is a number

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
  ARCSPAN_OUTLINE bool has_opposite(std::uint32_t number, std::uint32_t pixel, GapPlace place) const {
    if (!gaps_[number].is_of(pixel + inward_step(place))) return false;
    for (; number != kNone; number = gaps_[number].held.list.next)
      if (GapOutline::place_of(gaps_[number].outline) == opposite(place)) return true;
    return false;
  }

  ARCSPAN_INLINE void restore(Gap& gap) const {
    const std::int32_t x = gap.x;
    const std::int32_t y = gap.y;
    const GapPlace place = GapOutline::place_of(gap.outline);
    depth_.row(y)[x] = gap.held.list.depth;
    const auto outer = blender_.outer(x, y);
    gap.held = {.colours = {outer.read(), blender_.inner(outer, x, y, place).read()}};
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
