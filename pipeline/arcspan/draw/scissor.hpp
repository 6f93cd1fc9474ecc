// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/span/row_drawer.hpp>
#include <arcspan/status.hpp>
#include <arcspan/vertex/clip_transform.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <cstdint>

namespace arcspan::detail {

/// Where a triangle is, as seen from the scissor.
enum class ScissorTest : std::uint8_t {
  kInside,    ///< within its columns
  kCrossing,  ///< a vertex lies left or right of it
  kOutside,   ///< certainly no pixel centre within its columns, or no row within its rows
};

/// The rectangle of the picture that one call draws into: the common part of the viewport and the sink. In a
/// picture drawn in bands it is one band.
class Scissor {
 public:
  constexpr Scissor(const Viewport& viewport, const Rect& bounds)
      : rect_(intersection({0, 0, viewport.width, viewport.height}, bounds)),
        origin_{viewport.width >> 1, viewport.height >> 1},
        rows_{-origin_.y, viewport.height - origin_.y},
        drawn_rows_{wrap_sub(rect_.top, origin_.y), wrap_sub(rect_.bottom, origin_.y)},
        // These wrap if the bounds are far outside the viewport; the rectangle is empty then.
        left_(wrap_shl(wrap_sub(rect_.left, origin_.x), 4)),
        right_(wrap_shl(wrap_sub(rect_.right, origin_.x), 4)),
        upper_(wrap_add(wrap_shl(wrap_sub(rect_.top, origin_.y), 4), 9)),
        lower_(wrap_sub(wrap_shl(wrap_sub(rect_.bottom, origin_.y), 4), 7)),
        is_band_(wrap_sub(rect_.bottom, rect_.top) < viewport.height) {}

  [[nodiscard]] constexpr const Rect& rect() const { return rect_; }
  /// True if `bounds` covers the rectangle, or if that is empty.
  [[nodiscard]] constexpr bool is_within(const Rect& bounds) const {
    return rect_.empty() || contains(bounds, rect_);
  }
  [[nodiscard]] constexpr const RasterOrigin& origin() const { return origin_; }
  /// The rows of the whole viewport, relative to origin().
  [[nodiscard]] constexpr const RowRange& viewport_rows() const { return rows_; }
  /// The rows of the rectangle, relative to origin().
  [[nodiscard]] constexpr const RowRange& drawn_rows() const { return drawn_rows_; }

  /// Tests the triangle a, b, c. kCrossing is always a safe answer.
  [[nodiscard]] constexpr ScissorTest test(const RasterPosition& a, const RasterPosition& b,
                                           const RasterPosition& c) const {
    const bool crossing = leaves_columns(left_, right_, a, b, c);
    if (crossing && is_outside_columns(a, b, c)) return ScissorTest::kOutside;
    if (is_band_ && has_no_row_in_band(a, b, c)) return ScissorTest::kOutside;
    return crossing ? ScissorTest::kCrossing : ScissorTest::kInside;
  }

 private:
  /// True if all vertices lie on the same side of the scissor's columns.
  [[nodiscard]] constexpr bool is_outside_columns(const RasterPosition& a, const RasterPosition& b,
                                                  const RasterPosition& c) const {
    return (a.x < left_ && b.x < left_ && c.x < left_) || (a.x > right_ && b.x > right_ && c.x > right_);
  }

  /// True if first_row_at() of all vertices is at most the scissor's first row, or at least the row behind
  /// its last.
  [[nodiscard]] constexpr bool has_no_row_in_band(const RasterPosition& a, const RasterPosition& b,
                                                  const RasterPosition& c) const {
    return (a.y < upper_ && b.y < upper_ && c.y < upper_) ||
           (a.y >= lower_ && b.y >= lower_ && c.y >= lower_);
  }

  Rect rect_;
  RasterOrigin origin_;
  RowRange rows_;
  RowRange drawn_rows_;
  // In sixteenths of a pixel, relative to origin().
  std::int32_t left_;  ///< columns of the scissor
  std::int32_t right_;
  std::int32_t upper_;  ///< least y of a vertex whose first_row_at() is behind the first row
  std::int32_t lower_;  ///< least y whose first_row_at() is at least the row behind the last
  bool is_band_;        ///< rows of the viewport lie outside the scissor
};

/// Returns the reason why nothing can be drawn into a sink and a depth buffer, or kOk.
template <class Sink, class Depth>
[[nodiscard]] constexpr Status check_target(const Scissor& scissor, const Sink& sink, const Depth& depth) {
  if (const Status status = status_of(sink); !ok(status)) return status;
  if constexpr (Depth::kTests) {
    if (!ok(depth.status())) return depth.status();
    if (!scissor.is_within(depth.bounds())) return Status::kDepthMismatch;
  }
  return Status::kOk;
}

}  // namespace arcspan::detail
