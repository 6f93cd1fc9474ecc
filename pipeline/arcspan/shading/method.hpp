// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/pixel_light.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/prepare/row_start.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/status.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>

/// The protocol of a shading method: what draw_mesh() demands of a type that it is given as `Method`. A
/// method is chosen at compile time and has one file. The smallest complete one draws an object in one
/// colour:
///
///     struct Plain {
///       using Lighting = PackedRgb;  // what the whole object is drawn with
///       struct Face {};              // what is kept of a face's normal
///       struct Vertex {};            // what is kept of a vertex's normal
///       struct Prepared {};          // the method's part of the triangle command
///       static constexpr bool kNeedsFaceNormal = false;
///
///       static Vertex shade_vertex(const Lighting&, const Direction&) { return {}; }
///       static Face shade_face(const Lighting&, const Direction&) { return {}; }
///       static Vertex between(const Vertex&, const Vertex&, Factor) { return {}; }
///       static void prepare(const Lighting&, auto& frame, const Face&, Prepared&) {}
///
///       struct Run {  // the pixels of a row
///         PackedRgb colour(const Lighting& lighting) const { return lighting; }
///         void next() {}
///       };
///       struct Walker {  // the rows of a triangle
///         using Run = Plain::Run;
///         Run row(const RowStart&) const { return {}; }
///         void next_row() {}
///         void enter_lower() {}
///       };
///       static Status walk(Prepared&, auto&& draw) { return draw(Walker()); }
///     };
///
/// Optional parts, each a concept of its own: PiecewiseRun and LightRun of a run; TakesVertexData,
/// NeedsNearOverW (prepare/triangle_command.hpp), DrawsSmallTriangles and DrawsEdges of a method.
namespace arcspan {

/// The type of a colour that a run hands to the pixel format.
template <class C>
concept RunColour = std::same_as<C, PackedRgb> || PackableColour<C>;

/// The pixels of a row from left to right: `colour()` is that of the current pixel, `next()` steps to the
/// next one.
template <class R, class Lighting>
concept PixelRun = requires(R run, const Lighting& lighting) {
  { run.colour(lighting) } -> RunColour;
  {run.next()};
};

/// Walks down the rows of a command. `row()` returns the run of the current row; `next_row()` steps down;
/// `enter_lower()` changes to the lower short edge. A walker may change the command's prepared part. Walkers
/// and runs belong to the span stage: they do not divide.
template <class W, class Lighting>
concept RowWalker = PixelRun<typename W::Run, Lighting> && requires(W walker, const RowStart& row) {
  { walker.row(row) } -> std::same_as<typename W::Run>;
  {walker.next_row()};
  {walker.enter_lower()};
};

/// A way of shading triangles. Its types and functions:
///
/// - `Lighting`: what the method needs of an object's illumination and material.
/// - `Face`: what it keeps of a face's normal. shade_face() is called only if kNeedsFaceNormal.
/// - `Vertex`: what it keeps of a vertex's normal. An empty type saves the look-up of normals.
/// - `Prepared`: its part of the triangle command, made by prepare(), the last place where it may divide.
///   prepare() gets a TriangleFrame and may complete it.
/// - `between`: the vertex at a CutFraction (or Factor) of an edge, for clipping. At 1/2 the result must not
///   depend on the order of the two ends.
/// - `walk`: static Status walk(Prepared&, draw) calls `draw` with a RowWalker and returns its status. The
///   type of the walker may depend on the triangle. It is a template, which the concept cannot check.
template <class M>
concept ShadingMethod = requires(const typename M::Lighting& lighting, const Direction& normal,
                                 const typename M::Vertex& vertex, const typename M::Face& face,
                                 TriangleFrame<M>& frame, typename M::Prepared& prepared, CutFraction t) {
  { M::shade_vertex(lighting, normal) } -> std::same_as<typename M::Vertex>;
  { M::shade_face(lighting, normal) } -> std::same_as<typename M::Face>;
  { M::between(vertex, vertex, t) } -> std::same_as<typename M::Vertex>;
  {M::prepare(lighting, frame, face, prepared)};
  { M::kNeedsFaceNormal } -> std::convertible_to<bool>;
};

/// Optional part of a run that computes something anew in every piece of a row: a segment with a linear
/// colour, or the start of the texels. enter() is called before each piece. It gets the number of pixels left
/// in the row and returns the length of the piece, 1 up to that number.
template <class R, class Lighting>
concept PiecewiseRun = PixelRun<R, Lighting> && requires(R run, const Lighting& lighting, std::int32_t left) {
  { run.enter(lighting, left) } -> std::same_as<std::int32_t>;
};

/// True if the pieces of a run depend on the whole row: a row that the scissor cuts is then walked from its
/// first column in the picture, and `left` counts the pixels up to its end, so that cutting changes no pixel.
/// A PiecewiseRun whose pieces do not says so by `static constexpr bool kStartsAnywhere = true`.
template <class R, class Lighting>
inline constexpr bool kWalksWholeRows = PiecewiseRun<R, Lighting> && !requires {
  requires bool{R::kStartsAnywhere};
};

/// Optional part of a run: light(lighting) returns the parts of colour(), for methods that reflect them
/// differently (Textured).
template <class R, class Lighting>
concept LightRun = requires(const R& run, const Lighting& lighting) {
  { run.light(lighting) } -> std::convertible_to<PixelLight>;
};

/// Optional part of a method: set_vertex_data(mesh, i, vertex) sets what vertex i has in the mesh besides its
/// normal.
template <class M>
concept TakesVertexData = requires(const MeshView& mesh, std::size_t i, typename M::Vertex& vertex) {
  {M::set_vertex_data(mesh, i, vertex)};
};

/// Optional part of a method: it draws small triangles (prepare/small_triangle.hpp) by barycentric
/// coordinates. A method declares that by `using DrawsSmallTrianglesAs =` its own name; methods derived from
/// it do not draw them, unless they declare it as well.
///
/// `Small` is the method's part of a small triangle. prepare_small(lighting, top, middle, bottom, face,
/// triangle, small) makes it from three RasterVertex, sorted by height, the Face and the SmallTriangle; it
/// returns false if the triangle has to be drawn by a TriangleCommand. walk_small(small, draw) calls `draw`
/// with a surface and returns its status. The surface's row(y, middle, bottom) returns the run (PixelRun) of
/// a row: `y` is the row's centre line (28.4), `middle` and `bottom` are the barycentric coordinates of its
/// first pixel, 16 fraction bits. A method that draws triangles above 16 pixels faster by a TriangleCommand
/// has `static constexpr std::int32_t kSmallSize = 16` (Flat).
template <class M>
concept DrawsSmallTriangles = std::same_as<typename M::DrawsSmallTrianglesAs, M>;

/// Optional part of a method (`kDrawsEdges`): the edges of triangles are drawn as lines, not their areas, by
/// its `EdgesDrawer` (Wireframe). Its Lighting has a `bias` (DepthBias).
template <class M>
concept DrawsEdges = bool{M::kDrawsEdges};

}  // namespace arcspan
