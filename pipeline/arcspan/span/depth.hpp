// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/pixel/fill.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/target.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

/// The 16-bit depth of a surface whose interpolated depth is `z`.
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint16_t depth_of(Linear z) {
  return static_cast<std::uint16_t>(z.raw() >> Linear::kFraction);
}

/// The depth test: true if a pixel at `depth` is drawn over one at `stored`. Nearer depths are smaller; of
/// two equal ones the first stays.
[[nodiscard]] ARCSPAN_INLINE constexpr bool is_nearer(std::uint16_t depth, std::uint16_t stored) {
  return depth < stored;
}

/// No depth test: triangles cover what was drawn before them (painter's order, convex objects).
struct NoDepth {
  static constexpr bool kTests = false;
  [[nodiscard]] constexpr Rect bounds() const {
    return {INT32_MIN / 2, INT32_MIN / 2, INT32_MAX / 2, INT32_MAX / 2};
  }
};

/// A 16-bit depth buffer over memory of the caller, of the size of the picture or of a band of it.
class DepthBuffer {
 public:
  static constexpr bool kTests = true;
  static constexpr std::uint16_t kFarthest = 0xFFFF;

  [[nodiscard]] static constexpr std::size_t words(std::int32_t width, std::int32_t rows) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(rows);
  }

  /// `memory` must hold words(width, rows); otherwise bounds() is empty and nothing is drawn.
  constexpr DepthBuffer(std::span<std::uint16_t> memory, std::int32_t width, std::int32_t rows,
                        std::int32_t first_row = 0)
      : memory_(memory.data()) {
    if (width >= 0 && rows >= 0 && memory.size() >= words(width, rows)) {
      bounds_ = {0, first_row, width, first_row + rows};
    }
  }

  [[nodiscard]] constexpr Rect bounds() const { return bounds_; }
  [[nodiscard]] constexpr std::uint16_t* row(std::int32_t y) const {
    return memory_ + (y - bounds_.top) * bounds_.right;
  }

  /// Makes the memory represent the rows from `first_row` on. The depths in it stay until clear().
  constexpr void move_to(std::int32_t first_row) {
    const std::int32_t rows = bounds_.height();
    bounds_.top = first_row;
    bounds_.bottom = first_row + rows;
  }

  constexpr void clear() { fill(memory_, words(bounds_.right, bounds_.height()), kFarthest); }

 private:
  std::uint16_t* memory_;
  Rect bounds_{};
};

template <class D>
concept DepthTarget = std::same_as<D, NoDepth> || std::same_as<D, DepthBuffer>;

}  // namespace arcspan
