// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/check_target.hpp>
#include <arcspan/draw/draw_options.hpp>
#include <arcspan/draw/edge_drawer.hpp>
#include <arcspan/draw/scissor.hpp>
#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/draw/visible_triangles.hpp>
#include <arcspan/mesh/face_normal.hpp>
#include <arcspan/span/draw_command.hpp>
#include <arcspan/span/draw_small.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace arcspan::detail {

/// Draws the triangles of one draw_mesh() call: culls, clips, shades, prepares and hands the commands
/// to the span stage.
template <ShadingMethod Method, DrawFeatures Features, PixelSink Sink, DepthTarget Depth>
class TriangleDrawer {
 public:
  using Vertex = CachedVertex<Method>;

  TriangleDrawer(const MeshView& mesh, const ClipTransform& transform,
                 const typename Method::Lighting& lighting, Sink& sink, const Depth& depth,
                 const DrawOptions& options)
      : stage_(mesh, transform, lighting),
        scissor_(transform.viewport(), sink.bounds()),
        target_{scissor_.rect(), lighting, sink, depth, encoded_},
        options_(options) {
    const bool supported = Features.two_sided || !options_.two_sided;
    result_.status = supported ? check_target(scissor_, sink, depth) : Status::kUnsupported;
  }

  /// True if there is something to draw into and nothing has failed.
  [[nodiscard]] bool ready() const { return !scissor_.rect().empty() && ok(result_.status); }
  [[nodiscard]] const VertexStage<Method>& stage() const { return stage_; }
  [[nodiscard]] const DrawResult& result() const { return result_; }
  [[nodiscard]] const Scissor& scissor() const { return scissor_; }
  [[nodiscard]] bool two_sided() const { return Features.two_sided && options_.two_sided; }
  /// The triangles that may be visible, as far as planes say.
  [[nodiscard]] VisibleTriangles visible_triangles() const {
    if constexpr (Features.planes) {
      // Triangles without a pixel centre in the band may have edges there.
      const bool in_band = scissor_.is_band() && !DrawsEdges<Method>;
      if (!two_sided()) return VisibleTriangles(stage_.mesh(), stage_.transform(), scissor_, in_band);
    }
    return VisibleTriangles(stage_.mesh());
  }

  /// Draws the mesh with the vertices of a source (vertex_source.hpp) until the sink fails.
  template <class Source>
  ARCSPAN_INLINE void draw_triangles(Source vertices) {
    encoded_.set(stage_.lighting());
    const MeshView& mesh = stage_.mesh();
    const std::size_t count = mesh.triangle_count();
    for (std::size_t i = vertices.next(0, count); i < count; i = vertices.next(i + 1, count)) {
      const TriangleIndices t = mesh.triangle(i);
      auto&& a = vertices[t.a];
      auto&& b = vertices[t.b];
      auto&& c = vertices[t.c];
      if (is_culled<Source::kAllInside>(a, b, c)) continue;
      if (!Source::kAllInside && !DrawsEdges<Method> && !are_inside(a, b, c)) {
        draw_clipped(t);
      } else if constexpr (Features.caches && (kSavesRegistersAtOnce || kOptimisedForSize)) {
        // With a cache there are several loops, which share one function.
        draw_triangle_outlined(t, a, b, c);
      } else {
        draw_triangle(t, a, b, c);
      }
      if (!ok(result_.status)) return;
    }
  }
  template <class Source>
  ARCSPAN_OUTLINE void draw_triangles_outlined(const Source& vertices) {
    draw_triangles(vertices);
  }

 private:
  using Raster = RasterVertex<Method>;
  using Face = typename Method::Face;
  using Colours = EncodedColoursFor<Method, Sink>;
  using Target = RowTarget<typename Method::Lighting, Sink, Depth, Colours>;
  static constexpr bool kWholeRows = Features.whole_rows && kWholeRowsPay;
  static constexpr bool kDrawsSmall = Features.small_triangles && DrawsSmallTriangles<Method>;

