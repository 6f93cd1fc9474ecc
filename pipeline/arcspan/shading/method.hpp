// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/pixel_light.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/pixel/colour_segment.hpp>
#include <arcspan/prepare/row_start.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/status.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

/// The protocol of a shading method: what draw_mesh() demands of a type that it is given as `Method`.
///
/// A method is chosen at compile time and has one file; a firmware contains only the methods that it names.
/// The required part is ShadingMethod with RowWalker and PixelRun (or SegmentedRun). The optional parts are
/// named concepts too: MeasuresChords (prepare/sorted_vertices.hpp), UsesEncodedColours with EncodingRun,
/// OutlinedWalker, OutlinedRowLoop, ChoosesRuns, SkipsRows, JoinsDepth, StridedRun, MixesSegments
/// (pixel_by_pixel.hpp), and ChoosesEncodedColours for sinks. docs/add-a-shading-method.md has an example.
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

/// A run that consists of segments with linear colours. `begin()` gets the number of pixels; `enter()` steps
/// to the next segment and returns its length, at most the number of pixels left; `segment()` returns its
/// pixels.
template <class R>
concept SegmentedRun = requires(const R run) {
  { run.segment() } -> std::same_as<SegmentPixels>;
};
template <class R, class Lighting>
concept SegmentedRunOf = SegmentedRun<R> && requires(R run, const Lighting& lighting, std::int32_t count) {
  {run.begin(lighting, count)};
  { run.enter(lighting, count) } -> std::same_as<std::int32_t>;
};

/// Optional part of a run: begin() gets the lighting before the first pixel, for addresses that colour()
/// needs.
template <class R, class Lighting>
concept BeginsWithLighting = requires(R run, const Lighting& lighting) {
  {run.begin(lighting)};
};

/// A run that computes something anew in every piece of a row. enter() is called before each piece: it gets
/// the number of pixels left and returns the length of the piece, 1 up to that number.
template <class R, class Lighting>
concept PiecewiseRun = PixelRun<R, Lighting> && requires(R run, std::int32_t left) {
  { run.enter(left) } -> std::same_as<std::int32_t>;
};

