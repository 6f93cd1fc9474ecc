// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/edge.hpp>
#include <arcspan/prepare/input_vertex.hpp>
#include <arcspan/target.hpp>

namespace arcspan {

/// The long edge of a triangle at its first row, for methods that NeedsNearOverW; empty for others.
template <class Method>
struct LongWalk {};
/// The long edge of a method that NeedsNearOverW.
template <NeedsNearOverW Method>
struct LongWalk<Method> : EdgeWalk {
  // Member by member, because small cores would copy the whole by memcpy.
  constexpr void set(const EdgeWalk& edge) {
    x = edge.x;
    step = edge.step;
  }
};

}  // namespace arcspan
