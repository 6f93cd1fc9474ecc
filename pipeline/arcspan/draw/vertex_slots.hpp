// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/vertex_source.hpp>
#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

/// A vertex is kept until another one needs its slot (VertexSource): memory for Count vertices, whatever the
/// mesh has. `arcspan mesh` orders triangles and vertices so that most are still there when the next triangle
/// needs them. Any order gives the same picture.
///
/// `rows` is as for a VertexCache. With it the first band of a frame transforms all vertices once more, to
/// find the rows of the triangles. clear() and kCacheMismatch are as there too, and kCacheTooSmall is
/// returned if `rows` is neither empty nor large enough.
template <class Method, std::size_t Count = 64>
class VertexSlots {
  static_assert(std::has_single_bit(Count) && Count >= 8, "the slot of a vertex is a part of its number");

 public:
  constexpr explicit VertexSlots(std::span<TriangleRows> rows = {}) : rows_(rows) {}

  /// Forgets the object.
  constexpr void clear() { object_.clear(); }

  template <class Mesh>
  [[nodiscard]] Status begin(const VertexStage<Method, Mesh>& stage, bool two_sided) {
    const MeshView& mesh = stage.mesh();
    if (object_.exists()) return object_.compare(mesh, stage.transform(), two_sided);
    if (!rows_.empty() && rows_.size() < TriangleRows::entries(mesh.triangle_count()))
      return Status::kCacheTooSmall;
    object_.hold(mesh, stage.transform(), two_sided);
    for (std::size_t i = 0; i < Count; ++i) numbers_[i] = static_cast<std::uint16_t>(i + 1);  // not of slot i
    if (!rows_.empty()) detail::find_rows(stage, two_sided, *this, rows_.data());
    return Status::kOk;
  }
  template <class Mesh>
  [[nodiscard]] ARCSPAN_INLINE CachedVertex<Method>& vertex(const VertexStage<Method, Mesh>& stage,
                                                            std::size_t i) {
    std::size_t slot = i % Count;
    if (numbers_[slot] != i) slot = fill(stage, i, slot);
    before_last_ = last_;
    last_ = slot;
    return vertices_[slot];
  }
  [[nodiscard]] constexpr const TriangleRows* rows() const { return rows_.empty() ? nullptr : rows_.data(); }

 private:
  /// Transforms vertex i into its slot. The other two vertices of its triangle stay: if one of them is there,
  /// it goes into a spare slot, from where it is not found again. Two are enough, because after two spare
  /// slots no vertex of the last two calls is in a slot of its own.
  template <class Mesh>
  ARCSPAN_OUTLINE std::size_t fill(const VertexStage<Method, Mesh>& stage, std::size_t i, std::size_t slot) {
    if (slot == last_ || slot == before_last_) {
      spare_ ^= 1u;
      slot = Count + spare_;
    } else {
      numbers_[slot] = static_cast<std::uint16_t>(i);
    }
    stage.transform(i, vertices_[slot]);
    return slot;
  }

  std::array<CachedVertex<Method>, Count + 2> vertices_;
  std::array<std::uint16_t, Count> numbers_;  ///< of the vertices in the slots
  std::size_t last_ = Count;                  ///< the slots of the last two calls
  std::size_t before_last_ = Count;
  std::size_t spare_ = 0;
  std::span<TriangleRows> rows_;
  detail::HeldObject object_;
};

}  // namespace arcspan
