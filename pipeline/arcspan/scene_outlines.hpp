// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/triangle_sides.hpp>
#include <arcspan/ink_outlines.hpp>
#include <arcspan/mesh/mesh_neighbours.hpp>
#include <arcspan/outline/blend.hpp>
#include <arcspan/outline/curved_outlines.hpp>
#include <arcspan/outline/outline_list.hpp>
#include <arcspan/scene.hpp>
#include <arcspan/scene/part_sides.hpp>
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

/// The neighbours of a mesh, or null.
[[nodiscard]] inline const MeshNeighbours* neighbours_in(std::span<const OutlinedMesh> meshes,
                                                         const MeshView& mesh) {
  for (const OutlinedMesh& each : meshes)
    if (each.mesh == &mesh) return each.neighbours;
  return nullptr;
}

/// The vertices of an object of one part whose method draws curves; otherwise there are none.
template <class List>
[[nodiscard]] DrawnVertices curve_vertices(List list, const Object& object) {
  DrawnVertices vertices;
  if (object.part_count() != 1) return vertices;
  const SceneMaterial& material = *object.part(0).material;
  with_use(list, material.use(), [&]<class U>() {
    if constexpr (!kDrawsCurves<typename U::Method>) return;
    if constexpr (IsPosed<U>) {
      vertices = DrawnVertices(static_cast<const PosedMaterial<typename U::PosedMesh>&>(material).mesh());
    } else {
      vertices = DrawnVertices(object.mesh());
    }
  });
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

/// Adds the outlines of an object to `outlines`. `keeps_vertices` is that of the SceneHeader.
template <SceneMemoryType Memory, PixelFormat F, class Curved>
[[nodiscard]] Status add_outlines(SceneSlot& slot, bool keeps_vertices, SceneOutlines<F, Curved>& outlines) {
  const Object& object = *slot.object;
  const MeshView& mesh = object.mesh();
  const MeshNeighbours* const neighbours = neighbours_in(outlines.meshes, mesh);
  Status status = check_outlined<Memory>(object, neighbours, outlines.sides);
  if (ok(status)) status = hide_all(mesh, outlines.sides);
  typename Memory::KeptRows rows(slot, true);
  // Where rows tell the sides no vertex is transformed, and positions_of() would take those of the rest pose.
  if (!keeps_vertices && is_posed(typename Memory::UseList{}, object)) rows.leave_out();
  for (std::size_t i = 0; i < object.part_count() && ok(status); ++i) {
    const Part part = object.part(i);
    const MeshView triangles = mesh.part(part.first, part.count);
    const SidesCall<typename Memory::KeptRows> call{slot, triangles, rows, *part.material,
                                                    outlines.sides.subspan(part.first, part.count)};
    with_use(typename Memory::UseList{}, part.material->use(),
             [&]<class U>() { status = find_part_sides<U, Memory::kHasVertices>(call); });
    rows.next_part(part.count);
  }
  if (!ok(status)) return status;
  const VertexPositions positions = positions_of(typename Memory::UseList{}, slot);
  if constexpr (std::is_same_v<Curved, CurvedOutlines>) {
    return add_curves<Memory>(slot, *neighbours, positions, outlines);
  } else {
    return outlines.edges.add(mesh, *neighbours, positions, outlines.sides);
  }
}

/// Draws the curves over the outlines of the object at this place, like the object.
template <class Uses, SceneMemoryType Memory, class Sink, class Depth>
void draw_curves(Memory& memory, std::size_t place, const ObjectLights& lights, Sink& sink,
                 const Depth& depth, const CurvedOutlines& curves, SceneResult& result) {
  const SceneFrame frame = memory.frame();
  SceneSlot& slot = frame.entries[frame.order[place]];
  const std::size_t first = place == 0 ? 0 : frame.entries[frame.order[place - 1]].end_of_curves;
  const MeshView mesh = curves.mesh(first, slot.end_of_curves);
  if (mesh.triangle_count() == 0 || slot.object->part_count() != 1 || !ok(result.status)) return;
  const DrawResult drawn = draw_part<PartVertices::kOfCurves>(
      Uses{}, PartCall<Sink, Depth, NoRows>{slot, mesh, 0, NoRows(), *slot.object->part(0).material, lights,
                                            frame.header.camera->rotation(), sink, depth, memory.lighting()});
  result.status = drawn.status;
  result.triangles += drawn.triangles;
  result.left_out += drawn.left_out;
}

/// Clears what `Target` does, and has curves drawn with the objects.
template <class Target>
class CurvedTarget : public Target {
 public:
  constexpr CurvedTarget(const Target& target, const CurvedOutlines& curves)
      : Target(target), curves_(curves) {}

  template <class Uses, class Memory, class Sink, class Depth>
  void end_object(Memory& memory, std::size_t place, const ObjectLights& lights, Sink& sink,
                  const Depth& depth, SceneResult& result) const {
    draw_curves<Uses>(memory, place, lights, sink, depth, curves_, result);
  }

 private:
  const CurvedOutlines& curves_;
};

/// Clears what `Target` does, and adds the outlines of each object after it is drawn: of those whose outlines
/// or ink may reach the sink.
template <class Target, PixelFormat F>
class OutlinedTarget : public Target {
 public:
  static constexpr std::int32_t kBeyond = 2 * OutlineInk::kWidest;  // along rows ink is up to 3/2 as wide

  /// `found` becomes the first status that is not kOk.
  constexpr OutlinedTarget(const Target& target, SceneOutlines<F>& outlines, Status& found)
      : Target(target), outlines_(outlines), found_(found) {}

  template <class Memory>
  [[nodiscard]] PartSides begin_object(const SceneSlot& slot, bool) const {
    const Object& object = *slot.object;
    const bool is_outlined = ok(check_outlined<Memory>(object, neighbours_of(object), outlines_.sides)) &&
                             ok(hide_all(object.mesh(), outlines_.sides));
    return PartSides(is_outlined ? outlines_.sides.data() : nullptr);
  }
  template <class Uses, class Memory, class Sink, class Depth>
  void end_object(Memory& memory, std::size_t place, const ObjectLights&, Sink&, const Depth&,
                  const SceneResult&) const {
    const SceneFrame frame = memory.frame();
    const SceneSlot& slot = frame.entries[frame.order[place]];
    const Object& object = *slot.object;
    const MeshNeighbours* const neighbours = neighbours_of(object);
    Status status = check_outlined<Memory>(object, neighbours, outlines_.sides);
    if (ok(status))
      status = outlines_.edges.add(object.mesh(), *neighbours, positions_of(typename Memory::UseList{}, slot),
                                   outlines_.sides);
    if (ok(found_)) found_ = status;
  }

 private:
  [[nodiscard]] const MeshNeighbours* neighbours_of(const Object& object) const {
    return neighbours_in(outlines_.meshes, object.mesh());
  }

  SceneOutlines<F>& outlines_;
  Status& found_;
};

}  // namespace detail

