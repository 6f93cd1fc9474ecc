// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/check_call.hpp>
#include <arcspan/draw/draw_options.hpp>
#include <arcspan/draw/scissor.hpp>
#include <arcspan/draw/triangle_rows.hpp>
#include <arcspan/draw/triangle_sides.hpp>
#include <arcspan/draw/vertex_source.hpp>
#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/mesh/face_normal.hpp>
#include <arcspan/span/draw_small.hpp>
#include <arcspan/span/row_drawer.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/back_faces.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace arcspan::detail {

// Which triangles of a mesh a draw call looks at: next(i, count) is the first from i on that may be visible,
// or `count`; kAllInside: all vertices are known to be inside the clip volume, and backs not to be drawn.

/// All triangles.
struct AllTriangles {
  static constexpr bool kAllInside = false;
  [[nodiscard]] constexpr std::size_t next(std::size_t i, std::size_t) const { return i; }
};

/// The triangles that may be front faces, where the planes of the faces tell (BackFaces::known()).
struct FrontTriangles {
  static constexpr bool kAllInside = true;
  const BackFaces& back_faces;
  [[nodiscard]] ARCSPAN_INLINE std::size_t next(std::size_t i, std::size_t count) const {
    return back_faces.next_front(i, count);
  }
};

/// Draws the triangles of one draw_mesh() call: culls, clips, shades, prepares and hands the commands
/// to the span stage.
template <ShadingMethod Method, DrawFeatures Features, PixelSink Sink, DepthTarget Depth,
          DrawableMesh Mesh = MeshView>
class TriangleDrawer {
 public:
  using Vertex = CachedVertex<Method>;

  TriangleDrawer(const VertexStage<Method, Mesh>& stage, Sink& sink, const Depth& depth,
                 const DrawOptions& options)
      : stage_(stage),
        scissor_(stage.transform().viewport(), sink.bounds()),
        target_{scissor_.rect(), stage_.lighting(), sink, depth},
        two_sided_(options.two_sided) {
    result_.status = check_target(scissor_, sink, depth);
    check_mesh_call(stage, depth);
    if constexpr (Features.planes) {
      if (!two_sided_) stage_.find_back_faces();
    }
  }

  [[nodiscard]] const DrawResult& result() const { return result_; }

  /// Draws the mesh with the vertices of a VertexSource until the sink fails.
  template <class Source>
  void draw(Source& source) {
    if (scissor_.rect().empty() || !ok(result_.status)) return;
    result_.status = source.begin(stage_, two_sided_);
    if (!ok(result_.status)) return;
    if (const TriangleRows* const rows = source.rows()) {
      draw_triangles(source, BandTriangles(rows, stage_, scissor_.rect()));
      return;
    }
    if constexpr (Features.planes) {
      if (stage_.back_faces().known()) {
        draw_triangles(source, FrontTriangles{stage_.back_faces()});
        return;
      }
    }
    draw_triangles(source, AllTriangles{});
  }

 private:
  using Raster = RasterVertex<Method>;
  using Face = typename Method::Face;
  using Target = RowTarget<typename Method::Lighting, Sink, Depth>;
  template <ScissorColumns kColumns>
  using DrawnBy = RowDrawer<kColumns, TriangleCommand<Method>, Target>;
  /// True if triangles within the columns of the scissor have a loop of their own.
  static constexpr bool kHasInsideRows =
      kHasCheapRows<TriangleCommand<Method>> && !kOptimisedForSize && kHasManyRegisters;
  /// True if AllTriangles finds every vertex transformed. Without Features.planes a MeshView may not: an
  /// earlier call with planes may have left vertices of back faces out of the cache.
  static constexpr bool kAllTransformed = Features.planes || !std::is_same_v<Mesh, MeshView>;
  static constexpr bool kDrawsSmall = Features.small_triangles && DrawsSmallTriangles<Method>;

  template <class Filter, class Source>
  [[nodiscard]] ARCSPAN_INLINE decltype(auto) vertex(Source& source, std::size_t i) const {
    if constexpr (kAllTransformed && std::is_same_v<Filter, AllTriangles> &&
                  requires { source.transformed(i); }) {
      return source.transformed(i);
    } else {
      return source.vertex(stage_, i);
    }
  }

  /// Draws the triangles of a filter.
  template <class Source, class Filter>
  ARCSPAN_OUTLINE void draw_triangles(Source& source, const Filter& filter) {
    const MeshView& mesh = stage_.mesh();
    const std::size_t count = mesh.triangle_count();
    for (std::size_t i = filter.next(0, count); i < count; i = filter.next(i + 1, count)) {
      const TriangleIndices t = mesh.triangle(i);
      auto&& a = vertex<Filter>(source, t.a);
      auto&& b = vertex<Filter>(source, t.b);
      auto&& c = vertex<Filter>(source, t.c);
      if (is_hidden<Filter::kAllInside>(a, b, c)) continue;
      if constexpr (NotesSides<Source>) {
        source.note_side(i, Filter::kAllInside ? TriangleSide::kFront : side_of<Method>(a, b, c, two_sided_));
      }
      if (!Filter::kAllInside && !DrawsEdges<Method> && !are_inside(a, b, c)) {
        draw_clipped(t);
      } else if constexpr (Filter::kAllInside && !kOptimisedForSize) {
        draw_triangle(t, a, b, c);
      } else {  // the other loops share one function
        draw_triangle_outlined(t, a, b, c);
      }
      if (!ok(result_.status)) return;
    }
  }

