// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/linear.hpp>
#include <arcspan/span/row_start.hpp>

#include <cstdint>

namespace arcspan {

/// The attribute at a row's first pixel. Beyond the first column it goes in whole steps, so that cutting a
/// row changes nothing.
[[nodiscard]] constexpr Linear linear_at(const LinearPlane& plane, const RowStart& start) {
  const Linear first = plane.left.at + times_fraction(plane.dx, start.fraction);
  if (start.skipped == 0) [[likely]] {
    return first;
  }
  return first + Linear::from_raw(wrap_mul(plane.dx.raw(), start.skipped));
}

}  // namespace arcspan
