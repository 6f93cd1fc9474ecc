// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/clip/clip_polygon.hpp>
#include <arcspan/mesh/face_normal.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/prepare/split.hpp>
#include <arcspan/span/draw_command.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/back_faces.hpp>
#include <arcspan/vertex/clip_transform.hpp>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <type_traits>

namespace arcspan {

/// A transformed vertex, as the vertex cache keeps it; shaded when the first triangle shows it.
template <class Method>
struct CachedVertex {
  RasterVertex<Method> raster;
  std::uint8_t outcode;
  bool shaded;
};

/// What may be asked of draw_mesh besides a picture.
struct DrawOptions {
  bool two_sided = false;  ///< draw back faces too, lit with the opposite normals
};

/// What became of a draw_mesh.
struct DrawResult {
  Status status = Status::kOk;
  std::uint32_t triangles = 0;  ///< of the mesh, at least partly inside the clip rectangle's rows and columns
  std::uint32_t left_out = 0;   ///< cut by the view, and not drawn because DrawFeatures::clips is off
};

/// What draw_mesh can do beside drawing the fronts of triangles that are wholly in view. All of it, unless a
/// firmware leaves code out (bytes on a Cortex-M3: docs/memory.md).
struct DrawFeatures {
  bool clips = true;      ///< triangles across the near plane or the guard band; else they are left_out
  bool splits = true;     ///< normals too far apart for the method; else such triangles are drawn as they are
  bool two_sided = true;  ///< DrawOptions::two_sided; else asking for it is kUnsupported
  bool caches = true;     ///< a vertex cache; else one that is given is not used
  bool planes = true;     ///< culling by the planes of a mesh that has them; else they are not used
  /// A loop of their own for rows that no side of the picture cuts, which is faster. `-Os` and cores with few
  /// registers do without.
  bool whole_rows = true;
};

namespace detail {

[[nodiscard]] constexpr Rect intersection(const Rect& a, const Rect& b) {
  return {a.left > b.left ? a.left : b.left, a.top > b.top ? a.top : b.top,
          a.right < b.right ? a.right : b.right, a.bottom < b.bottom ? a.bottom : b.bottom};
}

/// One call of draw_mesh: the way of every triangle through the stages.
template <ShadingMethod Method, DrawFeatures Features, PixelSink Sink, DepthTarget Depth>
class MeshDrawer {
 public:
  using Raster = RasterVertex<Method>;
  using Colours =
      typename EncodedColoursOf<Method, typename Sink::Format, encoded_colours_size<Sink>()>::Type;
  using Target = RowTarget<typename Method::Lighting, Sink, Depth, Colours>;

  MeshDrawer(const MeshView& mesh, const ClipTransform& transform, const typename Method::Lighting& lighting,
             Sink& sink, const Depth& depth, std::span<CachedVertex<Method>> cache,
             const DrawOptions& options)
      : mesh_(mesh),
        transform_(transform),
        lighting_(lighting),
        sink_(sink),
        encoded_colours_(lighting),
        depth_(depth),
        options_(options) {
    const Viewport& viewport = transform.viewport();
    origin_ = {viewport.width >> 1, viewport.height >> 1};
    clip_ =
        intersection({0, 0, viewport.width, viewport.height}, intersection(sink.bounds(), depth.bounds()));
    rows_ = {-origin_.y, viewport.height - origin_.y};
    left_ = (clip_.left - origin_.x) * 16;
    right_ = (clip_.right - origin_.x) * 16;
    banded_ = clip_.height() < viewport.height;
    if (Features.caches && cache.size() >= mesh.vertex_count()) cache_ = cache.data();
    if (!Features.two_sided && options.two_sided) result_.status = Status::kUnsupported;
  }

  [[nodiscard]] ARCSPAN_INLINE DrawResult draw() {
    if (clip_.empty() || !ok(result_.status)) return result_;
    if constexpr (!Features.caches) {
      draw_uncached_here();
    } else if (cache_ != nullptr) {
      draw_cached();
    } else {
      draw_uncached();
    }
    return result_;
  }

