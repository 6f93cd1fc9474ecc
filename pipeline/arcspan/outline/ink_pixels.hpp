// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/outline/blend.hpp>
#include <arcspan/outline/outline_gap.hpp>
#include <arcspan/outline/outline_way.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <cstdint>
#include <span>

namespace arcspan::detail {

/// Draws pixels in the colour of ink. Those that ink covers in part are listed, so that each is blended once,
/// by its largest share, however many edges reach it. While a pixel is in the list, its depth holds its
/// number there, as in GapList. In formats without mixtures ink covers pixels from one half on, and nothing
/// is listed.
template <PixelSink Sink>
class InkPixels {
 public:
  using Format = typename Sink::Format;
  using Entry = OutlineGap<Format>;
  static constexpr std::uint32_t kWhole = 32;

  InkPixels(Sink& sink, const DepthBuffer& depth, Rgb8 colour, std::span<Entry> memory)
      : sink_(sink),
        depth_(depth),
        entries_(memory.data()),
        colour_(Format::encode(colour)),
        most_(memory.size() < kMost ? static_cast<std::uint32_t>(memory.size()) : kMost) {}

  /// The depth of a pixel, whether it is in the list or not.
  [[nodiscard]] ARCSPAN_INLINE std::uint16_t depth_of(const OutlinePixel& at) const {
    const std::uint16_t number = *at.depth;
    if (number >= count_ || !entries_[number].is_of(at.column_row)) [[likely]]
      return number;
    return entries_[number].held.list.depth;
  }

  /// Covers `share` / 32 of a pixel, 1...32.
  ARCSPAN_INLINE void put(const OutlinePixel& at, std::uint32_t share) {
    if (share == kWhole || (!kCanBlend<Format> && share >= kWhole / 2)) {
      write(at.x(), at.y(), colour_);
    } else if constexpr (kCanBlend<Format>) {
      list(at, share);
    }
  }

  /// Restores the depths, blends the pixels of the list, and empties it.
  ARCSPAN_OUTLINE void apply() {
    const typename Format::Encoded colour = colour_;
    Status status = status_;
    for (const Entry& entry : std::span<const Entry>(entries_, count_)) {
      const std::int32_t x = entry.x;
      const std::int32_t y = entry.y;
      depth_.row(y)[x] = entry.held.list.depth;
      if (!ok(status)) continue;
      typename Format::Cursor cursor(sink_.row(y), x);
      cursor.write(blended<Format>(cursor.read(), colour, entry.outline));
      status = sink_.close({y, x, 1});
    }
    status_ = status;
    count_ = 0;
  }

  /// That of the sink; kBufferTooSmall if the list was full.
  [[nodiscard]] Status status() const { return ok(status_) && was_full_ ? Status::kBufferTooSmall : status_; }

 private:
  static constexpr std::uint32_t kMost = 0xFFFF;  ///< no cleared depth is a number

  ARCSPAN_INLINE void list(const OutlinePixel& at, std::uint32_t share) {
    const std::uint32_t number = *at.depth;
    if (number < count_ && entries_[number].is_of(at.column_row)) {
      if (share > entries_[number].outline) entries_[number].outline = static_cast<std::uint16_t>(share);
      return;
    }
    if (count_ == most_) [[unlikely]] {
      apply();
      was_full_ = true;
    }
    Entry& entry = entries_[count_];
    entry.x = static_cast<std::int16_t>(at.column_row);
    entry.y = static_cast<std::int16_t>(at.column_row >> 16);
    entry.held.list.depth = static_cast<std::uint16_t>(number);
    entry.outline = static_cast<std::uint16_t>(share);
    *at.depth = static_cast<std::uint16_t>(count_++);
  }

  ARCSPAN_INLINE void write(std::int32_t x, std::int32_t y, typename Format::Encoded pixel) {
    if (!ok(status_)) return;
    typename Format::Cursor(sink_.row(y), x).write(pixel);
    status_ = sink_.close({y, x, 1});
  }

  Sink& sink_;
  const DepthBuffer& depth_;
  Entry* const entries_;
  const typename Format::Encoded colour_;
  const std::uint32_t most_;
  std::uint32_t count_ = 0;
  Status status_ = Status::kOk;
  bool was_full_ = false;
};

}  // namespace arcspan::detail
