// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/draw_options.hpp>
#include <arcspan/draw/triangle_rows.hpp>
#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/clip_transform.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <concepts>
#include <cstddef>
#include <span>
#include <type_traits>

namespace arcspan {

/// Where the transformed vertices of a draw call come from: VertexCache, NoCache, or one of a program's own.
///
/// - begin(stage, two_sided): called once per draw call, before anything is drawn. Any other status than kOk
///   ends the call.
/// - vertex(stage, i): vertex i of the mesh, transformed by stage.transform(). A CachedVertex& that stays
///   valid and keeps its contents until the triangle is drawn, or a CachedVertex by value. draw_mesh() shades
///   it, if need be, by stage.shade(), so a reference keeps the shading for further triangles.
/// - rows(): TriangleRows::entries() of the mesh, by which triangles of other bands are skipped, or null.
template <class S, class Method, class Mesh = MeshView>
concept VertexSource = requires(S& source, const VertexStage<Method, Mesh>& stage, std::size_t i,
                                bool two_sided) {
  { source.begin(stage, two_sided) } -> std::same_as<Status>;
  requires std::same_as<std::remove_reference_t<decltype(source.vertex(stage, i))>, CachedVertex<Method>>;
  { source.rows() } -> std::same_as<const TriangleRows*>;
};

namespace detail {

/// Marks vertices as not transformed.
template <class Method>
void forget_vertices(CachedVertex<Method>* vertices, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) vertices[i].outcode = CachedVertex<Method>::kNotTransformed;
}

/// The object whose vertices a source keeps from call to call.
class HeldObject {
 public:
  constexpr void clear() { holds_ = false; }
  [[nodiscard]] constexpr bool exists() const { return holds_; }
  /// Returns kCacheMismatch if it is another one than this, otherwise kOk.
  [[nodiscard]] constexpr Status compare(const MeshView& mesh, const ClipTransform& transform,
                                         bool two_sided) const {
    const bool same = mesh_ == mesh && transform_ == transform && two_sided_ == two_sided;
    return same ? Status::kOk : Status::kCacheMismatch;
  }
  constexpr void hold(const MeshView& mesh, const ClipTransform& transform, bool two_sided) {
    mesh_ = mesh;
    transform_ = transform;
    two_sided_ = two_sided;
    holds_ = true;
  }

 private:
  MeshView mesh_;
  ClipTransform transform_;
  bool two_sided_ = false;
  bool holds_ = false;
};

}  // namespace detail

/// Every triangle transforms its own three vertices (VertexSource). Needs no memory.
struct NoCache {
  template <class Method, class Mesh>
  [[nodiscard]] static constexpr Status begin(const VertexStage<Method, Mesh>&, bool) {
    return Status::kOk;
  }
  template <class Method, class Mesh>
  [[nodiscard]] static CachedVertex<Method> vertex(const VertexStage<Method, Mesh>& stage, std::size_t i) {
    CachedVertex<Method> vertex;
    stage.transform(i, vertex);
    return vertex;
  }
  [[nodiscard]] static constexpr const TriangleRows* rows() { return nullptr; }
};

/// Every vertex is transformed and shaded at most once (VertexSource): transformed when the first triangle
/// needs it if the back faces of the mesh are known, else all at once. The memory is the caller's:
///
/// - `vertices`: at least as many as the mesh has.
/// - `rows`: for pictures in bands; at least TriangleRows::entries() of the mesh's triangles, or none.
///
/// The cache keeps its object from call to call. Call clear() before the first band of every frame, and
/// whenever the object's lighting or the pose of its mesh (DrawableMesh) has changed (docs/bands.md).
///
/// A call for another mesh, another transform or another value of DrawOptions::two_sided than those of the
/// first call since clear() draws nothing and returns kCacheMismatch. Changes of the lighting and of a pose
/// are not noticed: vertices that have been shaded keep the earlier ones. With too little memory for the mesh
/// a call draws nothing and returns kCacheTooSmall.
template <class Method>
class VertexCache {
 public:
  constexpr explicit VertexCache(std::span<CachedVertex<Method>> vertices, std::span<TriangleRows> rows = {})
      : vertices_(vertices), rows_(rows) {}

  /// Forgets the object.
  constexpr void clear() { object_.clear(); }

  /// Transforms and shades all, so that cores may share the cache until clear(). Returns kCacheTooSmall or
  /// kOk.
  template <DrawableMesh Mesh>
  Status fill(const Mesh& mesh, const ClipTransform& transform, const typename Method::Lighting& lighting,
              const DrawOptions& options = {}) {
    clear();
    VertexStage<Method, Mesh> stage(mesh, transform, lighting);
    if (!options.two_sided) stage.find_back_faces();
    const Status status = begin(stage, options.two_sided);
    if (!ok(status)) return status;
    for (std::size_t i = 0; i < stage.mesh().vertex_count(); ++i) {
      CachedVertex<Method>& filled = vertex(stage, i);
      if (filled.outcode == kInside) stage.shade(i, filled);
    }
    return Status::kOk;
  }

  /// Starts to hold the object of `stage` if the cache holds none, and finds the rows of its triangles.
  template <class Mesh>
  [[nodiscard]] Status begin(const VertexStage<Method, Mesh>& stage, bool two_sided) {
    const MeshView& mesh = stage.mesh();
    if (object_.exists()) return object_.compare(mesh, stage.transform(), two_sided);
    if (vertices_.size() < mesh.vertex_count()) return Status::kCacheTooSmall;
    if (!rows_.empty() && rows_.size() < TriangleRows::entries(mesh.triangle_count()))
      return Status::kCacheTooSmall;
    object_.hold(mesh, stage.transform(), two_sided);
    if (stage.back_faces().known()) {
      detail::forget_vertices(vertices_.data(), mesh.vertex_count());
    } else {
      stage.transform_all(vertices_.data());
    }
    if (!rows_.empty()) detail::find_rows(stage, two_sided, *this, rows_.data());
    return Status::kOk;
  }
  template <class Mesh>
  [[nodiscard]] ARCSPAN_INLINE CachedVertex<Method>& vertex(const VertexStage<Method, Mesh>& stage,
                                                            std::size_t i) {
    CachedVertex<Method>& vertex = vertices_[i];
    if (vertex.outcode == CachedVertex<Method>::kNotTransformed) stage.transform(i, vertex);
    return vertex;
  }
  /// Vertex i where begin() has transformed all: it does so unless the back faces of the mesh are known.
  [[nodiscard]] ARCSPAN_INLINE CachedVertex<Method>& transformed(std::size_t i) { return vertices_[i]; }
  [[nodiscard]] constexpr const TriangleRows* rows() const { return rows_.empty() ? nullptr : rows_.data(); }

 private:
  std::span<CachedVertex<Method>> vertices_;
  std::span<TriangleRows> rows_;
  detail::HeldObject object_;
};

}  // namespace arcspan
