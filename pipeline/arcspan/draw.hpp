// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/band_cache.hpp>
#include <arcspan/draw/band_vertices.hpp>
#include <arcspan/draw/draw_options.hpp>
#include <arcspan/draw/kept_vertices.hpp>
#include <arcspan/draw/triangle_drawer.hpp>
#include <arcspan/draw/vertex_source.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/clip_transform.hpp>

#include <span>

namespace arcspan {

/// Draws a mesh: transforms, clips, culls and shades its triangles by `Method` and writes them to `sink`
/// within the common bounds of the viewport and the sink.
///
/// - `lighting`: the illumination in the object's space.
/// - `depth`: a DepthBuffer that covers these bounds, a DepthMode of one for another test, or NoDepth{}.
/// - `cache`: memory for at least mesh.vertex_count() transformed vertices, each of which is then transformed
///   once; or none, and every triangle transforms its own three vertices.
/// - `Features`: the parts of draw_mesh() that the program contains.
///
/// To draw a picture in bands, move the sink and the depth buffer to a band and call this once per band: the
/// rows are bit for bit those of the picture drawn at once. Columns that are cut off on the left may change
/// the last bits of small triangles and of some methods, whose rows start at the first drawn column.
///
/// Returns as status kOk, or the first other status of the sink, at which drawing stops. Draws nothing and
/// returns:
///
///   kUnsupported      two-sided drawing is asked for but left out of `Features`
///   kDepthMismatch    `depth` does not cover the common bounds of the viewport and the sink
///   kCacheTooSmall    `cache` is neither empty nor large enough, unless `Features` leaves caches out
///   others            the status() of a Framebuffer or DepthBuffer that is not kOk
template <ShadingMethod Method, DrawFeatures Features = DrawFeatures{}, PixelSink Sink, DepthTarget Depth>
[[nodiscard]] ARCSPAN_OUTLINE DrawResult draw_mesh(const MeshView& mesh, const ClipTransform& transform,
                                                   const typename Method::Lighting& lighting, Sink& sink,
                                                   const Depth& depth,
                                                   std::span<CachedVertex<Method>> cache = {},
                                                   const DrawOptions& options = {}) {
  if constexpr (Features.caches) {
    if (!cache.empty() && cache.size() < mesh.vertex_count()) return {Status::kCacheTooSmall};
  }
  detail::TriangleDrawer<Method, Features, Sink, Depth> drawer(mesh, transform, lighting, sink, depth,
                                                               options);
  if (!drawer.ready()) return drawer.result();
  const detail::VisibleTriangles visible = drawer.visible_triangles();
  if (visible.excludes_all()) return drawer.result();
  if constexpr (!Features.caches) {
    drawer.draw_triangles(detail::UncachedVertices<Method>(drawer.stage(), visible));
  } else if (cache.empty()) {
    drawer.draw_triangles_outlined(detail::UncachedVertices<Method>(drawer.stage(), visible));
  } else if (Features.planes && visible.in_band() && detail::BandVertices<Method>::suits(mesh)) {
    drawer.draw_triangles_outlined(detail::BandVertices<Method>(drawer.stage(), cache.data(), visible));
  } else if (visible.known()) {
    detail::forget_vertices(cache.data(), mesh.vertex_count());
    drawer.draw_triangles_outlined(detail::FrontVertices<Method>(drawer.stage(), cache.data(), visible));
  } else {
    drawer.draw_triangles_outlined(detail::CachedVertices<Method>(drawer.stage(), cache.data()));
  }
  return drawer.result();
}

/// Draws a mesh as above, with vertices that `cache` keeps from band to band.
///
/// Draws nothing and returns also kCacheTooSmall if the memory of `cache` is too small for the mesh, and
/// kCacheMismatch if `cache` holds another object (BandCache).
template <ShadingMethod Method, DrawFeatures Features = DrawFeatures{}, PixelSink Sink, DepthTarget Depth>
requires(Features.caches) [[nodiscard]] ARCSPAN_OUTLINE DrawResult
    draw_mesh(const MeshView& mesh, const ClipTransform& transform, const typename Method::Lighting& lighting,
              Sink& sink, const Depth& depth, BandCache<Method>& cache, const DrawOptions& options = {}) {
  detail::TriangleDrawer<Method, Features, Sink, Depth> drawer(mesh, transform, lighting, sink, depth,
                                                               options);
  if (!drawer.ready()) return drawer.result();
  const Status held = cache.begin(drawer.stage(), drawer.two_sided());
  if (!ok(held)) return {held};
  const detail::VisibleTriangles visible = drawer.visible_triangles();
  if (visible.excludes_all()) return drawer.result();
  drawer.draw_triangles_outlined(detail::KeptVertices<Method>(drawer.stage(), cache.vertices(), cache.rows(),
                                                              visible, drawer.scissor().rect()));
  return drawer.result();
}

}  // namespace arcspan
