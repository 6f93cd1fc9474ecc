// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/counting/operation_counts.hpp>

/// Operations of one pixel's normal alone, without illumination, counted in the pipeline's own text.
namespace arcspan_counting {

/// Classic Phong: three components one pixel on, then of unit length.
[[nodiscard]] OperationCounts classic_normal_operations();
/// The same by a reciprocal root and multiplies.
[[nodiscard]] OperationCounts reciprocal_normal_operations();
/// By Taylor's series and by forward differences; one scalar (N·L) each, since these methods make no vector.
[[nodiscard]] OperationCounts lyon_operations();
[[nodiscard]] OperationCounts duff_operations();
/// S0 eq. 2: all three components of one pixel.
[[nodiscard]] OperationCounts slerp_normal_operations();
/// S0 eq. 7 and 14: one component or scalar one pixel on.
[[nodiscard]] OperationCounts recurrence_operations();
/// S0 eq. 7 and 9 to 11: one scalar four pixels on.
[[nodiscard]] OperationCounts four_steps_operations();

}  // namespace arcspan_counting