  /// True if the triangle lies outside one plane of the clip volume, has no area, or shows its back and backs
  /// are not drawn: the case of half of all triangles, before anything is set up.
  template <bool AllInside>
  [[nodiscard]] ARCSPAN_INLINE_AT_OS bool is_culled(const Vertex& a, const Vertex& b, const Vertex& c) const {
    if constexpr (AllInside) {
      return doubled_area(a.raster.position, b.raster.position, c.raster.position) >= 0;
    } else {
      if (!are_inside(a, b, c)) return (a.outcode & b.outcode & c.outcode) != 0;
      const std::int32_t doubled = doubled_area(a.raster.position, b.raster.position, c.raster.position);
      return is_culled_by_area<Method>(doubled, two_sided());
    }
  }

  [[nodiscard]] static bool are_inside(const Vertex& a, const Vertex& b, const Vertex& c) {
    return (a.outcode | b.outcode | c.outcode) == 0;
  }

  /// Draws a triangle that is not culled and not clipped, and counts it if a part of it is in view.
  ARCSPAN_INLINE void draw_triangle(const TriangleIndices& t, Vertex& a, Vertex& b, Vertex& c) {
    const RasterPosition& p = a.raster.position;
    const RasterPosition& q = b.raster.position;
    const RasterPosition& r = c.raster.position;
    if constexpr (DrawsEdges<Method>) {
      bool drawn = false;
      const EdgeDrawer<Method, Target> edges{stage_, scissor_, target_, two_sided(), result_, drawn};
      edges.template draw<Features.clips>(t, a, b, c);
      if (drawn) ++result_.triangles;
    } else if (is_within_scissor(p, q, r)) {
      if (two_sided() && doubled_area(p, q, r) > 0) {
        draw_back(t, a.raster, b.raster, c.raster);
      } else {
        if constexpr (!std::is_empty_v<typename Method::Vertex>) {
          stage_.shade(t.a, a);
          stage_.shade(t.b, b);
          stage_.shade(t.c, c);
        }
        draw_side(t, a.raster, b.raster, c.raster, Facing::kFront);
      }
    }
  }
  ARCSPAN_OUTLINE void draw_triangle_outlined(const TriangleIndices& t, Vertex& a, Vertex& b, Vertex& c) {
    draw_triangle(t, a, b, c);
  }

  /// Draws the back of a triangle. Few meshes show backs, so their shading is not cached.
  ARCSPAN_COLD_OUTLINE void draw_back(const TriangleIndices& t, const Raster& p, const Raster& q,
                                      const Raster& r) {
    Raster a = unshaded<Method>(p);
    Raster b = unshaded<Method>(q);
    Raster c = unshaded<Method>(r);
    stage_.shade(t.a, Facing::kBack, a.shade);
    stage_.shade(t.b, Facing::kBack, b.shade);
    stage_.shade(t.c, Facing::kBack, c.shade);
    draw_side(t, a, b, c, Facing::kBack);
  }

  /// Draws a triangle across the near plane or the guard band.
  void draw_clipped(const TriangleIndices& t) {
    if constexpr (Features.clips) {
      const std::uint32_t before = result_.triangles;
      draw_clipped(t, Facing::kFront);
      if (two_sided()) draw_clipped(t, Facing::kBack);
      if (result_.triangles > before) result_.triangles = before + 1;  // its parts are one triangle
    } else {
      ++result_.left_out;
    }
  }

  /// Clips the triangle and draws the rest if it shows the side `facing`. Clipped vertices have normals that
  /// are not in the mesh, so each side is clipped with its own shading.
  ARCSPAN_COLD_OUTLINE void draw_clipped(const TriangleIndices& t, Facing facing) {
    Raster inside[ClipPolygon<Method>::kCapacity];
    const std::size_t count = clip_triangle(stage_, t, facing, inside);
    for (std::size_t i = 2; i < count && ok(result_.status); ++i) {
      const Raster& p = inside[0];
      const Raster& q = inside[i - 1];
      const Raster& r = inside[i];
      const std::int32_t area = doubled_area(p.position, q.position, r.position);
      const bool faces = facing == Facing::kFront ? area < 0 : area > 0;
      if (faces && is_within_scissor(p.position, q.position, r.position)) draw_side(t, p, q, r, facing);
    }
  }

  /// Tests the triangle against the scissor, before it is shaded.
  [[nodiscard]] ARCSPAN_INLINE_AT_OS bool is_within_scissor(const RasterPosition& a, const RasterPosition& b,
                                                            const RasterPosition& c) {
    const ScissorTest test = scissor_.template test<kWholeRows>(a, b, c);
    columns_ = test == ScissorTest::kInside ? ScissorColumns::kInside : ScissorColumns::kCrossing;
    return test != ScissorTest::kOutside;
  }

