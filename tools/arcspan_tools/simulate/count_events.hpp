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

  [[nodiscard]] bool is_whole() const { return rows_ == size_.height; }

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

/// Counts the vertices that a source has transformed.
template <class Method>
void count_vertices(const VertexStage<Method>& stage, const std::vector<CachedVertex<Method>>& cache,
                    DrawEvents& events) {
  const auto count = static_cast<double>(cache.size());
  if (!stage.back_faces().known()) {
    events.vertices += count;
    return;
  }
  events.forgotten += count;
  for (const CachedVertex<Method>& vertex : cache) {
    if (vertex.outcode != CachedVertex<Method>::kNotTransformed) ++events.wanted_vertices;
  }
}

/// Counts the triangles whose rows were found.
template <class Method>
void count_rows(const VertexStage<Method>& stage, const std::vector<TriangleRows>& rows, DrawEvents& events) {
  const BackFaces& back_faces = stage.back_faces();
  const std::size_t count = stage.mesh().triangle_count();
  if (back_faces.known()) events.planes += static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (back_faces.known()) i = back_faces.next_front(i, count);
    if (i >= count) return;
    ++events.row_triangles;
    if (rows[i] != TriangleRows::culled()) ++events.row_fronts;
  }
}

/// The triangles that a draw call looks at: a filter of detail::TriangleDrawer, which counts what it does.
template <class Method>
class CountedTriangles {
 public:
  /// `rows` is empty if the picture is drawn at once.
  CountedTriangles(const VertexStage<Method>& stage, const std::vector<TriangleRows>& rows, const Rect& band,
                   DrawEvents& events)
      : stage_(stage), rows_(rows.data()), has_rows_(!rows.empty()), events_(events) {
    const int bits = TriangleRows::group_bits(stage.transform().viewport().height);
    band_ = {static_cast<std::uint8_t>(band.top >> bits),
             static_cast<std::uint8_t>((band.bottom - 1) >> bits)};
    if (!has_rows_ && stage.back_faces().known())
      events.planes += static_cast<double>(stage.mesh().triangle_count());
  }

  [[nodiscard]] std::size_t next(std::size_t i) {
    const std::size_t count = stage_.mesh().triangle_count();
    if (!has_rows_) return stage_.back_faces().known() ? stage_.back_faces().next_front(i, count) : i;
    constexpr std::size_t kBatch = TriangleRows::kBatch;
    for (std::size_t step = 1; i < count; i += step) {
      const bool whole = i % kBatch == 0 && i + kBatch <= count;
      if (whole) ++events_.batches;
      step = whole && !reaches(rows_[count + i / kBatch]) ? kBatch : 1;
      if (step != 1) continue;
      ++events_.row_entries;
      if (reaches(rows_[i])) break;
    }
    return i;
  }

 private:
  [[nodiscard]] bool reaches(const TriangleRows& rows) const {
    return rows.last >= band_.first && rows.first <= band_.last;
  }

  const VertexStage<Method>& stage_;
  const TriangleRows* rows_;
  bool has_rows_;
  TriangleRows band_{};
  DrawEvents& events_;
};

/// Counts what clipping a triangle on one of its sides takes and leaves.
template <class Method>
void count_clipped(const VertexStage<Method>& stage, const TriangleIndices& t, arcspan::detail::Facing facing,
                   DrawEvents& events) {
  ++events.clipped;
  const TriangleIndices order = arcspan::detail::in_clip_order(t, facing);
  ClipPolygon<Method> polygon;
  std::size_t corner = 0;
  for (const std::uint16_t i : {order.a, order.b, order.c})
    polygon[corner++].position = stage.clip_position(i);
  const WRange& w_range = stage.transform().w_range();
  for (const ClipOutcode plane : arcspan::detail::kClipPlanes) {
    std::size_t outside = 0;
    for (std::size_t i = 0; i < polygon.count(); ++i) {
      if (arcspan::detail::plane_distance(polygon[i].position, plane, w_range) < 0) ++outside;
    }
    events.clip_steps += static_cast<double>(polygon.count());
    if (outside > 0 && outside < polygon.count()) events.clip_cuts += 2;
    polygon.clip(plane, w_range);
  }
  events.clip_corners += static_cast<double>(polygon.count());
}

/// Counts what the loop over the triangles of a mesh finds in a band, from the vertices that it has left.
template <class Method>
void count_triangles(const VertexStage<Method>& stage, const std::vector<CachedVertex<Method>>& cache,
                     const std::vector<TriangleRows>& rows, const Rect& bounds, bool two_sided,
                     DrawEvents& events) {
  const MeshView& mesh = stage.mesh();
  const arcspan::detail::Scissor scissor(stage.transform().viewport(), bounds);
  const bool known = rows.empty() && stage.back_faces().known();
  CountedTriangles<Method> triangles(stage, rows, scissor.rect(), events);
  const std::size_t count = mesh.triangle_count();
  for (std::size_t i = triangles.next(0); i < count; i = triangles.next(i + 1)) {
    ++(known ? events.facing : events.triangles);
    const TriangleIndices t = mesh.triangle(i);
    const CachedVertex<Method>& a = cache[t.a];
    const CachedVertex<Method>& b = cache[t.b];
    const CachedVertex<Method>& c = cache[t.c];
    if ((a.outcode | b.outcode | c.outcode) != 0) {
      if ((a.outcode & b.outcode & c.outcode) != 0) continue;
      count_clipped(stage, t, arcspan::detail::Facing::kFront, events);
      if (two_sided) count_clipped(stage, t, arcspan::detail::Facing::kBack, events);
      continue;
    }
    const RasterPosition& p = a.raster.position;
    const RasterPosition& q = b.raster.position;
    const RasterPosition& r = c.raster.position;
    const std::int32_t area = doubled_area(p, q, r);
    if (arcspan::detail::is_culled_by_area<Method>(area, two_sided)) continue;
    ++(known ? events.facing_fronts : events.fronts);
    if (scissor.test(p, q, r) == arcspan::detail::ScissorTest::kOutside) continue;
    ++events.in_view;
    if (area > 0) ++events.backs;
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

/// Draws a part with a cache that it keeps from band to band, and adds the events. `tints`: its highlights
/// have a colour, or are black.
template <class Plain>
void count_events(const RenderPart& part, const ClipTransform& transform,
                  const typename Plain::Lighting& lighting, bool tints, EventPicture& picture,
                  DrawEvents& events) {
  using Counting = EventMethod<Plain>;
  EventTarget target;
  target.tints = tints;
  EventTarget::current = &target;
  VertexStage<Counting> stage(part.mesh, transform, lighting);
  if (!part.two_sided) stage.find_back_faces();
  std::vector<CachedVertex<Counting>> vertices(part.mesh.vertex_count());
  std::vector<TriangleRows> rows(picture.is_whole() ? 0 : TriangleRows::entries(part.mesh.triangle_count()));
  VertexCache<Counting> cache(vertices, rows);
  picture.for_each_band([&](hal::Framebuffer<Rgb565>& sink, const DepthBuffer& depth) {
    ++target.events.calls;
    (void)draw_mesh<Counting>(part.mesh, transform, lighting, sink, depth, cache, {part.two_sided});
    count_triangles(stage, vertices, rows, sink.bounds(), part.two_sided, target.events);
  });
  count_vertices(stage, vertices, target.events);
  if (!rows.empty()) count_rows(stage, rows, target.events);
  EventTarget::current = nullptr;
  events = target.events;
}

}  // namespace arcspan::tools