 private:
  static constexpr bool kWholeRows = Features.whole_rows && kWholeRowsPay;

  [[nodiscard]] bool two_sided() const { return Features.two_sided && options_.two_sided; }

  void transform_vertex(std::size_t i, CachedVertex<Method>& vertex) const {
    const ClipPosition position = transform_(mesh_.position(i));
    vertex.outcode = outcode(position, transform_.near_w());
    if (vertex.outcode == kInside) vertex.raster.position = project(position, transform_);
    vertex.shaded = false;
  }

  void shade_vertex(std::size_t i, CachedVertex<Method>& vertex) const {
    if (vertex.shaded) return;
    shade_afresh(i, vertex.raster.shade, false);
    vertex.shaded = true;
  }

  /// With the normal as it is, or turned for the `back`.
  ARCSPAN_OUTLINE void shade_afresh(std::size_t i, typename Method::Vertex& shade, bool back) const {
    const Direction normal = unpack_normal(mesh_.normal(i));
    shade = Method::shade_vertex(lighting_, back ? -normal : normal);
  }

  [[nodiscard]] BackFaces find_backs() const {
    return two_sided() ? BackFaces{} : BackFaces(mesh_, transform_);
  }

  /// A cached vertex that no front has asked for yet.
  static constexpr std::uint8_t kUntouched = 0xFF;

  [[nodiscard]] CachedVertex<Method>& touched(std::size_t i, CachedVertex<Method>* cache) const {
    CachedVertex<Method>& vertex = cache[i];
    if (vertex.outcode == kUntouched) touch(i, vertex);
    return vertex;
  }
  ARCSPAN_OUTLINE void touch(std::size_t i, CachedVertex<Method>& vertex) const {
    vertex.raster.position = project(transform_(mesh_.position(i)), transform_);
    vertex.outcode = kInside;
    vertex.shaded = false;
  }

  /// draw_cached() of a mesh whose `backs` are known, all of it in view: vertices that only backs have are
  /// not transformed.
  ARCSPAN_OUTLINE void draw_fronts(const BackFaces& backs) {
    const MeshView mesh = mesh_;
    CachedVertex<Method>* const cache = cache_;
    for (std::size_t i = 0; i < mesh.vertex_count(); ++i) cache[i].outcode = kUntouched;
    const std::size_t count = mesh.triangle_count();
    for (std::size_t i = backs.next_front(0, count); i < count; i = backs.next_front(i + 1, count)) {
      const TriangleIndices t = mesh.triangle(i);
      CachedVertex<Method>& a = touched(t.a, cache);
      CachedVertex<Method>& b = touched(t.b, cache);
      CachedVertex<Method>& c = touched(t.c, cache);
      if (doubled_area(a.raster.position, b.raster.position, c.raster.position) >= 0) continue;
      draw_vertices(t, a, b, c);
      if (!ok(result_.status)) return;
    }
  }

  void draw_cached() {
    if constexpr (Features.planes) {
      const BackFaces backs = find_backs();
      if (backs.known()) return draw_fronts(backs);
    }
    const MeshView mesh = mesh_;  // and the cache: nothing that is drawn can change them here
    CachedVertex<Method>* const cache = cache_;
    for (std::size_t i = 0; i < mesh.vertex_count(); ++i) transform_vertex(i, cache[i]);
    const std::size_t count = mesh.triangle_count();
    for (std::size_t i = 0; i < count; ++i) {
      const TriangleIndices t = mesh.triangle(i);
      CachedVertex<Method>& a = cache[t.a];
      CachedVertex<Method>& b = cache[t.b];
      CachedVertex<Method>& c = cache[t.c];
      if (culled(a, b, c)) continue;
      draw_vertices(t, a, b, c);
      if (!ok(result_.status)) return;
    }
  }

  ARCSPAN_OUTLINE void draw_uncached() { draw_uncached_here(); }