/// Walks down the rows of a command. `row()` returns the run of the current row; `next_row()` steps down;
/// `enter_lower()` changes to the lower short edge. A walker may change the command's prepared part. Walkers
/// and runs belong to the span stage: they do not divide.
template <class W, class Lighting>
concept RowWalker = (PixelRun<typename W::Run, Lighting> ||
                     SegmentedRunOf<typename W::Run, Lighting>)&&requires(W walker, const RowStart& row) {
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
///   prepare() gets a TriangleFrame and may complete it (make_short_inverses()).
/// - `between`: the vertex at a fraction of an edge, for clipping. At 1/2 the result must not
///   depend on the order of the two ends.
/// - `walk`: static Status walk(Prepared&, draw) calls `draw` with a RowWalker and returns its status. The
///   type of the walker may depend on the triangle.
template <class M>
concept ShadingMethod = requires(const typename M::Lighting& lighting, const Direction& normal,
                                 const typename M::Vertex& vertex, const typename M::Face& face,
                                 TriangleFrame<M>& frame, typename M::Prepared& prepared, Factor fraction) {
  { M::shade_vertex(lighting, normal) } -> std::same_as<typename M::Vertex>;
  { M::shade_face(lighting, normal) } -> std::same_as<typename M::Face>;
  { M::between(vertex, vertex, fraction) } -> std::same_as<typename M::Vertex>;
  {M::prepare(lighting, frame, face, prepared)};
  { M::kNeedsFaceNormal } -> std::convertible_to<bool>;
};

/// Optional part of a run: `length()` is the number of pixels after which the row needs a new run, at
/// least 1.
template <class R>
concept LimitedRun = requires(const R run) {
  { run.length() } -> std::same_as<std::int32_t>;
};

/// Optional part of a method: its runs look up encoded colours in the table of span/encoded_colours.hpp where
/// there is one. All its runs except segments must then be EncodingRun.
template <class M>
concept UsesEncodedColours = bool{M::kUsesEncodedColours};

/// Optional part of a method: its Vertex depends on the directions of the lighting only, so that vertices
/// that are shaded with one material serve for others of the same type.
template <class M>
concept SharesVertices = std::is_empty_v<typename M::Vertex> || bool{M::kSharesVertices};

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
/// `Small` is the method's part of a small triangle. prepare_small(lighting, top, middle, bottom, is_medium,
/// triangle, small) makes it from three RasterVertex, sorted by height, and the SmallTriangle; it returns
/// false if the triangle has to be drawn by a TriangleCommand. is_dark_or_arcs(lighting, vertices)
/// tells of measured SortedVertices whether prepare_small() may take them as a medium triangle.
/// walk_small(small, draw) calls `draw` with a surface and returns its status. The surface's row(y, middle,
/// bottom) returns the run (PixelRun) of a row: `y` is the row's centre line (28.4), `middle` and `bottom`
/// are the barycentric coordinates of its first pixel, 16 fraction bits.
template <class M>
concept DrawsSmallTriangles = std::same_as<typename M::DrawsSmallTrianglesAs, M>;

/// Optional part of a method (`kDrawsEdges`): the edges of triangles are drawn as lines, not their areas
/// (Wireframe). Its Lighting has a `bias` (DepthBias).
template <class M>
concept DrawsEdges = bool{M::kDrawsEdges};

/// True if a triangle of this doubled_area() is not drawn: it shows its back, and backs are not drawn, or it
/// has no area, and no edges are drawn.
template <class M>
[[nodiscard]] ARCSPAN_INLINE_AT_OS constexpr bool is_culled_by_area(std::int32_t doubled, bool two_sided) {
  return doubled >= 0 && ((doubled == 0 && !DrawsEdges<M>) || !two_sided);
}

/// Optional part of a run, for methods that use encoded colours: `encoded<Format>(lighting, colours)` returns
/// the current pixel's colour encoded in `Format`, equal to Format::encode(colour(lighting)).
template <class R, class Format, class Lighting, class Colours>
concept EncodingRun = requires(const R& run, const Lighting& lighting, const Colours& colours) {
  { run.template encoded<Format>(lighting, colours) } -> std::same_as<typename Format::Encoded>;
};

/// Optional part of a run: light(lighting) returns the parts of colour(), for methods that reflect them
/// differently (Textured).
template <class R, class Lighting>
concept LightRun = requires(const R& run, const Lighting& lighting) {
  { run.light(lighting) } -> std::same_as<PixelLight>;
};

/// Optional part of a walker (`kOutlined`): few triangles need it and its set-up takes many registers, so its
/// rows and its runs become functions of their own.
template <class W>
concept OutlinedWalker = bool{W::kOutlined};

/// Optional part of a walker (`kOutlinesRowLoop`): its loop over the rows is a function of its own, which
/// contains its runs. For one of a method's many walkers, which would otherwise take registers from the
/// others.
template <class W>
concept OutlinedRowLoop = bool{W::kOutlinesRowLoop};

/// Optional part of a walker: with_run(start, lighting, draw) calls `draw` with the run of the current row
/// and returns its status. It is used instead of row() if the type of the run depends on the row.
template <class W, class Lighting>
concept ChoosesRuns = requires(const W walker, const RowStart& row, const Lighting& lighting) {
  walker.with_run(row, lighting, [](auto&) { return Status::kOk; });
};

/// Optional part of a walker, for pictures in bands: skip_rows(rows) steps down `rows` rows at once,
/// 0...2047. The result must be bit-identical to that of `rows` calls of next_row(). Other walkers are
/// stepped.
template <class W>
concept SkipsRows = requires(W walker, std::int32_t rows) {
  {walker.skip_rows(rows)};
};

/// Optional part of a run: it steps the depth together with its own values, and depth() is that of the
/// present pixel.
template <class R>
concept CarriesDepth = requires(const R run) {
  { run.depth() } -> std::same_as<Linear>;
};
/// Optional part of a walker: with_depth(plane) returns a walker for the same rows that steps the depth too,
/// and whose runs carry it. It is asked for if depths are tested, before the first row.
template <class W>
concept JoinsDepth = requires(const W walker, const LinearPlane& depth) {
  requires CarriesDepth<typename decltype(walker.with_depth(depth))::Run>;
};

/// Optional part of a run, needed inside segments: stride(bits) makes every following next() step 2^b pixels
/// and returns b, at most `bits`.
template <class R>
concept StridedRun = requires(R run, int bits) {
  { run.stride(bits) } -> std::same_as<int>;
};

/// Optional part of a sink: `kEncodedColours`, its own choice of ARCSPAN_ENCODED_COLOURS (0, 256 or 1024).
template <class S>
concept ChoosesEncodedColours = requires {
  { S::kEncodedColours } -> std::convertible_to<std::size_t>;
};

}  // namespace arcspan
