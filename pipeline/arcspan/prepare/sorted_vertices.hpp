// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/target.hpp>

namespace arcspan::detail {

/// The vertices of a triangle, sorted by height.
template <class Vertex>
struct SortedVertices {
  const Vertex* top;
  const Vertex* middle;
  const Vertex* bottom;

  ARCSPAN_INLINE constexpr SortedVertices(const Vertex& a, const Vertex& b, const Vertex& c)
      : top(&a), middle(&b), bottom(&c) {
    order(top, middle);
    order(middle, bottom);
    order(top, middle);
  }

 private:
  ARCSPAN_INLINE static constexpr void order(const Vertex*& upper, const Vertex*& lower) {
    if (lower->position.y < upper->position.y) {
      const Vertex* const held = upper;
      upper = lower;
      lower = held;
    }
  }
};

}  // namespace arcspan::detail
