// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/draw_options.hpp>
#include <arcspan/draw/vertex_source.hpp>
#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/mesh/drawable_mesh.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/pixel/fill.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/clip_transform.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

/// What a picture shows of a triangle, by the decisions of draw_mesh() on its vertices, wherever on the
/// screen it lies.
enum class TriangleSide : std::uint8_t {
  kHidden,  ///< nothing: its back is culled, it has no area, or it lies outside one plane of the clip volume
  kFront,
  kBack,  ///< its back, because DrawOptions::two_sided is on
  kCut,   ///< it crosses a clip plane
};

namespace detail {

/// A vertex source that notes the sides of the triangles that are not culled.
template <class Source>
concept NotesSides = requires(Source& source, std::size_t i) {
  source.note_side(i, TriangleSide::kFront);
};

/// The side of a triangle that is not culled.
template <class Method>
[[nodiscard]] ARCSPAN_INLINE constexpr TriangleSide side_of(const CachedVertex<Method>& a,
                                                            const CachedVertex<Method>& b,
                                                            const CachedVertex<Method>& c, bool two_sided) {
  if (!are_inside(a, b, c)) return TriangleSide::kCut;
  if (two_sided && doubled_area(a.raster.position, b.raster.position, c.raster.position) >= 0)
    return TriangleSide::kBack;
  return TriangleSide::kFront;
}

/// The side of a triangle with these rows, which may be culled, as all backs are.
[[nodiscard]] ARCSPAN_INLINE constexpr TriangleSide side_of(const TriangleRows& rows) {
  if (rows == TriangleRows::culled()) return TriangleSide::kHidden;
  return rows == TriangleRows::any() ? TriangleSide::kCut : TriangleSide::kFront;
}

/// Returns kBufferTooSmall unless `sides` holds all triangles of a mesh, else makes them kHidden.
[[nodiscard]] inline Status hide_all(const MeshView& mesh, std::span<TriangleSide> sides) {
  if (sides.size() < mesh.triangle_count()) return Status::kBufferTooSmall;
  static_assert(sizeof(TriangleSide) == 1);
  fill(static_cast<std::uint8_t*>(static_cast<void*>(sides.data())), mesh.triangle_count(),
       static_cast<std::uint8_t>(TriangleSide::kHidden));
  return Status::kOk;
}

}  // namespace detail

/// A vertex source that also writes down the sides of the triangles while they are drawn, one store per
/// triangle that is not culled. It takes its vertices from another source, which must outlive it, as must the
/// memory: a TriangleSide for each triangle of the mesh, or more.
///
///     NotedSides noted(cache, sides);
///     draw_mesh<Method>(mesh, transform, light, frame, depth, noted);
///
/// Every triangle is looked at, also those outside of the sink. For a picture in bands find_sides(), once per
/// frame, is cheaper. A draw call returns kBufferTooSmall, and draws nothing, if the memory is too small.
template <class Source>
class NotedSides {
 public:
  constexpr NotedSides(Source& source, std::span<TriangleSide> sides) : source_(source), sides_(sides) {}

  template <class Method, class Mesh>
  [[nodiscard]] Status begin(const VertexStage<Method, Mesh>& stage, bool two_sided) {
    const Status status = detail::hide_all(stage.mesh(), sides_);
    return ok(status) ? source_.begin(stage, two_sided) : status;
  }
  template <class Method, class Mesh>
  [[nodiscard]] ARCSPAN_INLINE decltype(auto) vertex(const VertexStage<Method, Mesh>& stage, std::size_t i) {
    return source_.vertex(stage, i);
  }
  [[nodiscard]] ARCSPAN_INLINE auto& transformed(std::size_t i) requires requires(Source& source) {
    source.transformed(i);
  }
  { return source_.transformed(i); }
  [[nodiscard]] static constexpr const TriangleRows* rows() { return nullptr; }
  ARCSPAN_INLINE constexpr void note_side(std::size_t i, TriangleSide side) { sides_[i] = side; }

 private:
  Source& source_;
  std::span<TriangleSide> sides_;
};

/// Finds the sides of all triangles of a mesh, as NotedSides notes them, without drawing. A VertexCache keeps
/// the transformed vertices for the draw calls of all bands; if it has rows, the sides are those of the rows.
///
/// Returns kOk, kBufferTooSmall if `sides` holds fewer than mesh.triangle_count(), or what source.begin()
/// returns; `sides` is then undefined.
template <class Method, DrawableMesh Mesh, class Source>
requires VertexSource<std::remove_cvref_t<Source>, Method, Mesh>
[[nodiscard]] Status find_sides(const Mesh& mesh, const ClipTransform& transform,
                                const typename Method::Lighting& lighting, Source&& source,
                                std::span<TriangleSide> sides, const DrawOptions& options = {}) {
  VertexStage<Method, Mesh> stage(mesh, transform, lighting);
  if (!options.two_sided) stage.find_back_faces();
  const MeshView& triangles = stage.mesh();
  Status status = detail::hide_all(triangles, sides);
  if (ok(status)) status = source.begin(stage, options.two_sided);
  if (!ok(status)) return status;
  const std::size_t count = triangles.triangle_count();
  if (const TriangleRows* const rows = source.rows(); rows != nullptr && !options.two_sided) {
    for (std::size_t i = 0; i < count; ++i) sides[i] = detail::side_of(rows[i]);
    return Status::kOk;
  }
  const BackFaces& back_faces = stage.back_faces();
  const auto next = [&](std::size_t i) { return back_faces.known() ? back_faces.next_front(i, count) : i; };
  for (std::size_t i = next(0); i < count; i = next(i + 1)) {
    const TriangleIndices t = triangles.triangle(i);
    auto&& a = source.vertex(stage, t.a);
    auto&& b = source.vertex(stage, t.b);
    auto&& c = source.vertex(stage, t.c);
    if (!detail::is_culled<Method>(a, b, c, options.two_sided))
      sides[i] = detail::side_of<Method>(a, b, c, options.two_sided);
  }
  return Status::kOk;
}

}  // namespace arcspan
