// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/sink.hpp>
#include <arcspan/prepare/edge.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/span/row_drawer.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <cstdint>

/// Flat outlines are walked by columns with the code that walks steep ones by rows, x and y exchanged.
namespace arcspan::detail {

[[nodiscard]] constexpr RasterPosition exchanged(const RasterPosition& p) { return {p.y, p.x, p.z}; }

/// A rectangle of the picture relative to the raster origin.
[[nodiscard]] constexpr Rect relative_to(const RasterOrigin& o, const Rect& r) {
  return {r.left - o.x, r.top - o.y, r.right - o.x, r.bottom - o.y};
}

/// Sets up the columns of the edge from `top` down to `bottom` at its own first row, from where walks step to
/// theirs, so that all bands have the same. `exchanged` says that x and y are.
ARCSPAN_INLINE inline void set_up_columns(const RasterPosition& top, const RasterPosition& bottom,
                                          std::int32_t first_row, bool exchanged, EdgeWalk& walk) {
  EdgeSetup setup;
  make_edge_setup(top, bottom, first_row, setup);
  make_edge_walk(setup, top, bottom, walk);
  // A centre on the edge belongs to its right side, which is above an edge that leads down to the right.
  // 2^-19 pixels are less than the distance of any other centre (EdgeWalk).
  if (exchanged && bottom.x > top.x) walk.x += std::int64_t{1} << 13;
}

}  // namespace arcspan::detail
