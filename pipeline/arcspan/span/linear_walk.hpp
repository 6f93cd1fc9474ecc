// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/linear.hpp>
#include <arcspan/span/row_start.hpp>

#include <cstdint>

namespace arcspan {

/// The attribute at a row's first pixel. Beyond the first column it goes in whole steps, so that cutting a
/// row changes nothing.
[[nodiscard, gnu::always_inline]] constexpr Linear linear_at(const LinearPlane& plane,
                                                             const RowStart& start) {
  const Linear first = plane.left.at + times_fraction(plane.dx, start.fraction);
  if (start.skipped == 0) [[likely]] {
    return first;
  }
  return first + Linear::from_raw(wrap_mul(plane.dx.raw(), start.skipped));
}

/// The same by one multiply for what lies within a pixel, with an error below 2: an 8-bit step has 256.
[[nodiscard, gnu::always_inline]] constexpr FullLinear linear_at(const FullLinearPlane& plane,
                                                                 const RowStart& start) {
  const std::int32_t inside = wrap_mul(plane.dx.raw() >> 16, static_cast<std::int32_t>(start.fraction));
  const std::int32_t skipped = wrap_mul(plane.dx.raw(), start.skipped);
  return plane.left.at + FullLinear::from_raw(wrap_add(inside, skipped));
}

}  // namespace arcspan
