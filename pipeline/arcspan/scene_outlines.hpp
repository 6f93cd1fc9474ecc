// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/triangle_sides.hpp>
#include <arcspan/ink_outlines.hpp>
#include <arcspan/mesh/mesh_neighbours.hpp>
#include <arcspan/outline/blend.hpp>
#include <arcspan/outline/curved_outlines.hpp>
#include <arcspan/outline/outline_list.hpp>
#include <arcspan/scene.hpp>
#include <arcspan/smooth_outlines.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace arcspan {

/// A mesh of the objects of a scene, and the neighbours of its triangles. Both must outlive the frame.
struct OutlinedMesh {
  const MeshView* mesh;  ///< the one that objects refer to
  const MeshNeighbours* neighbours;
};

/// Outlines stay straight.
struct NoCurves {};

/// The neighbours and the memory by which the outlines of a scene are smoothed or inked. The memory is the
/// caller's and needs no initialisation. `Curved` is NoCurves or CurvedOutlines.
template <PixelFormat F, class Curved = NoCurves>
struct SceneOutlines {
  std::span<const OutlinedMesh> meshes;
  std::span<TriangleSide> sides;  ///< as many as the largest mesh has triangles
  OutlineList edges;              ///< over memory for the outlines of all objects in view
  std::span<OutlineGap<F>> gaps;  ///< as smooth_outlines() takes them
  /// Those of the objects in view that have one part, neither texture nor vertex colours.
  [[no_unique_address]] Curved curves{};
};

