// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/panel/glass.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/status.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace arcspan::hal {

/// Columns left ... right - 1 of a row. Empty if right <= left.
struct RowExtent {
  std::uint16_t left = UINT16_MAX;
  std::uint16_t right = 0;

  constexpr void include(const RowExtent& other) {
    if (other.left < left) left = other.left;
    if (other.right > right) right = other.right;
  }
};

/// Tracks, per row, the columns drawn in this frame or in the last one: those that can differ between the two
/// pictures. The result is exact as long as both frames have the same background.
class Damage {
 public:
  /// Number of RowExtents, 4 bytes each, that a picture of `height` rows needs.
  [[nodiscard]] static constexpr std::size_t extents(std::int32_t height) {
    return 2 * static_cast<std::size_t>(height);
  }

  /// `memory` must hold extents(height) and outlive this object. If it is smaller, or if the picture has more
  /// than 65,535 columns or rows, status() reports it and changed_area() always returns all columns and rows.
  constexpr Damage(std::span<RowExtent> memory, std::int32_t width, std::int32_t height)
      : memory_(memory.data()), width_(width), height_(height) {
    if (width < 0 || height < 0 || width > UINT16_MAX || height > UINT16_MAX) {
      status_ = Status::kInvalidArgument;
    } else if (memory.size() < extents(height)) {
      status_ = Status::kBufferTooSmall;
    } else {
      for (std::size_t i = 0; i < extents(height); ++i) memory_[i] = {};
    }
  }

  [[nodiscard]] constexpr Status status() const { return status_; }
  /// The size of the picture, as given.
  [[nodiscard]] constexpr std::int32_t width() const { return width_; }
  [[nodiscard]] constexpr std::int32_t height() const { return height_; }

  /// Begins a frame: the current frame becomes the last one.
  constexpr void begin_frame() {
    if (!ok(status_)) return;
    current_ ^= 1u;
    for (std::int32_t y = 0; y < height_; ++y) at(y, current_) = {};
    everything_ = next_everything_;
    next_everything_ = false;
  }

  /// Declares the last picture unknown: the current and the next frame count as changed everywhere.
  constexpr void mark_everything() { everything_ = next_everything_ = true; }

  /// Declares that frames have the background `colour` from now on: after another one all is changed.
  constexpr void set_background(Rgb8 colour) {
    if (colour == background_) return;
    background_ = colour;
    mark_everything();
  }

  /// Declares that frames are shown in this orientation from now on: after another one all is changed,
  /// because a controller that turns the picture keeps its memory as it is.
  constexpr void set_orientation(Orientation orientation) {
    if (orientation == orientation_) return;
    orientation_ = orientation;
    mark_everything();
  }

  /// Records `run` as drawn. Ignores runs that do not lie inside the picture.
  constexpr void mark(const Span& run) {
    if (!ok(status_) || run.count <= 0 || run.y < 0 || run.y >= height_ || run.x < 0 ||
        run.x > width_ - run.count) {
      return;
    }
    at(run.y, current_)
        .include({static_cast<std::uint16_t>(run.x), static_cast<std::uint16_t>(run.x + run.count)});
  }

  /// Smallest rectangle around the changes in rows first ... end - 1 of the picture. Empty if there are none.
  [[nodiscard]] constexpr Rect changed_area(std::int32_t first, std::int32_t end) const {
    if (first < 0) first = 0;
    if (end > height_) end = height_;
    if (!ok(status_) || everything_) return {0, first, width_, end};
    Rect box{width_, end, 0, first};
    for (std::int32_t y = first; y < end; ++y) {
      RowExtent row = at(y, 0);
      row.include(at(y, 1));
      if (row.right <= row.left) continue;
      if (row.left < box.left) box.left = row.left;
      if (row.right > box.right) box.right = row.right;
      if (y < box.top) box.top = y;
      box.bottom = y + 1;
    }
    return box;
  }

 private:
  [[nodiscard]] constexpr RowExtent& at(std::int32_t y, unsigned frame) const {
    return memory_[2 * y + static_cast<std::int32_t>(frame)];
  }

  RowExtent* memory_;
  std::int32_t width_;
  std::int32_t height_;
  Rgb8 background_{};
  Orientation orientation_ = Orientation::k0;
  unsigned current_ = 0;
  bool everything_ = true;
  bool next_everything_ = true;
  Status status_ = Status::kOk;
};

/// A pixel sink that forwards to `target` and marks each run in `damage`. Both must outlive it. Its status()
/// is that of the target, or kInvalidArgument if the target has columns or rows beyond the damage, whose
/// changes would be lost.
template <PixelSink Target>
class DamageSink {
 public:
  using Format = typename Target::Format;
  /// Rows lie in memory if those of the target do: outlines are smoothed and inked in it, too. What is
  /// written to a row() without close() is not marked.
  using RowsInMemory = std::conditional_t<SinkInMemory<Target>, DamageSink, void>;
  using FromFirstColumn = std::conditional_t<SinkFromFirstColumn<Target>, DamageSink, void>;

  constexpr DamageSink(Target& target, Damage& damage) : target_(target), damage_(damage) {}

  [[nodiscard]] constexpr Rect bounds() const { return target_.bounds(); }
  [[nodiscard]] constexpr Status status() const {
    const Status status = arcspan::detail::status_of(target_);
    if (!ok(status)) return status;
    const Rect all = target_.bounds();
    const bool fits = all.right <= damage_.width() && all.bottom <= damage_.height();
    return fits ? Status::kOk : Status::kInvalidArgument;
  }
  /// Clears the target, which is damage only if the last frame had another background.
  constexpr void clear(Rgb8 colour) requires requires(Target& target) { target.clear(colour); }
  {
    damage_.set_background(colour);
    target_.clear(colour);
  }
  [[nodiscard]] constexpr typename Format::Cursor open(const Span& run) { return target_.open(run); }
  [[nodiscard]] constexpr Status close(const Span& run) {
    damage_.mark(run);
    return target_.close(run);
  }
  [[nodiscard]] constexpr auto* row(std::int32_t y) const requires SinkInMemory<Target> {
    return target_.row(y);
  }
  [[nodiscard]] constexpr std::int32_t stride_bytes() const requires SinkInMemory<Target> {
    return target_.stride_bytes();
  }

 private:
  Target& target_;
  Damage& damage_;
};

}  // namespace arcspan::hal
