// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/triangle.hpp>
#include <arcspan/target.hpp>

namespace arcspan {

/// Sets the reciprocals of the short edges, for methods that interpolate along both edges of a row.
template <class Method>
constexpr void make_short_inverses(TriangleFrame<Method>& frame) {
  if (frame.middle_left || !kHasLongMultiply) return;
  if (frame.has_upper) frame.upper_edge.make_inverse();
  if (frame.has_lower) frame.lower_edge.make_inverse();
}

}  // namespace arcspan