  ARCSPAN_INLINE void draw_uncached_here() {
    const std::size_t count = mesh_.triangle_count();
    BackFaces backs;
    if constexpr (Features.planes) backs = find_backs();
    for (std::size_t i = 0; i < count && ok(result_.status); ++i) {
      if (Features.planes && backs.known()) {
        i = backs.next_front(i, count);
        if (i == count) return;
      }
      const TriangleIndices t = mesh_.triangle(i);
      CachedVertex<Method> a;
      CachedVertex<Method> b;
      CachedVertex<Method> c;
      transform_vertex(t.a, a);
      transform_vertex(t.b, b);
      transform_vertex(t.c, c);
      if (culled(a, b, c)) continue;
      if constexpr (Features.caches) {
        draw_vertices(t, a, b, c);
      } else {
        draw_vertices_here(t, a, b, c);
      }
    }
  }

  /// Wholly beyond one side of the view, or seen from the back: half of the triangles and more, which set up
  /// nothing.
  [[nodiscard]] bool culled(const CachedVertex<Method>& a, const CachedVertex<Method>& b,
                            const CachedVertex<Method>& c) const {
    if ((a.outcode | b.outcode | c.outcode) != 0) return (a.outcode & b.outcode & c.outcode) != 0;
    const std::int32_t area = doubled_area(a.raster.position, b.raster.position, c.raster.position);
    return area >= 0 && (area == 0 || !two_sided());
  }

  void shade_vertices(const TriangleIndices& t, CachedVertex<Method>& a, CachedVertex<Method>& b,
                      CachedVertex<Method>& c) const {
    if constexpr (std::is_empty_v<typename Method::Vertex>) return;  // no normal need be unpacked
    shade_vertex(t.a, a);
    shade_vertex(t.b, b);
    shade_vertex(t.c, c);
  }

  /// A triangle that is not culled().
  ARCSPAN_OUTLINE void draw_vertices(TriangleIndices t, CachedVertex<Method>& a, CachedVertex<Method>& b,
                                     CachedVertex<Method>& c) {
    draw_vertices_here(t, a, b, c);
  }

  ARCSPAN_INLINE void draw_vertices_here(const TriangleIndices& t, CachedVertex<Method>& a,
                                         CachedVertex<Method>& b, CachedVertex<Method>& c) {
    drawn_ = false;
    if ((a.outcode | b.outcode | c.outcode) != 0) {
      draw_cut(t);
    } else {
      draw_projected(t, a, b, c);
    }
    if (drawn_) ++result_.triangles;
  }

  /// A triangle across the sides of the view.
  void draw_cut(const TriangleIndices& t) {
    if constexpr (Features.clips) {
      draw_clipped(t, false);
      // A cut vertex has no normal in the mesh to turn, so the back is clipped with its own shading.
      if (two_sided()) draw_clipped(t, true);
    } else {
      ++result_.left_out;
    }
  }

  /// Draws what is left of a clipped triangle if it shows its front, or its `back`. Rare, so that its
  /// vertices are made afresh.
  ARCSPAN_COLD_OUTLINE void draw_clipped(const TriangleIndices& t, bool back) {
    ClipPolygon<Method> polygon;
    ClipPolygon<Method> spare;
    polygon.count = 0;
    for (const std::uint16_t i : {t.a, t.b, t.c}) {
      ClipVertex<Method>& vertex = polygon.vertices[polygon.count++];
      vertex.position = transform_(mesh_.position(i));
      shade_afresh(i, vertex.shade, back);
    }
    const ClipPolygon<Method>& inside = clip_polygon(polygon, spare, transform_.near_w());
    for (std::size_t i = 2; i < inside.count; ++i) {
      const Raster p = projected(inside.vertices[0]);
      const Raster q = projected(inside.vertices[i - 1]);
      const Raster r = projected(inside.vertices[i]);
      const std::int32_t area = doubled_area(p.position, q.position, r.position);
      if (!ok(result_.status)) return;
      if ((back ? area <= 0 : area >= 0) || out_of_clip(p.position, q.position, r.position)) continue;
      draw_side_rarely(t, p, q, r, back);
    }
  }