  /// Returns the method's data of the triangle's face; empty if it needs no face normal.
  [[nodiscard]] Face shaded_face([[maybe_unused]] const TriangleIndices& t,
                                 [[maybe_unused]] Facing facing) const {
    if constexpr (Method::kNeedsFaceNormal) {
      const MeshView& mesh = stage_.mesh();
      const Direction normal = face_normal(mesh.position(t.a), mesh.position(t.b), mesh.position(t.c));
      return Method::shade_face(stage_.lighting(), facing == Facing::kBack ? -normal : normal);
    } else {
      return {};
    }
  }

  /// Draws one side of a triangle whose vertices are shaded.
  ARCSPAN_INLINE void draw_side(const TriangleIndices& t, const Raster& a, const Raster& b, const Raster& c,
                                Facing facing) {
    SortedVertices<Method> vertices;
    vertices.top = &a;
    vertices.middle = &b;
    vertices.bottom = &c;
    vertices.middle_left = facing == Facing::kFront;
    sort_by_height(vertices);
    if constexpr (kDrawsSmall) {
      if (is_small(vertices) && draw_small_side(vertices, false)) return;
    }
    measure_chords(vertices);
    if constexpr (kDrawsSmall) {
      if (draws_as_small(vertices) && draw_small_side(vertices, true)) return;
    }
    draw_large_side(t, vertices, facing);
  }

  /// Returns true if a triangle that is not small is to be drawn as a small one.
  [[nodiscard]] ARCSPAN_OUTLINE_IF_TIGHT bool draws_as_small(const SortedVertices<Method>& vertices) const {
    return Method::is_dark_or_arcs(stage_.lighting(), vertices) && is_up_to_medium(vertices);
  }

  /// Draws one side of a small triangle, or of a medium one. Returns false if the method cannot.
  ARCSPAN_OUTLINE bool draw_small_side(const SortedVertices<Method>& vertices, bool is_medium) {
    const SmallResult result = draw_small_triangle<Method>(
        vertices, is_medium, columns_ == ScissorColumns::kCrossing, scissor_.viewport_rows(),
        scissor_.drawn_rows(), scissor_.origin(), target_, result_.status);
    if (result == SmallResult::kDone) ++result_.triangles;
    return result != SmallResult::kRefused;
  }

  /// Draws one side of a triangle by rows.
  ARCSPAN_OUTLINE void draw_large_side(const TriangleIndices& t, const SortedVertices<Method>& vertices,
                                       Facing facing) {
    const Face face = shaded_face(t, facing);
    TriangleCommand<Method> command;
    if (!prepare_sorted<Method, Depth::kTests>(stage_.lighting(), vertices, face, scissor_.viewport_rows(),
                                               command)) {
      return;
    }
    const RasterOrigin& origin = scissor_.origin();
    const Rect& rect = scissor_.rect();
    if (!command.has_rows_in(rect.top, rect.bottom, origin.y)) return;
    ++result_.triangles;
    const Target target = target_;  // a copy, because members would be loaded again for every row
    if constexpr (!kWholeRows && kDrawsSmall) {  // draw_crossing_rows() would be a function of its own
      result_.status = Method::walk(
          command.shade, RowDrawerOf<Method, ScissorColumns::kCrossing, Target>{command, origin, target});
    } else if constexpr (!kWholeRows) {
      result_.status = draw_crossing_rows(command, origin, target);
    } else if (columns_ == ScissorColumns::kCrossing) [[unlikely]] {
      result_.status = draw_crossing_rows_outlined(command, origin, target);
    } else {
      result_.status = Method::walk(
          command.shade, RowDrawerOf<Method, ScissorColumns::kInside, Target>{command, origin, target});
    }
  }

  const VertexStage<Method> stage_;
  const Scissor scissor_;
  [[no_unique_address]] Colours encoded_;
  const Target target_;
  DrawResult result_{};
  const DrawOptions options_;
  ScissorColumns columns_ = ScissorColumns::kCrossing;  ///< of the current triangle
};

}  // namespace arcspan::detail
