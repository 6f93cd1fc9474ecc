// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/reciprocal.hpp>

namespace arcspan {

/// The reciprocal of TriangleFrame::width.
template <class Frame>
[[nodiscard]] constexpr Reciprocal inverse_width(const Frame& frame) {
  return (frame.width >> 16) != 0 ? frame.inverse_unit : nonzero_reciprocal(frame.width);
}

}  // namespace arcspan