  [[nodiscard]] Raster projected(const ClipVertex<Method>& vertex) const {
    return {project(vertex.position, transform_), vertex.shade};
  }

  void draw_projected(const TriangleIndices& t, CachedVertex<Method>& a, CachedVertex<Method>& b,
                      CachedVertex<Method>& c) {
    const RasterPosition& p = a.raster.position;
    const RasterPosition& q = b.raster.position;
    const RasterPosition& r = c.raster.position;
    if (out_of_clip(p, q, r)) return;
    if (!two_sided() || doubled_area(p, q, r) < 0) {
      shade_vertices(t, a, b, c);
      draw_side(t, a.raster, b.raster, c.raster, false);
    } else {
      draw_back(t, p, q, r);
    }
  }

  /// Rare, so it is shaded afresh instead of being kept for every vertex.
  ARCSPAN_COLD_OUTLINE void draw_back(const TriangleIndices& t, const RasterPosition& p,
                                      const RasterPosition& q, const RasterPosition& r) {
    Raster a{p, {}};
    Raster b{q, {}};
    Raster c{r, {}};
    shade_afresh(t.a, a.shade, true);
    shade_afresh(t.b, b.shade, true);
    shade_afresh(t.c, c.shade, true);
    draw_side_rarely(t, a, b, c, true);
  }

  ARCSPAN_COLD_OUTLINE void draw_side_rarely(const TriangleIndices& t, const Raster& a, const Raster& b,
                                             const Raster& c, bool back) {
    draw_side(t, a, b, c, back);
  }

  /// Whether a triangle has nothing within the clip rectangle, before it is shaded; else its `sides_` are
  /// noted.
  [[nodiscard]] bool out_of_clip(const RasterPosition& a, const RasterPosition& b, const RasterPosition& c) {
    const bool cut = !kWholeRows || leaves_columns(a, b, c);
    if (cut && outside_columns(a, b, c)) return true;
    sides_ = cut ? Sides::kCut : Sides::kWhole;
    return is_for_other_band(a, b, c);
  }

  /// As in_other_band(), of a picture in bands; counts it for this one.
  [[nodiscard]] bool is_for_other_band(const RasterPosition& a, const RasterPosition& b,
                                       const RasterPosition& c) {
    if (!banded_ || !in_other_band(a, b, c)) return false;
    drawn_ = true;
    return true;
  }

  void draw_side(const TriangleIndices& t, const Raster& a, const Raster& b, const Raster& c, bool back) {
    typename Method::Face face{};
    if constexpr (Method::kNeedsFaceNormal) {
      const Direction normal = face_normal(mesh_.position(t.a), mesh_.position(t.b), mesh_.position(t.c));
      face = Method::shade_face(lighting_, back ? -normal : normal);
    }
    if (draw_part(a, b, c, face, Features.splits)) return;
    if constexpr (Features.splits) draw_split(a, b, c, face);
  }

  ARCSPAN_COLD_OUTLINE void draw_split(const Raster& a, const Raster& b, const Raster& c,
                                       const typename Method::Face& face) {
    auto emit = [this, &face](const Raster& p, const Raster& q, const Raster& r) {
      if (!ok(result_.status) || is_for_other_band(p.position, q.position, r.position)) return;
      (void)draw_part(p, q, r, face, false);
    };
    split_triangle(a, b, c, emit);
  }

  /// False if the triangle `may_split` and is too wide. Never inlined: split_triangle() would hold its
  /// command once for every level of splitting.
  ARCSPAN_OUTLINE bool draw_part(const Raster& a, const Raster& b, const Raster& c,
                                 const typename Method::Face& face, bool may_split) {
    TriangleCommand<Method> command;
    const Preparation prepared =
        prepare_inside<Method, Depth::kTests>(lighting_, a, b, c, face, rows_, may_split, command);
    if (prepared != Preparation::kReady) return prepared == Preparation::kNothing;
    drawn_ = true;
    result_.status = draw_command_with<kWholeRows>(
        command, origin_, Target{clip_, lighting_, sink_, depth_, encoded_colours_}, sides_);
    return true;
  }