/// Finds the outlines of all objects in view, the nearest first, once per frame after prepare_scene(). The
/// outlines of earlier frames are forgotten. In each band, after draw_prepared_scene() with a DepthBuffer,
/// call
///
///     smooth_outlines(outlines.edges, sink, depth, outlines.gaps);
///
/// With curves, draw_prepared_scene() takes `outlines.curves` as its last argument. If `memory` has room for
/// rows of triangles they are found here. For a picture that is drawn at once draw_scene() is cheaper, which
/// finds outlines while it draws.
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
    detail::SceneSlot& slot = frame.entries[frame.order[i]];
    if (!frame.header.keeps_vertices) slot.held = nullptr;
    const Status status = detail::add_outlines<Memory>(slot, frame.header.keeps_vertices, outlines);
    if constexpr (kCurved) slot.end_of_curves = static_cast<std::uint16_t>(outlines.curves.count());
    if (ok(first)) first = status;
  }
  return first;
}

/// draw_prepared_scene() with the curves of the last find_outlines(), each drawn with its object.
template <SceneMemoryType Memory, PixelSink Sink, DepthTarget Depth>
[[nodiscard]] SceneResult draw_prepared_scene(Memory& memory, Sink& sink, const Depth& depth,
                                              const CurvedOutlines& curves) {
  const detail::CurvedTarget<detail::KeepTarget> target({}, curves);
  return detail::draw_prepared(memory, sink, depth, target);
}
template <class Background = Rgb8, SceneMemoryType Memory, PixelSink Sink, DepthTarget Depth>
[[nodiscard]] SceneResult draw_prepared_scene(Memory& memory, Sink& sink, const Depth& depth,
                                              const Background& background, const CurvedOutlines& curves) {
  using Clear = detail::ClearTarget<Background>;
  const detail::CurvedTarget<Clear> target(Clear(background), curves);
  return detail::draw_prepared(memory, sink, depth, target);
}

