// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/draw_options.hpp>
#include <arcspan/draw/triangle_drawer.hpp>
#include <arcspan/draw/vertex_source.hpp>
#include <arcspan/mesh/drawable_mesh.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/clip_transform.hpp>

#include <span>
#include <type_traits>

namespace arcspan {

/// Draws a mesh: transforms, clips, culls and shades its triangles by `Method` and writes them to `sink`
/// within the common bounds of the viewport and the sink.
///
/// - `mesh`: a MeshView, or another DrawableMesh whose vertices are posed.
/// - `lighting`: the illumination in the object's space.
/// - `depth`: a DepthBuffer that covers these bounds, a DepthMode of one for another test, or NoDepth{}.
/// - `source`: where the vertices come from: a VertexCache, NoCache{} or another VertexSource.
/// - `Features`: the parts of draw_mesh() that the program contains.
///
/// A pixel depends on the scene and on its position only, bit for bit, whatever part of the picture the sink
/// takes: a picture in bands is a call for each.
///
/// Returns as status kOk, the first other one of the sink, at which drawing stops, or, with nothing drawn:
///
///   kDepthMismatch    `depth` does not cover the common bounds of the viewport and the sink
///   kCacheTooSmall    the memory of a VertexCache is too small for the mesh
///   kCacheMismatch    a VertexCache holds another object
///   others            the status() of a Framebuffer or DepthBuffer that is not kOk
template <ShadingMethod Method, DrawFeatures Features = DrawFeatures{}, PixelSink Sink, DepthTarget Depth,
          class Source, DrawableMesh Mesh>
requires VertexSource<std::remove_cvref_t<Source>, Method, Mesh>
[[nodiscard]] ARCSPAN_OUTLINE DrawResult draw_mesh(const Mesh& mesh, const ClipTransform& transform,
                                                   const typename Method::Lighting& lighting, Sink& sink,
                                                   const Depth& depth, Source&& source,
                                                   const DrawOptions& options = {}) {
  detail::TriangleDrawer<Method, Features, Sink, Depth, Mesh> drawer({mesh, transform, lighting}, sink, depth,
                                                                     options);
  drawer.draw(source);
  return drawer.result();
}

/// Draws a mesh as above without a cache: every triangle transforms its own three vertices.
template <ShadingMethod Method, DrawFeatures Features = DrawFeatures{}, PixelSink Sink, DepthTarget Depth,
          DrawableMesh Mesh>
[[nodiscard]] DrawResult draw_mesh(const Mesh& mesh, const ClipTransform& transform,
                                   const typename Method::Lighting& lighting, Sink& sink,
                                   const Depth& depth) {
  return draw_mesh<Method, Features>(mesh, transform, lighting, sink, depth, NoCache{});
}

/// Draws a mesh as above with a VertexCache for this call, which is made of the memory `cache`: for at least
/// mesh.view().vertex_count() vertices, or for none, in which case there is no cache.
template <ShadingMethod Method, DrawFeatures Features = DrawFeatures{}, PixelSink Sink, DepthTarget Depth,
          DrawableMesh Mesh>
[[nodiscard]] DrawResult draw_mesh(const Mesh& mesh, const ClipTransform& transform,
                                   const typename Method::Lighting& lighting, Sink& sink, const Depth& depth,
                                   std::span<CachedVertex<Method>> cache, const DrawOptions& options = {}) {
  if (cache.empty()) {
    return draw_mesh<Method, Features>(mesh, transform, lighting, sink, depth, NoCache{}, options);
  }
  return draw_mesh<Method, Features>(mesh, transform, lighting, sink, depth, VertexCache<Method>(cache),
                                     options);
}

}  // namespace arcspan
