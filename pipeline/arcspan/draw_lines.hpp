// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/check_call.hpp>
#include <arcspan/draw/line_stage.hpp>
#include <arcspan/draw/scissor.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/unlit.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/clip_transform.hpp>

#include <cstdint>
#include <span>

namespace arcspan {

/// A line between two points in object space.
struct ObjectLine {
  ObjectPosition from;
  ObjectPosition to;
};

namespace detail {

/// Draws the lines and points of one call into the part of a sink and a depth buffer that both cover.
template <OneColour Method, PixelSink Sink, DepthTarget Depth>
class LineStage {
 public:
  using Target = RowTarget<typename Method::Lighting, Sink, Depth>;

  LineStage(const Viewport& viewport, const typename Method::Lighting& colour, Sink& sink, const Depth& depth,
            DepthBias bias)
      : scissor_(viewport, sink.bounds()),
        target_{scissor_.rect(), colour, sink, depth},
        bias_(bias),
        status_(check_target(scissor_, sink, depth)) {
    check_call(colour, depth);
  }

  [[nodiscard]] bool ready() const { return !scissor_.rect().empty() && ok(status_); }
  [[nodiscard]] Status status() const { return status_; }

  /// Draws a line between two points within the guard band.
  void draw(const RasterPosition& a, const RasterPosition& b) {
    if (!has_pixels(scissor_, a, b)) return;
    status_ = draw_line_between<Method>(a, b, bias_.units, scissor_.origin(), target_);
  }
  /// Draws a line, of which the planes and the guard band may cut parts.
  void draw(const ClipTransform& transform, const ClipPosition& from, const ClipPosition& to) {
    RasterPosition a;
    RasterPosition b;
    const std::uint8_t from_outside = outcode(from, transform.w_range());
    const std::uint8_t to_outside = outcode(to, transform.w_range());
    if ((from_outside & to_outside) != 0) return;
    if ((from_outside | to_outside) != 0) {
      if (!clip_line(transform, from, to, a, b)) return;
    } else {
      a = project(from, transform);
      b = project(to, transform);
    }
    draw(a, b);
  }
  /// Draws a square around a point.
  void draw_square(const RasterPosition& middle, std::int32_t size) {
    const RasterOrigin& origin = scissor_.origin();
    const std::int32_t left = pixel_of(middle.x - 8 * size + 8) + origin.x;
    const std::int32_t top = pixel_of(middle.y - 8 * size + 8) + origin.y;
    const Rect rect = intersection({left, top, left + size, top + size}, scissor_.rect());
    if (rect.empty()) return;
    const auto depth = static_cast<std::uint16_t>(biased_depth(middle.z, bias_.units));
    const auto bias = static_cast<std::uint16_t>(middle.z - depth);  // less than wanted at the near plane
    status_ = draw_rectangle<Method>(rect, depth, bias, target_);
  }

 private:
  const Scissor scissor_;
  const Target target_;
  const DepthBias bias_;
  Status status_;
};

/// The point with its depth within those of the planes: the depth of a line that leads beyond it, and that of
/// its fog, would wrap otherwise.
[[nodiscard]] constexpr RasterPosition within_planes(const RasterPosition& p) {
  return {p.x, p.y, static_cast<std::uint16_t>(biased_depth(p.z, 0))};
}

}  // namespace detail

/// Draws lines of one colour, one pixel wide. Each is clipped, and tested against `depth` with its own depth
/// along the line, `bias` nearer. The pixels of a line do not depend on the order of its ends, nor on the
/// bands in which a picture is drawn. `Method` is Unlit or WithOperation<Unlit, ...>: lines in fog,
/// transparent ones.
///
/// Returns kOk, or the first other status of the sink, at which drawing stops. Draws nothing and returns the
/// status() of a Framebuffer or DepthBuffer that is not kOk, or kDepthMismatch if `depth` does not cover the
/// common bounds of the viewport and the sink.
template <OneColour Method = Unlit, PixelSink Sink, DepthTarget Depth>
[[nodiscard]] ARCSPAN_OUTLINE Status draw_lines(std::span<const ObjectLine> lines,
                                                const ClipTransform& transform,
                                                const typename Method::Lighting& colour, Sink& sink,
                                                const Depth& depth, DepthBias bias = {0}) {
  detail::LineStage<Method, Sink, Depth> stage(transform.viewport(), colour, sink, depth, bias);
  for (std::size_t i = 0; i < lines.size() && stage.ready(); ++i) {
    stage.draw(transform, transform(lines[i].from), transform(lines[i].to));
  }
  return stage.status();
}

/// Draws points as squares of `size` x `size` pixels of one depth, up to 255. A point outside of the planes
/// or the guard band is left out; it could reach into pictures wider or higher than 1793 pixels only. All
/// else as draw_lines().
template <OneColour Method = Unlit, PixelSink Sink, DepthTarget Depth>
[[nodiscard]] ARCSPAN_OUTLINE Status draw_points(std::span<const ObjectPosition> points, std::uint8_t size,
                                                 const ClipTransform& transform,
                                                 const typename Method::Lighting& colour, Sink& sink,
                                                 const Depth& depth, DepthBias bias = {0}) {
  detail::LineStage<Method, Sink, Depth> stage(transform.viewport(), colour, sink, depth, bias);
  for (std::size_t i = 0; i < points.size() && stage.ready(); ++i) {
    const ClipPosition at = transform(points[i]);
    if (outcode(at, transform.w_range()) != kInside) continue;
    stage.draw_square(project(at, transform), size);
  }
  return stage.status();
}

/// Draws a line between two points of the screen, whose coordinates and depths are those of RasterPosition,
/// into a picture of the size of `viewport`. A depth beyond those of the planes, 256...65279, is taken as
/// that of the plane. Returns kInvalidArgument, and draws nothing, if the size is not 1...2048 or a point is
/// outside the guard band. All else as draw_lines().
template <OneColour Method = Unlit, PixelSink Sink, DepthTarget Depth>
[[nodiscard]] Status draw_screen_line(const RasterPosition& a, const RasterPosition& b,
                                      const Viewport& viewport, const typename Method::Lighting& colour,
                                      Sink& sink, const Depth& depth, DepthBias bias = {0}) {
  if (!detail::is_picture_size(viewport) || !in_guard_band(a) || !in_guard_band(b))
    return Status::kInvalidArgument;
  detail::LineStage<Method, Sink, Depth> stage(viewport, colour, sink, depth, bias);
  if (stage.ready()) stage.draw(detail::within_planes(a), detail::within_planes(b));
  return stage.status();
}

}  // namespace arcspan
