// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/checked.hpp>
#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/pixel/band.hpp>
#include <arcspan/pixel/fill.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

/// The depth test: true if a pixel at `depth` is drawn over one at `stored`. Nearer depths are smaller; of
/// two equal ones the first stays.
[[nodiscard]] ARCSPAN_INLINE constexpr bool is_nearer(std::uint16_t depth, std::uint16_t stored) {
  return depth < stored;
}

/// No depth test: triangles cover what was drawn before them (painter's order, convex objects).
struct NoDepth {
  static constexpr bool kTests = false;
  static constexpr bool kWrites = false;
  [[nodiscard]] static constexpr bool passes(std::uint16_t, std::uint16_t) { return true; }
  [[nodiscard]] constexpr Rect bounds() const {
    return {INT32_MIN / 2, INT32_MIN / 2, INT32_MAX / 2, INT32_MAX / 2};
  }
};

namespace detail {

/// Whether the memory of a depth buffer was cleared, in builds with ARCSPAN_CHECKED. In others it is empty.
class DepthChecks {
 public:
  constexpr void note_move() { state_.set(kMoved); }
  constexpr void note_clear() { state_.set(kCleared); }

  /// Reports memory that was not cleared, once. Drawing leaves depths of 256 and more, so that memory with
  /// zeros and without anything farthest never was.
  constexpr void check([[maybe_unused]] std::span<const std::uint16_t> depths) {
    if constexpr (kIsChecked) {
      if (state_.get() == kCleared) return;
      [[maybe_unused]] std::size_t zeros = 0;
      [[maybe_unused]] std::size_t farthest = 0;
      for (const std::uint16_t depth : depths) {
        if (depth == 0) ++zeros;
        if (depth == 0xFFFF) ++farthest;
      }
      [[maybe_unused]] const bool moved = state_.get() == kMoved;
      ARCSPAN_CHECK(!moved || farthest == depths.size(),
                    "draw: the depth buffer was moved to another band, but not cleared");
      ARCSPAN_CHECK(moved || zeros == 0 || farthest > 0, "draw: the depth buffer was never cleared");
      state_.set(kCleared);
    }
  }

 private:
  static constexpr unsigned kMoved = 1;
  static constexpr unsigned kCleared = 2;

  [[no_unique_address]] CheckedState state_{};
};

}  // namespace detail

/// A 16-bit depth buffer over memory of the caller: of the whole picture, of a band or of a rectangle of it.
class DepthBuffer {
 public:
  static constexpr bool kTests = true;
  static constexpr bool kWrites = true;
  static constexpr std::uint16_t kFarthest = 0xFFFF;

  /// The test of a pixel, nearer than what is there.
  [[nodiscard]] ARCSPAN_INLINE static constexpr bool passes(std::uint16_t depth, std::uint16_t stored) {
    return is_nearer(depth, stored);
  }

  [[nodiscard]] static constexpr std::size_t words(std::int32_t width, std::int32_t rows) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(rows);
  }

  /// `memory` must hold words(width, rows), else status() is kBufferTooSmall. It is kInvalidArgument unless
  /// `width` and `rows` are in 0...32767 and `first_row` is as move_to() takes it. With any status but kOk
  /// bounds() is empty, and draw_mesh() returns the status.
  constexpr DepthBuffer(std::span<std::uint16_t> memory, std::int32_t width, std::int32_t rows,
                        std::int32_t first_row = 0)
      : status_(detail::check_band_size(width, rows, words_per_row, memory.size())) {
    if (!ok(status_)) return;
    hold(memory, {0, 0, width, rows});
    status_ = detail::move_band(bounds_, first_row);
  }
  /// The depths of the rectangle `held` of the picture, of words(held.width(), held.height()). status() is
  /// kInvalidArgument unless the sides of `held` are in 0...32767 and in order.
  constexpr DepthBuffer(std::span<std::uint16_t> memory, const Rect& held)
      : status_(detail::check_band_rect(held, words_per_row, memory.size())) {
    if (ok(status_)) hold(memory, held);
  }

  [[nodiscard]] constexpr Status status() const { return status_; }
  [[nodiscard]] constexpr Rect bounds() const { return bounds_; }
  /// The depth of column 0 of row y of the picture, where that is or would be, as SinkInMemory has it.
  [[nodiscard]] constexpr std::uint16_t* row(std::int32_t y) const {
    return column_0_ + (y - bounds_.top) * stride_;
  }
  /// Depths from one row to the next.
  [[nodiscard]] constexpr std::int32_t stride() const { return stride_; }

  /// Makes the memory represent the rows from `first_row` on. The depths in it stay until clear().
  /// `first_row` is 0...INT32_MAX - rows; otherwise status() is kInvalidArgument and bounds() empty until the
  /// next call. Without effect if the constructor was given too little memory or a wrong size.
  constexpr void move_to(std::int32_t first_row) {
    if (stride_ == kRefused) return;
    if (first_row != bounds_.top) checks_.note_move();
    status_ = detail::move_band(bounds_, first_row);
  }

  constexpr void clear() const {
    const std::span<std::uint16_t> all = memory();
    fill(all.data(), all.size(), kFarthest);
    checks_.note_clear();
  }

  /// Reports memory that no clear() has prepared (ARCSPAN_CHECKED).
  constexpr void check_cleared() const { checks_.check(memory()); }

 private:
  static constexpr std::int32_t kRefused = -1;

  [[nodiscard]] static constexpr std::size_t words_per_row(std::int32_t width) { return words(width, 1); }

  constexpr void hold(std::span<std::uint16_t> memory, const Rect& held) {
    column_0_ = detail::column_0_of(memory.data(), words_per_row(held.left));
    stride_ = held.width();
    bounds_ = held;
  }
  [[nodiscard]] constexpr std::span<std::uint16_t> memory() const {
    const std::size_t count = words(bounds_.width(), detail::band_rows(bounds_));
    return {count == 0 ? nullptr : column_0_ + bounds_.left, count};
  }

  std::uint16_t* column_0_ = nullptr;  ///< of the first row
  std::int32_t stride_ = kRefused;     ///< in depths; kRefused if the constructor's arguments were
  Rect bounds_{};
  Status status_;
  [[no_unique_address]] mutable detail::DepthChecks checks_{};
};

/// A depth buffer, or one with another test or without writing (DepthMode, span/depth_mode.hpp).
template <class D>
concept DepthTarget = std::same_as<D, NoDepth> || std::same_as<D, DepthBuffer> || requires {
  requires bool{D::kIsDepthMode};
};

}  // namespace arcspan
