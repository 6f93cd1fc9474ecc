// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/sink.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/span/row_drawer.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

namespace arcspan {

namespace detail {

/// Draws a command's rows, cut at the sides of the scissor where they cross them.
template <ShadingMethod Method, class Target>
[[nodiscard]] constexpr Status draw_crossing_rows(TriangleCommand<Method>& command,
                                                  const RasterOrigin& origin, const Target& target) {
  return Method::walk(command.shade, RowDrawer<ScissorColumns::kCrossing, TriangleCommand<Method>, Target>{
                                         command, origin, target});
}
/// Methods of arcs use a function per walker, so that frames add up to less stack.
template <ShadingMethod Method, class Target>
[[nodiscard]] ARCSPAN_OUTLINE constexpr Status draw_crossing_rows_outlined(TriangleCommand<Method>& command,
                                                                           const RasterOrigin& origin,
                                                                           const Target& target) {
  if constexpr (!DrawsSmallTriangles<Method>) return draw_crossing_rows(command, origin, target);
  using CrossingRows = RowDrawer<ScissorColumns::kCrossing, TriangleCommand<Method>, Target>;
  return Method::walk(command.shade, [&](const auto& walker) {
    return CrossingRows::draw_outlined(command, origin, walker, target);
  });
}

}  // namespace detail

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
  const NoEncodedColours encoded{};
  const detail::RowTarget<typename Method::Lighting, Sink, Depth> target{scissor, lighting, sink, depth,
                                                                         encoded};
  if (!command.has_rows_in(scissor.top, scissor.bottom, origin.y)) return Status::kOk;
  return detail::draw_crossing_rows(command, origin, target);
}

}  // namespace arcspan
