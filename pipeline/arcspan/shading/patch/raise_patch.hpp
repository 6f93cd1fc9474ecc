// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/patch/patch.hpp>
#include <arcspan/target.hpp>

namespace arcspan {

/// Adds `by` to a scalar that was made for the same frame: to the edges that are set. Inlined, because the
/// smallest program would take 12 bytes more of stack.
template <class Method>
ARCSPAN_INLINE constexpr void raise_patch_scalar(const TriangleFrame<Method>& frame, Cosine by,
                                                 PatchScalar& scalar) {
  if (!frame.middle_left || frame.has_upper) scalar.left.at += by;
  if (frame.middle_left && frame.has_lower) scalar.lower.at += by;
}

}  // namespace arcspan
