// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/draw_options.hpp>
#include <arcspan/draw/kept_vertices.hpp>
#include <arcspan/draw/triangle_rows.hpp>
#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/status.hpp>
#include <arcspan/vertex/clip_transform.hpp>

#include <cstddef>
#include <span>

namespace arcspan {

/// The cache in which draw_mesh() keeps one object from band to band of a picture: its transformed and shaded
/// vertices, and the rows of its triangles. Memory is the caller's:
///
/// - `vertices`: at least as many as the mesh has.
/// - `rows`: at least as many as the mesh has triangles, or none. A triangle of another band then costs 7
///   instructions on a Cortex-M3 instead of about 40.
///
/// Call clear() before the first band of every frame, and whenever the object's lighting has changed:
///
///     BandCache<Arc<Light>> cache(vertices, rows);
///     for (;;) {                                    // frames
///       cache.clear();
///       for (std::int32_t top = 0; top < height; top += band_rows) {
///         ...                                       // move and clear the band
///         draw_mesh<Arc<Light>>(mesh, transform, light, band, depth, cache);
///       }
///     }
///
/// A call for another mesh, another transform or another value of DrawOptions::two_sided than those of the
/// first call since clear() draws nothing and returns kCacheMismatch. Changes of the lighting are not
/// noticed: vertices that have been shaded keep the earlier one.
///
/// draw_mesh() writes to the cache as it needs further vertices, so every thread or core needs one of its
/// own, unless the cache was filled by fill(): from then on, until clear(), it is only read.
template <class Method>
class BandCache {
 public:
  constexpr explicit BandCache(std::span<CachedVertex<Method>> vertices, std::span<TriangleRows> rows = {})
      : vertices_(vertices), rows_(rows) {}

  /// Forgets the object.
  constexpr void clear() { holds_ = false; }

  /// Transforms and shades all vertices, and finds the rows of all triangles. Returns kCacheTooSmall, and
  /// holds no object, if the memory is too small for the mesh.
  Status fill(const MeshView& mesh, const ClipTransform& transform, const typename Method::Lighting& lighting,
              const DrawOptions& options = {}) {
    clear();
    const detail::VertexStage<Method> stage(mesh, transform, lighting);
    const Status status = begin(stage, options.two_sided);
    if (!ok(status)) return status;
    for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
      stage.transform_if_needed(i, vertices_[i]);
      if (vertices_[i].outcode == kInside) stage.shade(i, vertices_[i]);
    }
    return Status::kOk;
  }

  /// @cond for draw_mesh() and draw_scene(), not in the reference
  /// Starts to hold the object of `stage` if the cache holds none, and finds the rows of its triangles.
  /// Returns kOk if the cache holds this object. For draw_mesh().
  [[nodiscard]] Status begin(const detail::VertexStage<Method>& stage, bool two_sided) {
    if (holds_) {
      const bool same = mesh_ == stage.mesh() && transform_ == stage.transform() && two_sided_ == two_sided;
      return same ? Status::kOk : Status::kCacheMismatch;
    }
    const MeshView& mesh = stage.mesh();
    if (vertices_.size() < mesh.vertex_count()) return Status::kCacheTooSmall;
    if (!rows_.empty() && rows_.size() < mesh.triangle_count()) return Status::kCacheTooSmall;
    mesh_ = mesh;
    transform_ = stage.transform();
    two_sided_ = two_sided;
    holds_ = true;
    detail::forget_vertices(vertices_.data(), mesh.vertex_count());
    if (!rows_.empty()) detail::find_rows(stage, two_sided, vertices_.data(), rows_.data());
    return Status::kOk;
  }
  /// @endcond

  /// The memory of the vertices, and of the rows or null. For draw_mesh().
  [[nodiscard]] constexpr CachedVertex<Method>* vertices() const { return vertices_.data(); }
  [[nodiscard]] constexpr const TriangleRows* rows() const { return rows_.empty() ? nullptr : rows_.data(); }

 private:
  std::span<CachedVertex<Method>> vertices_;
  std::span<TriangleRows> rows_;
  MeshView mesh_;
  ClipTransform transform_;
  bool two_sided_ = false;
  bool holds_ = false;
};

}  // namespace arcspan