namespace detail {

/// A part of an object whose sides are to be found. `KeptRows` is PartRows or NoRows.
template <class KeptRows>
struct SidesCall {
  SceneSlot& slot;
  const MeshView& mesh;  ///< of the part
  const KeptRows& rows;
  const SceneMaterial& material;
  std::span<TriangleSide> sides;
  VertexPositions& positions;  ///< gets those of the slot's vertices, if it has some
};

template <class Used, bool KeepsVertices, class KeptRows>
requires(!IsPosed<Used>) [[nodiscard]] Status find_part_sides(const SidesCall<KeptRows>& call) {
  using Method = typename Used::Method;
  const auto& lighting = static_cast<const PreparedMaterial<Used>&>(call.material).lighting();
  const ClipTransform& transform = call.slot.transform;
  if constexpr (KeepsVertices) {
    SlotVertices<Method, KeptRows> vertices(call.slot, kUseFacts<Used>, call.rows);
    call.positions = VertexPositions(transform, vertices.all());
    return find_sides<Method>(call.mesh, transform, lighting, vertices, call.sides, call.material.options());
  } else {
    return find_sides<Method>(call.mesh, transform, lighting, UncachedPart(call.rows), call.sides,
                              call.material.options());
  }
}

/// find_part_sides() of vertices that a mesh poses. Their places are known only from the slot, which must
/// keep those of all parts.
template <IsPosed Used, bool KeepsVertices, class KeptRows>
[[nodiscard]] Status find_part_sides(const SidesCall<KeptRows>& call) {
  using Method = typename Used::Method;
  const Object& object = *call.slot.object;
  for (std::size_t i = 0; i < object.part_count(); ++i)
    if (!KeepsVertices || object.part(i).material->use() != &kUseFacts<Used>) return Status::kUnsupported;
  const PosedPart<Used> mesh(call.material, call.mesh);
  if (!mesh.fits()) return Status::kInvalidArgument;
  SlotVertices<Method, KeptRows> vertices(call.slot, kUseFacts<Used>, call.rows);
  call.positions = VertexPositions(call.slot.transform, vertices.all());
  return find_sides<Method>(mesh, call.slot.transform, prepared<Used>(call.material).lighting(), vertices,
                            call.sides, call.material.options());
}

/// Finds the sides of a part by the method of its material, which is listed.
template <bool KeepsVertices, class... Used, class KeptRows>
[[nodiscard]] Status find_part_sides(MethodList<Used...>, const SidesCall<KeptRows>& call) {
  Status status = Status::kOk;
  (void)((call.material.use() == &kUseFacts<Used> &&
          (status = find_part_sides<Used, KeepsVertices>(call), true)) ||
         ...);
  return status;
}

/// The neighbours of a mesh, or null.
[[nodiscard]] inline const MeshNeighbours* neighbours_in(std::span<const OutlinedMesh> meshes,
                                                         const MeshView& mesh) {
  for (const OutlinedMesh& each : meshes)
    if (each.mesh == &mesh) return each.neighbours;
  return nullptr;
}

/// The vertices of an object of one part whose method draws curves; otherwise there are none.
template <class... Used>
[[nodiscard]] DrawnVertices curve_vertices(MethodList<Used...>, const Object& object) {
  DrawnVertices vertices;
  const auto find = [&]<class U>(const SceneMaterial& material) {
    if (material.use() != &kUseFacts<U> || !kDrawsCurves<typename U::Method>) return;
    if constexpr (IsPosed<U>) {
      vertices = DrawnVertices(static_cast<const PosedMaterial<typename U::PosedMesh>&>(material).mesh());
    } else {
      vertices = DrawnVertices(object.mesh());
    }
  };
  if (object.part_count() == 1) (find.template operator()<Used>(*object.part(0).material), ...);
  return vertices;
}

/// Adds the outlines of an object with curves over them.
template <SceneMemoryType Memory, PixelFormat F>
[[nodiscard]] Status add_curves(SceneSlot& slot, const MeshNeighbours& neighbours,
                                const VertexPositions& positions,
                                SceneOutlines<F, CurvedOutlines>& outlines) {
  const Object& object = *slot.object;
  const DrawnVertices vertices = curve_vertices(typename Memory::UseList{}, object);
  CurvedOutlines& curves = outlines.curves;
  const std::size_t before = curves.count();
  const Status status =
      vertices.exist()
          ? curves.add(vertices, object.mesh(), neighbours, positions, outlines.sides, outlines.edges)
          : outlines.edges.add(object.mesh(), neighbours, positions, outlines.sides);
  if (curves.count() == before) return status;
  // Bands without the object's sphere are skipped. With normals at most 72 degrees apart a curve rises by
  // 0.24 of half its edge x, so it leaves the sphere by at most 3 %: sqrt(r^2 - x^2) + 0.24 x < 1.03 r.
  BoundingSphere sphere = object.sphere();
  const std::uint32_t radius = sphere.radius + std::uint32_t{sphere.radius} / 32 + 2;
  sphere.radius = static_cast<std::uint16_t>(radius < UINT16_MAX ? radius : UINT16_MAX);
  slot.sphere = clip_sphere(slot.transform, sphere);
  return status;
}

/// Adds the outlines of an object to `outlines`.
template <SceneMemoryType Memory, PixelFormat F, class Curved>
[[nodiscard]] Status add_outlines(SceneSlot& slot, SceneOutlines<F, Curved>& outlines) {
  const Object& object = *slot.object;
  const MeshView& mesh = object.mesh();
  const MeshNeighbours* const neighbours = neighbours_in(outlines.meshes, mesh);
  if (neighbours == nullptr) return Status::kUnsupported;
  Status status = hide_all(mesh, outlines.sides);
  VertexPositions positions(slot.transform);
  typename Memory::KeptRows rows(slot, true);
  for (std::size_t i = 0; i < object.part_count() && ok(status); ++i) {
    const Part part = object.part(i);
    const MeshView triangles = mesh.part(part.first, part.count);
    status = find_part_sides<Memory::kHasVertices>(
        typename Memory::UseList{},
        SidesCall<typename Memory::KeptRows>{slot, triangles, rows, *part.material,
                                             outlines.sides.subspan(part.first, part.count), positions});
    rows.next_part(part.count);
  }
  if (!ok(status)) return status;
  if constexpr (std::is_same_v<Curved, CurvedOutlines>) {
    return add_curves<Memory>(slot, *neighbours, positions, outlines);
  } else {
    return outlines.edges.add(mesh, *neighbours, positions, outlines.sides);
  }
}

/// Clears what `Target` does, and has curves drawn with the objects.
template <class Target>
struct CurvedTarget : Target {
  const CurvedOutlines& curves;
};

/// Draws the curves over the outlines of an object, like the object.
template <SceneMemoryType Memory, class Sink, class Depth>
void draw_curves(Memory& memory, SceneSlot& slot, const ObjectLights& lights, Sink& sink, const Depth& depth,
                 const CurvedOutlines& curves, SceneResult& result) {
  const SceneFrame frame = memory.frame();
  // A slot's `depth` is the number of curves up to its own now (find_outlines()). They lie in the order of
  // the slots.
  const std::size_t first = &slot == frame.slots.data() ? 0 : (&slot)[-1].depth;
  const MeshView mesh = curves.mesh(first, slot.depth);
  if (mesh.triangle_count() == 0 || slot.object->part_count() != 1 || !ok(result.status)) return;
  const DrawResult drawn = draw_part<PartVertices::kOfCurves>(
      typename Memory::UseList{},
      PartCall<Sink, Depth, NoRows>{slot, mesh, 0, NoRows(), *slot.object->part(0).material, lights,
                                    frame.header.camera->rotation(), sink, depth, memory.lighting()});
  result.status = drawn.status;
  result.triangles += drawn.triangles;
  result.left_out += drawn.left_out;
}

}  // namespace detail

