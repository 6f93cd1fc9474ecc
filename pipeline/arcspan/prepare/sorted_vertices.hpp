// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/input_vertex.hpp>
#include <arcspan/target.hpp>

#include <concepts>
#include <cstdint>

/// The vertices of a triangle, sorted by height: the first step of its preparation.
namespace arcspan {

/// Squared chords |Ni - Nj|^2 between the normals at the ends of a triangle's edges, 28 fraction bits.
struct TriangleChords {
  std::uint32_t top_middle;
  std::uint32_t top_bottom;
  std::uint32_t middle_bottom;

  [[nodiscard]] ARCSPAN_INLINE_AT_OS constexpr std::uint32_t widest() const {
    const std::uint32_t upper = top_middle > top_bottom ? top_middle : top_bottom;
    return upper > middle_bottom ? upper : middle_bottom;
  }
  [[nodiscard]] constexpr std::uint32_t sum() const { return top_middle + top_bottom + middle_bottom; }
};

template <class Method>
struct SortedVertices;

/// Optional part of a method: chords_of() measures the chords between the normals once per triangle.
template <class M>
concept MeasuresChords = requires(const SortedVertices<M>& vertices) {
  { M::chords_of(vertices) } -> std::same_as<TriangleChords>;
};

/// The vertices of a triangle with an area. Small and large triangles begin with them, so that a triangle is
/// sorted and measured once however it is drawn.
template <class Method>
struct SortedVertices {
  const RasterVertex<Method>* top;
  const RasterVertex<Method>* middle;
  const RasterVertex<Method>* bottom;
  bool middle_left;       ///< the middle vertex is on the left of the long edge
  TriangleChords chords;  ///< set by measure_chords() if the method is one that MeasuresChords

  /// Assigns member by member, because a call of memcpy costs more on cores with few registers.
  constexpr void become(const SortedVertices& other) {
    top = other.top;
    middle = other.middle;
    bottom = other.bottom;
    middle_left = other.middle_left;
    if constexpr (MeasuresChords<Method>) {
      chords.top_middle = other.chords.top_middle;
      chords.top_bottom = other.chords.top_bottom;
      chords.middle_bottom = other.chords.middle_bottom;
    }
  }
};

namespace detail {

/// Swaps two vertices if `lower` is the higher one. That turns the triangle over, and so `middle_left`.
template <class Method>
ARCSPAN_INLINE_AT_OS constexpr void order_by_height(const RasterVertex<Method>*& upper,
                                                    const RasterVertex<Method>*& lower, bool& middle_left) {
  if (lower->position.y < upper->position.y) {
    const RasterVertex<Method>* const held = upper;
    upper = lower;
    lower = held;
    middle_left = !middle_left;
  }
}

/// Sorts three vertices. On entry: `middle_left` is true if doubled_area() of top, middle and bottom is
/// negative; on return: if the middle vertex is on the left of the long edge.
template <class Method>
ARCSPAN_OUTLINE_IF_TIGHT constexpr void sort_by_height(SortedVertices<Method>& vertices) {
  const RasterVertex<Method>* top = vertices.top;
  const RasterVertex<Method>* middle = vertices.middle;
  const RasterVertex<Method>* bottom = vertices.bottom;
  bool middle_left = vertices.middle_left;
  order_by_height<Method>(top, middle, middle_left);
  order_by_height<Method>(middle, bottom, middle_left);
  order_by_height<Method>(top, middle, middle_left);
  vertices.top = top;
  vertices.middle = middle;
  vertices.bottom = bottom;
  vertices.middle_left = middle_left;
}

/// Measures the chords between the normals if the method needs them.
template <class Method>
ARCSPAN_OUTLINE_IF_TIGHT constexpr void measure_chords(SortedVertices<Method>& vertices) {
  if constexpr (MeasuresChords<Method>) vertices.chords = Method::chords_of(vertices);
}

}  // namespace detail

}  // namespace arcspan
