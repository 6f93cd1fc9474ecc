// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/span/draw_command.hpp>
#include <arcspan/span/draw_small.hpp>

#include <tests/support/strict_sink.hpp>

#include <optional>

namespace arcspan::test {

/// Method for tests that only look at coverage: nothing is interpolated.
using Silhouette = Flat<Illumination<1, Highlight::kBlinn>>;

/// The raster half of the pipeline, from vertices on the screen to a sink, as draw_mesh runs it.
template <class Method, class Sink, class Depth = NoDepth>
class RasterStage {
 public:
  RasterStage(Sink& sink, std::int32_t width, std::int32_t height, typename Method::Lighting lighting = {},
              Depth depth = {})
      : sink_(sink),
        lighting_(lighting),
        depth_(depth),
        origin_{width / 2, height / 2},
        rows_{-(height / 2), height - height / 2},
        clip_(sink.bounds()) {}

  /// True if the triangle gave a command.
  bool draw(const RasterVertex<Method>& a, const RasterVertex<Method>& b, const RasterVertex<Method>& c,
            const typename Method::Face& face = {}) {
    if constexpr (DrawsSmallTriangles<Method>) {
      if (const auto drawn = draw_small(a, b, c, face)) return *drawn;
    }
    TriangleCommand<Method> command;
    if (!prepare_triangle(lighting_, a, b, c, face, rows_, command)) return false;
    return ok(draw_command(command, origin_, clip_, lighting_, sink_, depth_));
  }

  /// Draws small triangles by TriangleCommands too.
  void leave_out_small_triangles() { draws_small_ = false; }

  void clip_to(const Rect& clip) { clip_ = clip; }
  [[nodiscard]] const Rect& clip() const { return clip_; }
  [[nodiscard]] RasterOrigin origin() const { return origin_; }

 private:
  /// Draws a small triangle and returns true if it has rows, or nothing if it has to be a TriangleCommand.
  std::optional<bool> draw_small(const RasterVertex<Method>& a, const RasterVertex<Method>& b,
                                 const RasterVertex<Method>& c, const typename Method::Face& face) {
    const RasterPosition& p = a.position;
    if (!draws_small_ || !in_guard_band(p)) return std::nullopt;
    const std::int32_t area = doubled_area(p, b.position, c.position);
    SortedVertices<Method> vertices{&a, &b, &c, area < 0};
    arcspan::detail::sort_by_height(vertices);
    if (!is_small(vertices)) return std::nullopt;
    if (area == 0 || clip_.empty()) return false;
    const arcspan::detail::RowTarget<typename Method::Lighting, Sink, Depth> target{clip_, lighting_, sink_,
                                                                                    depth_};
    Status status = Status::kOk;
    const RowRange drawn{clip_.top - origin_.y, clip_.bottom - origin_.y};
    const auto face_of = [&] { return face; };
    switch (arcspan::detail::draw_small_triangle<Method>(vertices, face_of, rows_, drawn, origin_, target,
                                                         status)) {
      case arcspan::detail::SmallResult::kDone:
        return ok(status);
      case arcspan::detail::SmallResult::kOutOfView:
        return false;
      case arcspan::detail::SmallResult::kRefused:
        break;
    }
    return std::nullopt;
  }

  bool draws_small_ = true;
  Sink& sink_;
  typename Method::Lighting lighting_;
  Depth depth_;
  RasterOrigin origin_;
  RowRange rows_;
  Rect clip_;
};

[[nodiscard]] inline RasterVertex<Silhouette> at(std::int32_t x, std::int32_t y) {
  return {{static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), 0}, {}};
}

}  // namespace arcspan::test
