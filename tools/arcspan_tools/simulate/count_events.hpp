// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>

#include <arcspan_tools/render/render.hpp>
#include <arcspan_tools/simulate/event_method.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace arcspan::tools {

/// The depths of a picture in bands, and a place for the colours of one.
class EventPicture {
 public:
  /// Bands have `margin` more rows above and below those that are shown.
  EventPicture(const Viewport& size, std::int32_t band_rows, std::int32_t margin)
      : size_(size),
        rows_(std::clamp(band_rows, 1, size.height)),
        margin_(rows_ == size.height ? 0 : margin) {
    const std::int32_t drawn = rows_ + 2 * margin_;
    colours_.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(drawn));
    const auto words = static_cast<std::size_t>(DepthBuffer::words(size.width, drawn));
    for (std::int32_t top = 0; top < size.height; top += rows_)
      depths_.emplace_back(words, DepthBuffer::kFarthest);
  }

  /// Calls draw(sink, depth) for each band.
  template <class Draw>
  void for_each_band(const Draw& draw) {
    std::int32_t top = 0;
    for (std::vector<std::uint16_t>& words : depths_) {
      const std::int32_t first = std::max(top - margin_, 0);
      const std::int32_t rows = std::min(rows_ + 2 * margin_, size_.height - first);
      hal::Framebuffer<Rgb565> sink(colours_, size_.width, rows);
      const DepthBuffer depth(words, size_.width, rows, first);
      sink.move_to(first);
      draw(sink, depth);
      top += rows_;
    }
  }

 private:
  Viewport size_;
  std::int32_t rows_;
  std::int32_t margin_;
  std::vector<std::uint16_t> colours_;
  std::vector<std::vector<std::uint16_t>> depths_;
};

/// Counts what the loop over the triangles of a mesh finds in a band, from the vertices that it has left.
template <class Method>
void count_triangles(const VertexStage<Method>& stage, const std::vector<CachedVertex<Method>>& cache,
                     const Rect& bounds, bool two_sided, DrawEvents& events) {
  const MeshView& mesh = stage.mesh();
  const arcspan::detail::Scissor scissor(stage.transform().viewport(), bounds);
  const bool known = stage.back_faces().known();
  for (const CachedVertex<Method>& vertex : cache) {
    if (!known)
      ++events.vertices;
    else if (vertex.outcode != CachedVertex<Method>::kNotTransformed)
      ++events.wanted_vertices;
  }
  if (known) {
    events.forgotten += static_cast<double>(cache.size());
    events.planes += static_cast<double>(mesh.triangle_count());
  }
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    if (known) i = stage.back_faces().next_front(i, mesh.triangle_count());
    if (i >= mesh.triangle_count()) return;
    ++(known ? events.facing : events.triangles);
    const TriangleIndices t = mesh.triangle(i);
    const CachedVertex<Method>& a = cache[t.a];
    const CachedVertex<Method>& b = cache[t.b];
    const CachedVertex<Method>& c = cache[t.c];
    if ((a.outcode | b.outcode | c.outcode) != 0) {
      if ((a.outcode & b.outcode & c.outcode) == 0) ++events.clipped;
      continue;
    }
    const RasterPosition& p = a.raster.position;
    const RasterPosition& q = b.raster.position;
    const RasterPosition& r = c.raster.position;
    const std::int32_t area = doubled_area(p, q, r);
    if (arcspan::detail::is_culled_by_area<Method>(area, two_sided)) continue;
    ++events.fronts;
    if (scissor.template test<true>(p, q, r) == arcspan::detail::ScissorTest::kOutside) continue;
    ++events.in_view;
    if constexpr (DrawsSmallTriangles<Method>) {
      SortedVertices<Method> sorted{&a.raster, &b.raster, &c.raster, area < 0};
      arcspan::detail::sort_by_height(sorted);
      if (!is_small(sorted)) continue;
      SmallTriangle triangle;
      if (!cover_small_triangle(sorted.top->position, sorted.middle->position, sorted.bottom->position,
                                sorted.middle_left, scissor.drawn_rows(), triangle))
        ++(triangle.rows > 0 ? events.small_empty : events.small_rowless);
    }
  }
}

/// Draws a part with its own cache in each band, and adds the events.
template <class Plain>
void count_events(const RenderPart& part, const ClipTransform& transform,
                  const typename Plain::Lighting& lighting, EventPicture& picture, DrawEvents& events) {
  using Counting = EventMethod<Plain>;
  EventTarget target;
  EventTarget::current = &target;
  std::vector<CachedVertex<Counting>> cache(part.mesh.vertex_count());
  picture.for_each_band([&](hal::Framebuffer<Rgb565>& sink, const DepthBuffer& depth) {
    ++target.events.calls;
    (void)draw_mesh<Counting>(part.mesh, transform, lighting, sink, depth, std::span(cache),
                              {part.two_sided});
    VertexStage<Counting> stage(part.mesh, transform, lighting);
    if (!part.two_sided) stage.find_back_faces();
    count_triangles(stage, cache, sink.bounds(), part.two_sided, target.events);
  });
  EventTarget::current = nullptr;
  events = target.events;
}

}  // namespace arcspan::tools
