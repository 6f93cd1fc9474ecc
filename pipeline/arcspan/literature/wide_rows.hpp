// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/literature/row_in_pieces.hpp>
#include <arcspan/literature/very_wide_triangle.hpp>
#include <arcspan/literature/wide_triangle.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan::literature {

/// The pixels of a piece of a row; `Method::colour_of(lighting, scalars)` is their colour.
template <class Method, std::size_t Count>
struct ArcPiece : SecondDifferenceRun<Count> {
  std::int32_t pixels;  ///< up to the end of the piece

  [[nodiscard]] constexpr std::int32_t length() const { return pixels; }
  template <class Lighting>
  [[nodiscard]] constexpr auto colour(const Lighting& lighting) const {
    return Method::colour_of(lighting, this->scalars());
  }
};

/// Walks down the rows of a triangle and draws them in pieces (RowWalker). It changes the prepared triangle
/// in place. `Triangle` is a WideTriangle or a VeryWideTriangle of `Count` scalars.
template <class Method, template <std::size_t> class Triangle, std::size_t Count>
class WideWalker {
 public:
  using Piece = ArcPiece<Method, Count>;
  using Run = RowInPieces<WideWalker>;

  constexpr explicit WideWalker(Triangle<Count>& triangle) : triangle_(&triangle) {}

  [[nodiscard]] constexpr Run row(const RowStart& start) const { return Run(*this, start); }
  /// Returns the pixels of the current row from `start` to the end of its piece.
  [[nodiscard]] ARCSPAN_OUTLINE constexpr Piece piece(const RowStart& start) const {
    RowPixel pixel = row_pixel(start);
    RowEnds<Count> ends;
    const std::int32_t to_part_end = triangle_->row(pixel, ends);
    const RowPiece part = piece_of_row(pixel, halvings_of(ends.angle2, triangle_->widest_piece, pixel));
    narrow_to(part, ends);
    const PieceSteps steps = PieceSteps::of(part, ends.angle2);
    Piece piece;
    unrolled<Count>([&](auto i) { piece.of[i] = parabola_of(steps, ends.left[i], ends.right[i]); });
    piece.skip(static_cast<std::int32_t>(part.inside >> part.bits));
    piece.pixels = part.length < to_part_end ? part.length : to_part_end;
    return piece;
  }
  constexpr void next_row() { triangle_->next_row(); }
  constexpr void enter_lower() { triangle_->enter_lower(); }

 private:
  Triangle<Count>* triangle_;
};

/// The prepared part of a method that follows arcs of up to 60 degrees: `Narrow`, or for wider triangles the
/// rows of `wide`. `Count` is the number of scalars of its vertices, which are ArcVertex.
template <class Narrow, std::size_t Count>
struct NarrowOrWide {
  union {
    Narrow narrow;
    VeryWideTriangle<Count> wide;
  };
  bool is_wide;

  /// Prepares `wide` and returns true if the triangle is more than 60 degrees wide; its pieces are of at most
  /// 16 degrees, which are within 1.4e-4 of the arc. Otherwise `narrow` is to be prepared.
  template <class Frame>
  [[nodiscard]] constexpr bool prepare_if_wide(Frame& frame) {
    is_wide = frame.chords.widest() > kWidestArc;
    if (is_wide) wide.prepare(frame, Factor::of(0.078));
    return is_wide;
  }
};

/// The walker of `wide` in NarrowOrWide.
template <class Method, std::size_t Count>
using VeryWideWalker = WideWalker<Method, VeryWideTriangle, Count>;

}  // namespace arcspan::literature
