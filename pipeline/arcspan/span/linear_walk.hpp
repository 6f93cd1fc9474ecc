// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/linear.hpp>

#include <cstdint>

namespace arcspan {

/// A LinearPlane on its way down the rows, which it walks in place.
class LinearWalk {
 public:
  constexpr LinearWalk(LinearPlane& plane, bool middle_left)
      : edge_(&plane.left[0]), lower_(middle_left ? &plane.left[1] : &plane.left[0]), dx_(plane.dx) {}

  /// The attribute at a distance of `fraction` (16 fraction bits) pixels to the right of the left edge.
  [[nodiscard]] constexpr Linear at(std::uint32_t fraction) const {
    const Linear whole = Linear::from_raw(wrap_mul(dx_.raw(), static_cast<std::int32_t>(fraction >> 16)));
    return edge_->at + whole + times_fraction(dx_, fraction & 0xFFFFu);
  }
  [[nodiscard]] constexpr Linear dx() const { return dx_; }

  constexpr void next_row() { edge_->at += edge_->step; }
  constexpr void enter_lower() { edge_ = lower_; }

 private:
  LinearEdge* edge_;
  LinearEdge* lower_;
  Linear dx_;
};

}  // namespace arcspan
