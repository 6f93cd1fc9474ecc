// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/arc/wide_walker.hpp>

#include <cstddef>

namespace arcspan {

/// The prepared part of a method that follows arcs of up to 60 degrees: `Narrow`, or for wider triangles the
/// rows of Arc. `Count` is the number of scalars of its vertices, which are ArcVertex.
template <class Narrow, std::size_t Count>
struct NarrowOrWide {
  union {
    Narrow narrow;
    WideOrVeryWide<Count, WidestNormals::kAny> wide;
  };
  bool is_wide;

  /// Prepares `wide` and returns true if the triangle is more than 60 degrees wide; its pieces are of at most
  /// 16 degrees, which are within 1.4e-4 of the arc. Otherwise `narrow` is to be prepared.
  template <class Frame>
  [[nodiscard]] constexpr bool prepare_if_wide(Frame& frame) {
    is_wide = frame.chords.widest() > kWidestArc;
    if (is_wide) prepare_wide(frame, Count, Factor::of(0.078), wide);
    return is_wide;
  }
};

/// The pixels of a row of such a wide triangle; `Method::colour_of(lighting, scalars)` is their colour.
template <class Method, std::size_t Count>
struct CarriedRun : SecondDifferenceRun<Count> {
  static constexpr std::size_t kUsed = Count;
  template <class Lighting>
  [[nodiscard]] constexpr PackedRgb colour(const Lighting& lighting) const {
    return Method::colour_of(lighting, this->scalars());
  }
};

}  // namespace arcspan