/// Finds the outlines of all objects in view, once per frame after prepare_scene(). The outlines of earlier
/// frames are forgotten. In each band, after draw_prepared_scene() with a DepthBuffer, call
///
///     smooth_outlines(outlines.edges, sink, depth, outlines.gaps);
///
/// With curves, draw_prepared_scene() takes `outlines.curves` as its last argument. If `memory` has room for
/// rows of triangles they are found here, which pays in bands only.
///
/// A scene whose surfaces are blended with what is behind them is drawn afterwards, with a ReadOnlyDepth. Its
/// outlines are found and smoothed in the same way, with a SceneOutlines of its own.
///
/// Returns kOk, the status of prepare_scene(), or the first of these that occurs; the objects that it does
/// not concern are smoothed all the same:
///
///   kNotReady          nothing is prepared
///   kUnsupported       `outlines.meshes` does not name the mesh of an object in view, or its neighbours were
///                      never made; or an object is posed (PosedMaterial), and its parts have several methods
///                      or `memory` has no vertices
///   kInvalidArgument   the neighbours have another number of triangles than the mesh; a PosedMaterial does
///                      not fit its object
///   kBufferTooSmall    `outlines` has fewer sides than a mesh has triangles, or room for fewer edges; or
///                      room for fewer curves: the edges of the others stay straight
///   kScaleOutOfRange   as CurvedOutlines::add()
template <SceneMemoryType Memory, PixelFormat F, class Curved>
[[nodiscard]] Status find_outlines(Memory& memory, SceneOutlines<F, Curved>& outlines) {
  constexpr bool kCurved = std::is_same_v<Curved, CurvedOutlines>;
  outlines.edges.clear();
  if constexpr (kCurved) outlines.curves.clear();
  if (!ok(memory.status())) return memory.status();
  const detail::SceneFrame frame = memory.frame();
  if (frame.header.camera == nullptr) return Status::kNotReady;
  Status first = frame.header.status;
  for (std::size_t i = 0; i < frame.header.in_view; ++i) {
    detail::SceneSlot& slot = frame.slots[i];
    if (!frame.header.keeps_vertices) slot.held = nullptr;
    const Status status = detail::add_outlines<Memory>(slot, outlines);
    if constexpr (kCurved) slot.depth = static_cast<std::uint16_t>(outlines.curves.count());
    if (ok(first)) first = status;
  }
  return first;
}

