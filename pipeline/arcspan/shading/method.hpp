// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/triangle.hpp>

#include <concepts>
#include <cstdint>

namespace arcspan {

/// A row of a triangle as its method's walker gets it.
struct RowStart {
  /// From the left edge to the first pixel's centre, in pixels with 16 fraction bits.
  std::uint32_t fraction;
  /// The same distance and the whole row's length, at least 1, both with `bits` fraction bits: 16, or 32 for
  /// rows shorter than a pixel.
  std::uint32_t inside;
  std::uint32_t width;
  int bits;
};

/// A way of shading triangles, chosen at compile time: one file each, and a firmware holds only the ones it
/// names.
///
/// `Object` is what it needs of the object's illumination, `Face` of a face, `Vertex` of a vertex; `Prepared`
/// is its part of the triangle command. A `Walker` goes down the rows of a command: `row` gives the `Run`
/// that makes the colours of a row's pixels from left to right, of kLongestRun at most, `next_row` steps
/// down, `enter_lower` changes to the lower edge. It may use the prepared part up. Everything in `Walker` and
/// `Run` is span stage: no division.
template <class M>
concept ShadingMethod = requires(const typename M::Object& object, const Direction& normal,
                                 const typename M::Vertex& vertex, const typename M::Face& face,
                                 const TriangleFrame<M>& frame, typename M::Prepared& prepared,
                                 typename M::Walker walker, typename M::Run run, const RowStart& row,
                                 Factor fraction) {
  { M::shade_vertex(object, normal) } -> std::same_as<typename M::Vertex>;
  { M::shade_face(object, normal) } -> std::same_as<typename M::Face>;
  { M::between(vertex, vertex, fraction) } -> std::same_as<typename M::Vertex>;
  { M::too_wide(vertex, vertex) } -> std::same_as<bool>;
  {M::prepare(frame, face, prepared)};
  {typename M::Walker(prepared)};
  { walker.row(row) } -> std::same_as<typename M::Run>;
  {walker.next_row()};
  {walker.enter_lower()};
  { run.colour(object) } -> std::same_as<PackedRgb>;
  {run.next()};
  { M::kNeedsFaceNormal } -> std::convertible_to<bool>;
};

}  // namespace arcspan
