// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/outline/outline_list.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan::detail {

/// The depth test of pixels beside an edge. The depths of its ends decide for most of them, so that walks
/// need not step along the depth.
class OutlineDepth {
 public:
  /// `exchanged` says that the edge is walked by columns: for rows read columns.
  ARCSPAN_INLINE void begin(const OutlineEdge& edge, bool exchanged) {
    const std::int32_t difference = std::int32_t{edge.from.z} - edge.to.z;
    const std::int32_t below = difference & (difference >> 31);  // branchless: 0 if `to` is nearer
    edge_ = &edge;
    nearest_ = static_cast<std::uint16_t>(edge.to.z + below);
    farthest_ = static_cast<std::uint16_t>(edge.from.z - below);
    exchanged_ = exchanged;
  }

  /// False if no pixel with this depth is nearer than the edge.
  [[nodiscard]] ARCSPAN_INLINE bool may_hide(std::uint16_t depth) const { return depth < farthest_; }
  /// True if a pixel with this depth is nearer than the edge where it crosses the centre line of a row;
  /// beyond the ends, nearer than the end.
  [[nodiscard]] ARCSPAN_INLINE bool is_behind(std::uint16_t depth, std::int32_t row) const {
    return may_hide(depth) && (depth < nearest_ || is_behind_between(depth, row));
  }

 private:
  /// is_behind() of a depth from nearest_ to farthest_ - 1: depth < floor(z) with
  /// z = from.z + (to.z - from.z) * part / whole, exactly. All products are below 2^31, because depths differ
  /// by less than 65280 and coordinates by less than 2^15.
  [[nodiscard]] ARCSPAN_OUTLINE bool is_behind_between(std::int32_t depth, std::int32_t row) const {
    const RasterPosition& from = edge_->from;
    const RasterPosition& to = edge_->to;
    const std::int32_t begin = exchanged_ ? from.x : from.y;
    std::int32_t whole = (exchanged_ ? to.x : to.y) - begin;
    std::int32_t part = 16 * row + 8 - begin;
    if (whole < 0) {
      whole = -whole;
      part = -part;
    }
    if (part < 0) part = 0;
    if (part > whole) part = whole;
    return wrap_mul(depth + 1 - from.z, whole) <= wrap_mul(std::int32_t{to.z} - from.z, part);
  }

  const OutlineEdge* edge_ = nullptr;
  std::uint16_t nearest_ = 0;
  std::uint16_t farthest_ = 0;
  bool exchanged_ = false;
};

}  // namespace arcspan::detail
