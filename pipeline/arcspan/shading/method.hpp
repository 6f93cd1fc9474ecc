// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/colour.hpp>
#include <arcspan/pixel/colour_segment.hpp>
#include <arcspan/prepare/row_start.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/status.hpp>

#include <concepts>
#include <cstdint>

namespace arcspan {

/// What a run gives of a pixel's colour.
template <class C>
concept RunColour = std::same_as<C, PackedRgb> || PackableColour<C>;

/// The pixels of a row from left to right: `colour` of the one that it stands on, `next` goes on.
template <class R, class Lighting>
concept PixelRun = requires(R run, const Lighting& lighting) {
  { run.colour(lighting) } -> RunColour;
  {run.next()};
};

/// The same in segments between which colours are linear: `begin` is told the number of pixels, `enter` goes
/// into the next segment and returns how many of the pixels left it has, `segment` gives its pixels.
template <class R>
concept SegmentedRun = requires(const R run) {
  { run.segment() } -> std::same_as<SegmentPixels>;
};
template <class R, class Lighting>
concept SegmentedRunOf = SegmentedRun<R> && requires(R run, const Lighting& lighting, std::int32_t count) {
  {run.begin(lighting, count)};
  { run.enter(lighting, count) } -> std::same_as<std::int32_t>;
};

/// Goes down the rows of a command: `row` gives the `Run` that makes the colours of a row's pixels from left
/// to right, of kLongestRun at most, `next_row` steps down, `enter_lower` changes to the lower edge. It may
/// use the prepared part up. Everything in it and in `Run` is span stage: no division.
template <class W, class Lighting>
concept RowWalker = (PixelRun<typename W::Run, Lighting> ||
                     SegmentedRunOf<typename W::Run, Lighting>)&&requires(W walker, const RowStart& row) {
  { walker.row(row) } -> std::same_as<typename W::Run>;
  {walker.next_row()};
  {walker.enter_lower()};
  { W::kLongestRun } -> std::convertible_to<std::int32_t>;
};

/// A way of shading triangles, chosen at compile time: one file each, and a firmware holds only the ones it
/// names.
///
/// `Lighting` is what it needs of the object's illumination, `Face` of a face, `Vertex` of a vertex;
/// `Prepared` is its part of the triangle command. `walk` calls a function object with a RowWalker on it, of
/// one type or of the one that suits the triangle, and returns its status.
template <class M>
concept ShadingMethod = requires(const typename M::Lighting& lighting, const Direction& normal,
                                 const typename M::Vertex& vertex, const typename M::Face& face,
                                 const TriangleFrame<M>& frame, typename M::Prepared& prepared,
                                 Factor fraction) {
  { M::shade_vertex(lighting, normal) } -> std::same_as<typename M::Vertex>;
  { M::shade_face(lighting, normal) } -> std::same_as<typename M::Face>;
  { M::between(vertex, vertex, fraction) } -> std::same_as<typename M::Vertex>;
  { M::too_wide(vertex, vertex) } -> std::same_as<bool>;
  {M::prepare(lighting, frame, face, prepared)};
  { M::kNeedsFaceNormal } -> std::convertible_to<bool>;
};

}  // namespace arcspan
