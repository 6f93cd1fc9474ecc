// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/sink.hpp>
#include <arcspan/prepare/triangle_command.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/span/row_drawer.hpp>
#include <arcspan/status.hpp>

namespace arcspan {

/// Draws a triangle command into the part of `sink` and `depth` that lies within `scissor`, which must be
/// within the bounds of both. `origin` is where the command's coordinates begin. Changes the command; it can
/// be drawn once.
///
/// Returns kOk, or the first other status of the sink, at which drawing stops. Rows above the scissor are
/// stepped over, so that a picture drawn in bands is bit for bit the picture drawn at once.
template <ShadingMethod Method, PixelSink Sink, DepthTarget Depth>
[[nodiscard]] constexpr Status draw_command(TriangleCommand<Method>& command, const RasterOrigin& origin,
                                            const Rect& scissor, const typename Method::Lighting& lighting,
                                            Sink& sink, const Depth& depth) {
  if (scissor.empty()) return Status::kOk;
  const detail::RowTarget<typename Method::Lighting, Sink, Depth> target{scissor, lighting, sink, depth};
  if (!command.has_rows_in(scissor.top, scissor.bottom, origin.y)) return Status::kOk;
  using CrossingRows = detail::RowDrawer<detail::ScissorColumns::kCrossing, TriangleCommand<Method>,
                                         detail::RowTarget<typename Method::Lighting, Sink, Depth>>;
  return Method::walk(command.shade, CrossingRows{command, origin, target});
}

}  // namespace arcspan