  /// True if the triangle is_culled(): the case of half of all triangles, before anything is set up.
  template <bool AllInside>
  [[nodiscard]] ARCSPAN_INLINE bool is_hidden(const Vertex& a, const Vertex& b, const Vertex& c) const {
    if constexpr (AllInside) {
      return doubled_area(a.raster.position, b.raster.position, c.raster.position) >= 0;
    } else {
      return is_culled(a, b, c, two_sided_);
    }
  }

  /// Draws a triangle that is not culled and not clipped, and counts it if a part of it is in view.
  ARCSPAN_INLINE void draw_triangle(const TriangleIndices& t, Vertex& a, Vertex& b, Vertex& c) {
    const RasterPosition& p = a.raster.position;
    const RasterPosition& q = b.raster.position;
    const RasterPosition& r = c.raster.position;
    if constexpr (DrawsEdges<Method>) {
      bool drawn = false;
      const typename Method::template EdgesDrawer<Target, Mesh> edges{stage_,     scissor_, target_,
                                                                      two_sided_, result_,  drawn};
      edges.template draw<Features.clips>(t, a, b, c);
      if (drawn) ++result_.triangles;
    } else if (is_within_scissor(p, q, r)) {
      if (two_sided_ && doubled_area(p, q, r) > 0) {
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
  ARCSPAN_OUTLINE ARCSPAN_COLD void draw_back(const TriangleIndices& t, const Raster& p, const Raster& q,
                                              const Raster& r) {
    Raster a = unshaded<Method>(p);
    Raster b = unshaded<Method>(q);
    Raster c = unshaded<Method>(r);
    stage_.shade(t.a, Facing::kBack, a.shade);
    stage_.shade(t.b, Facing::kBack, b.shade);
    stage_.shade(t.c, Facing::kBack, c.shade);
    draw_side(t, a, b, c, Facing::kBack);
  }

  /// Draws a triangle across a clip plane.
  void draw_clipped(const TriangleIndices& t) {
    if constexpr (Features.clips) {
      const std::uint32_t before = result_.triangles;
      draw_clipped(t, Facing::kFront);
      if (two_sided_) draw_clipped(t, Facing::kBack);
      if (result_.triangles > before) result_.triangles = before + 1;  // its parts are one triangle
    } else {
      ++result_.left_out;
    }
  }

  /// Clips the triangle and draws the rest if it shows the side `facing`. Clipped vertices have normals that
  /// are not in the mesh, so each side is clipped with its own shading.
  ARCSPAN_OUTLINE ARCSPAN_COLD void draw_clipped(const TriangleIndices& t, Facing facing) {
    Raster inside[ClipPolygon<Method>::kCapacity];
    const std::size_t count = clip_triangle(stage_, in_clip_order(t, facing), facing, inside);
    const bool front = facing == Facing::kFront;
    for (std::size_t i = 2; i < count && ok(result_.status); ++i) {
      const Raster& p = inside[0];
      const Raster& q = inside[i - 1];
      const Raster& r = inside[i];
      if (doubled_area(p.position, q.position, r.position) >= 0) continue;
      if (is_within_scissor(p.position, q.position, r.position))
        draw_side(t, p, front ? q : r, front ? r : q, facing);
    }
  }

  /// Tests the triangle against the scissor, before it is shaded.
  [[nodiscard]] ARCSPAN_INLINE bool is_within_scissor(const RasterPosition& a, const RasterPosition& b,
                                                      const RasterPosition& c) {
    const ScissorTest test = scissor_.test(a, b, c);
    target_.crosses = test != ScissorTest::kInside;
    return test != ScissorTest::kOutside;
  }

  /// Returns the method's data of the triangle's face; empty if it needs no face normal.
  [[nodiscard]] Face shaded_face([[maybe_unused]] const TriangleIndices& t,
                                 [[maybe_unused]] Facing facing) const {
    if constexpr (Method::kNeedsFaceNormal) {
      const Mesh& mesh = stage_.posed();
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
      if (is_small(vertices) && draw_small_side(t, vertices, facing)) return;
    }
    draw_large_side(t, vertices, facing);
  }

  /// Draws one side of a small triangle. Returns false if the method cannot.
  ARCSPAN_OUTLINE bool draw_small_side(const TriangleIndices& t, const SortedVertices<Method>& vertices,
                                       Facing facing) {
    const SmallResult result = draw_small_triangle<Method>(
        vertices, [&] { return shaded_face(t, facing); }, scissor_.viewport_rows(), scissor_.drawn_rows(),
        scissor_.origin(), target_, result_.status);
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
    // A copy, because members would be loaded again for every row. At -Os each run of pixels makes its own.
    std::conditional_t<kOptimisedForSize, const Target&, const Target> target = target_;
    if constexpr (!kHasInsideRows) {
      result_.status = Method::walk(command.shade, DrawnBy<ScissorColumns::kEither>{command, origin, target});
    } else if (target.crosses) [[unlikely]] {
      result_.status =
          Method::walk(command.shade, DrawnBy<ScissorColumns::kCrossing>{command, origin, target});
    } else {
      result_.status = Method::walk(command.shade, DrawnBy<ScissorColumns::kInside>{command, origin, target});
    }
  }

  VertexStage<Method, Mesh> stage_;
  const Scissor scissor_;
  Target target_;  ///< `crosses` is that of the triangle being drawn
  DrawResult result_{};
  const bool two_sided_;
};

}  // namespace arcspan::detail
