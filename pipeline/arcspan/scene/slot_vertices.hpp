// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/triangle_rows.hpp>
#include <arcspan/draw/vertex_source.hpp>
#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/scene/scene_frame.hpp>
#include <arcspan/scene/scene_material.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

/// Where the vertices of an object in a scene come from, and the rows of its triangles.
namespace arcspan::detail {

/// The rows of the triangles of a slot's parts, one part after the other. They are found when they are first
/// asked for.
class PartRows {
 public:
  /// Those of the first part, unless they are not `wanted` or there is no memory for them.
  PartRows(SceneSlot& slot, bool wanted)
      : slot_(&slot), rows_(wanted || slot.parts_with_rows != 0 ? slot.rows : nullptr) {}

  /// No rows, for a source that has to look at all triangles.
  void leave_out() { rows_ = nullptr; }
  /// Before a part is drawn whose first triangle this is (PartSides).
  static constexpr void begin_part(std::size_t) {}
  /// Goes on from a part of so many triangles to the next one.
  void next_part(std::size_t triangles) {
    ++number_;
    if (rows_ != nullptr) rows_ += TriangleRows::entries(triangles);
  }
  template <class Method, class Mesh, class Source>
  void find(const VertexStage<Method, Mesh>& stage, bool two_sided, Source& source) const {
    if (rows_ == nullptr || number_ < slot_->parts_with_rows) return;
    find_rows(stage, two_sided, source, rows_);
    ++slot_->parts_with_rows;
  }
  [[nodiscard]] const TriangleRows* rows() const { return rows_; }

 private:
  SceneSlot* slot_;
  std::size_t number_ = 0;
  TriangleRows* rows_;
};

/// Stands for PartRows where a program has no memory for any.
struct NoRows {
  constexpr NoRows() = default;
  constexpr NoRows(SceneSlot&, bool) {}
  static constexpr void leave_out() {}
  static constexpr void begin_part(std::size_t) {}
  static constexpr void next_part(std::size_t) {}
  template <class Method, class Mesh, class Source>
  static constexpr void find(const VertexStage<Method, Mesh>&, bool, Source&) {}
  [[nodiscard]] static constexpr const TriangleRows* rows() { return nullptr; }
};

/// Every triangle transforms its own three vertices (VertexSource).
template <class KeptRows>
class UncachedPart : public KeptRows {
 public:
  constexpr explicit UncachedPart(const KeptRows& rows) : KeptRows(rows) {}

  template <class Method, class Mesh>
  [[nodiscard]] constexpr Status begin(const VertexStage<Method, Mesh>& stage, bool two_sided) {
    KeptRows::find(stage, two_sided, *this);
    return Status::kOk;
  }
  template <class Method, class Mesh>
  [[nodiscard]] static CachedVertex<Method> vertex(const VertexStage<Method, Mesh>& stage, std::size_t i) {
    return NoCache::vertex(stage, i);
  }
};

/// The number of the shading of all parts from the 255th on, which shade their vertices anew.
inline constexpr std::uint8_t kSharedShading = 255;
/// Returns the number of a part's shading (VertexStage).
[[nodiscard]] constexpr std::uint8_t shading_of(std::size_t part) {
  return part < kSharedShading - 1 ? static_cast<std::uint8_t>(part + 1) : kSharedShading;
}

/// The vertices of a slot (VertexSource). They stay from part to part and from band to band, unless another
/// use has written them.
template <class Method, class KeptRows = NoRows>
class SlotVertices : public KeptRows {
 public:
  SlotVertices(SceneSlot& slot, const UseFacts& use, const KeptRows& rows = KeptRows())
      : KeptRows(rows),
        slot_(slot),
        use_(use),
        vertices_(static_cast<CachedVertex<Method>*>(static_cast<void*>(slot.vertices))) {}

  template <class Mesh>
  [[nodiscard]] Status begin(const VertexStage<Method, Mesh>& stage, bool two_sided) {
    const std::size_t count = slot_.object->mesh().vertex_count();
    if (slot_.held != &use_) {
      forget_vertices(vertices_, count);
      slot_.held = &use_;
    } else if (stage.shading() == kSharedShading) {
      for (std::size_t i = 0; i < count; ++i) vertices_[i].shading = 0;
    }
    KeptRows::find(stage, two_sided, *this);
    return Status::kOk;
  }
  template <class Mesh>
  [[nodiscard]] ARCSPAN_INLINE CachedVertex<Method>& vertex(const VertexStage<Method, Mesh>& stage,
                                                            std::size_t i) {
    CachedVertex<Method>& vertex = vertices_[i];
    if (vertex.outcode == CachedVertex<Method>::kNotTransformed) stage.transform(i, vertex);
    return vertex;
  }

 private:
  SceneSlot& slot_;
  const UseFacts& use_;
  CachedVertex<Method>* vertices_;
};

}  // namespace arcspan::detail