  /// A vertex lies beyond the clip rectangle's columns.
  [[nodiscard]] bool leaves_columns(const RasterPosition& a, const RasterPosition& b,
                                    const RasterPosition& c) const {
    return ((a.x - left_) | (b.x - left_) | (c.x - left_) | (right_ - a.x) | (right_ - b.x) |
            (right_ - c.x)) < 0;
  }

  /// No pixel centre of the clip rectangle's columns lies between the leftmost and the rightmost vertex.
  [[nodiscard]] bool outside_columns(const RasterPosition& a, const RasterPosition& b,
                                     const RasterPosition& c) const {
    return (a.x < left_ && b.x < left_ && c.x < left_) || (a.x > right_ && b.x > right_ && c.x > right_);
  }

  /// The triangle has rows in the viewport, but none among those of the clip rectangle: prepare_inside()
  /// would make a command of it, of which draw_command() would draw nothing.
  [[nodiscard]] bool in_other_band(const RasterPosition& a, const RasterPosition& b,
                                   const RasterPosition& c) const {
    const std::int32_t upper = a.y < b.y ? a.y : b.y;
    const std::int32_t lower = a.y > b.y ? a.y : b.y;
    const std::int32_t first = first_row_at(upper < c.y ? upper : c.y);
    const std::int32_t end = first_row_at(lower > c.y ? lower : c.y);
    if (first >= end || end <= rows_.first || first >= rows_.end) return false;
    if (end + origin_.y > clip_.top && first + origin_.y < clip_.bottom) return false;
    return doubled_area(a, b, c) != 0;
  }

  const MeshView& mesh_;
  const ClipTransform& transform_;
  const typename Method::Lighting& lighting_;
  Sink& sink_;
  [[no_unique_address]] Colours encoded_colours_;
  const Depth& depth_;
  CachedVertex<Method>* cache_ = nullptr;
  DrawOptions options_;
  RasterOrigin origin_{};
  RowRange rows_{};
  Rect clip_{};
  std::int32_t left_ = 0;  ///< columns of the clip rectangle, in 16ths of a pixel from the raster origin
  std::int32_t right_ = 0;
  DrawResult result_{};
  bool banded_ = false;        ///< rows of the viewport lie outside the clip rectangle
  Sides sides_ = Sides::kCut;  ///< of the present triangle
  bool drawn_ = false;         ///< something of the present triangle reached the rows
};

}  // namespace detail

/// Draws a mesh: transform, clip, cull, prepare, span by span into `sink`, within the common bounds of the
/// viewport, the sink and the depth target. To draw a picture in bands, call this once a
/// band: the rows come out bit for bit the same. Columns cut off on the left may change the last bits of
/// what is drawn, since a row begins at its first drawn column.
///
/// `lighting` is the illumination in the object's space. `cache` may hold mesh.vertex_count() vertices, each
/// of which is then transformed once; if it is smaller it is not used, and every triangle transforms its own
/// three. `Features` may leave out what a scene does not need. The result's status is the sink's first that
/// is not kOk. Not inlined: what it keeps on the stack (a EncodedColourTable, perhaps) is there while it
/// runs, and once.
template <ShadingMethod Method, DrawFeatures Features = DrawFeatures{}, PixelSink Sink, DepthTarget Depth>
[[nodiscard]] ARCSPAN_OUTLINE DrawResult draw_mesh(const MeshView& mesh, const ClipTransform& transform,
                                                   const typename Method::Lighting& lighting, Sink& sink,
                                                   const Depth& depth,
                                                   std::span<CachedVertex<Method>> cache = {},
                                                   const DrawOptions& options = {}) {
  return detail::MeshDrawer<Method, Features, Sink, Depth>(mesh, transform, lighting, sink, depth, cache,
                                                           options)
      .draw();
}

}  // namespace arcspan
