// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/target.hpp>
#include <arcspan/vertex/project.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <cstdint>

namespace arcspan {

/// Optional part of a method (`kNeedsNearOverW`): its vertices have near/w, for attributes in perspective.
template <class M>
concept NeedsNearOverW = bool{M::kNeedsNearOverW};

/// near/w of a vertex, 29 fraction bits, 0...1.
struct NearOverW {
  std::int32_t value;
};

/// Input vertex of triangle preparation: its position on the screen and the shading method's data.
template <class Method>
struct RasterVertex {
  RasterPosition position;
  typename Method::Vertex shade;
};
/// RasterVertex of a method that NeedsNearOverW.
template <NeedsNearOverW Method>
struct RasterVertex<Method> {
  RasterPosition position;
  typename Method::Vertex shade;
  NearOverW near_over_w;
};

namespace detail {

/// Sets where a vertex inside the clip volume is on the screen.
template <class Method>
ARCSPAN_INLINE inline void place_on_screen(const ClipPosition& position, const ClipTransform& transform,
                                           RasterVertex<Method>& vertex) {
  if constexpr (NeedsNearOverW<Method>) {
    vertex.position = project_in_perspective(position, transform, vertex.near_over_w.value);
  } else {
    project_to(position.x, position.y, position.w, transform, vertex.position);
  }
}

/// A copy of a vertex without its shading.
template <class Method>
[[nodiscard]] constexpr RasterVertex<Method> unshaded(const RasterVertex<Method>& vertex) {
  RasterVertex<Method> copy{};
  copy.position = vertex.position;
  if constexpr (NeedsNearOverW<Method>) copy.near_over_w = vertex.near_over_w;
  return copy;
}

}  // namespace detail

}  // namespace arcspan