namespace detail {

/// Draws a scene and finds its outlines: while it is drawn, unless curves are drawn over them or the list has
/// methods that blend: then an object may be drawn in two passes. Then finish() changes the picture along
/// them. The status is that of drawing, of find_outlines() or of finish().
template <class Background, SceneMemoryType Memory, PixelSink Sink, DepthTarget Depth, PixelFormat F,
          class Curved, class Finish>
[[nodiscard]] SceneResult draw_outlined(const Scene& scene, Sink& sink, const Depth& depth, Memory& memory,
                                        const Background& background, SceneOutlines<F, Curved>& outlines,
                                        const Finish& finish) {
  static_assert(Depth::kWrites, "outlines are compared with depths");
  Status found = prepare_once(scene, memory);
  if (!ok(found)) return {found};
  SceneResult result;
  if constexpr (std::is_same_v<Curved, CurvedOutlines>) {
    found = find_outlines(memory, outlines);
    result = draw_prepared_scene(memory, sink, depth, background, outlines.curves);
  } else if constexpr (kHasBlended<typename Memory::UseList>) {
    found = find_outlines(memory, outlines);
    result = draw_prepared_scene(memory, sink, depth, background);
  } else {
    outlines.edges.clear();
    using Clear = ClearTarget<Background>;
    const OutlinedTarget<Clear, F> target(Clear(background), outlines, found);
    result = draw_prepared(memory, sink, depth, target);
  }
  if (!ok(result.status)) return result;
  const Status finished = finish();
  result.status = ok(found) ? finished : found;
  return result;
}

}  // namespace detail

/// draw_scene() with smooth outlines. The status is the first that is not kOk: that of draw_scene(), of
/// find_outlines() for the objects that may reach the sink, with curves or where `memory` lists a method that
/// blends for all in view, or of smooth_outlines(). With the last two the
/// scene is drawn, and smoothed as far as they state.
template <class Background = Rgb8, SceneMemoryType Memory, PixelSink Sink, DepthTarget Depth, class Curved>
[[nodiscard]] SceneResult draw_scene(const Scene& scene, Sink& sink, const Depth& depth, Memory& memory,
                                     const Background& background,
                                     SceneOutlines<typename Sink::Format, Curved>& outlines) {
  return detail::draw_outlined(scene, sink, depth, memory, background, outlines,
                               [&] { return smooth_outlines(outlines.edges, sink, depth, outlines.gaps); });
}

/// draw_scene() with outlines that are inked and then smoothed. The status is as above, with that of
/// ink_outlines() before that of smooth_outlines(). A sink whose format has too few levels for smoothing gets
/// ink alone.
template <class Background = Rgb8, SceneMemoryType Memory, PixelSink Sink, DepthTarget Depth, class Curved>
[[nodiscard]] SceneResult draw_scene(const Scene& scene, Sink& sink, const Depth& depth, Memory& memory,
                                     const Background& background,
                                     SceneOutlines<typename Sink::Format, Curved>& outlines,
                                     const OutlineInk& ink) {
  return detail::draw_outlined(scene, sink, depth, memory, background, outlines, [&] {
    const Status inked = ink_outlines(outlines.edges, ink, sink, depth, outlines.gaps);
    const Status smoothed = detail::kCanBlend<typename Sink::Format>
                                ? smooth_outlines(outlines.edges, sink, depth, outlines.gaps)
                                : Status::kOk;
    return ok(inked) ? smoothed : inked;
  });
}

}  // namespace arcspan