/// draw_prepared_scene() with the curves of the last find_outlines(), each drawn with its object.
template <SceneMemoryType Memory, PixelSink Sink, DepthTarget Depth>
[[nodiscard]] SceneResult draw_prepared_scene(Memory& memory, Sink& sink, const Depth& depth,
                                              const CurvedOutlines& curves) {
  const detail::CurvedTarget<detail::KeepTarget> target{{}, curves};
  return detail::draw_prepared(memory, sink, depth, target);
}
template <class Background = Rgb8, SceneMemoryType Memory, PixelSink Sink, DepthTarget Depth>
[[nodiscard]] SceneResult draw_prepared_scene(Memory& memory, Sink& sink, const Depth& depth,
                                              const Background& background, const CurvedOutlines& curves) {
  const detail::CurvedTarget<detail::ClearTarget<Background>> target{{background}, curves};
  return detail::draw_prepared(memory, sink, depth, target);
}

namespace detail {

/// Finds the outlines of a scene and draws it. `found` gets the status of find_outlines().
template <class Background, SceneMemoryType Memory, PixelSink Sink, DepthTarget Depth, PixelFormat F,
          class Curved>
[[nodiscard]] SceneResult draw_and_find_outlines(const Scene& scene, Sink& sink, const Depth& depth,
                                                 Memory& memory, const Background& background,
                                                 SceneOutlines<F, Curved>& outlines, Status& found) {
  static_assert(Depth::kWrites, "outlines are compared with depths");
  found = prepare_once(scene, memory);
  if (!ok(found)) return {found};
  found = find_outlines(memory, outlines);
  if constexpr (std::is_same_v<Curved, CurvedOutlines>) {
    return draw_prepared_scene(memory, sink, depth, background, outlines.curves);
  } else {
    return draw_prepared_scene(memory, sink, depth, background);
  }
}

}  // namespace detail

/// draw_scene() with smooth outlines. The status is the first that is not kOk: that of draw_scene(), of
/// find_outlines() or of smooth_outlines(). With the last two the scene is drawn, and smoothed as far as they
/// state.
template <class Background = Rgb8, SceneMemoryType Memory, PixelSink Sink, DepthTarget Depth, class Curved>
[[nodiscard]] SceneResult draw_scene(const Scene& scene, Sink& sink, const Depth& depth, Memory& memory,
                                     const Background& background,
                                     SceneOutlines<typename Sink::Format, Curved>& outlines) {
  Status found = Status::kOk;
  SceneResult result =
      detail::draw_and_find_outlines(scene, sink, depth, memory, background, outlines, found);
  if (!ok(result.status)) return result;
  const Status smoothed = smooth_outlines(outlines.edges, sink, depth, outlines.gaps);
  result.status = ok(found) ? smoothed : found;
  return result;
}

/// draw_scene() with outlines that are inked and then smoothed. The status is as above, with that of
/// ink_outlines() before that of smooth_outlines(). A sink whose format has too few levels for smoothing gets
/// ink alone.
template <class Background = Rgb8, SceneMemoryType Memory, PixelSink Sink, DepthTarget Depth, class Curved>
[[nodiscard]] SceneResult draw_scene(const Scene& scene, Sink& sink, const Depth& depth, Memory& memory,
                                     const Background& background,
                                     SceneOutlines<typename Sink::Format, Curved>& outlines,
                                     const OutlineInk& ink) {
  Status found = Status::kOk;
  SceneResult result =
      detail::draw_and_find_outlines(scene, sink, depth, memory, background, outlines, found);
  if (!ok(result.status)) return result;
  Status finished = ink_outlines(outlines.edges, ink, sink, depth, outlines.gaps);
  if constexpr (detail::kCanBlend<typename Sink::Format>) {
    const Status smoothed = smooth_outlines(outlines.edges, sink, depth, outlines.gaps);
    if (ok(finished)) finished = smoothed;
  }
  result.status = ok(found) ? finished : found;
  return result;
}

}  // namespace arcspan
