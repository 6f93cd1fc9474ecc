// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/arc/piece_lights.hpp>
#include <arcspan/shading/arc/row_pieces.hpp>
#include <arcspan/shading/arc/very_wide_triangle.hpp>
#include <arcspan/shading/arc/wide_triangle.hpp>
#include <arcspan/shading/patch/one_highlight.hpp>
#include <arcspan/shading/patch/patch_walker.hpp>
#include <arcspan/shading/restarted_run.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace arcspan {

/// The widest angle between normals of a triangle for which a program is made. Wider triangles are drawn,
/// too.
enum class WidestNormals : std::uint8_t {
  kAny,  ///< every triangle is shaded accurately
  /// Triangles beyond 60 degrees are shaded less accurately. Dark triangles that are not small, and triangles
  /// that one of several lights reaches in part, take longer. Saves 2.4 KB of code, 3.8 KB with two lights.
  k60Degrees,
  /// As k60Degrees. Besides, patches with a highlight are no wider than Illumination::widest_patch() and the
  /// triangle's shape allow, however faint it is: triangles from there to 30 degrees are drawn in pieces of
  /// rows, which takes longer than with k60Degrees. Saves another 0.4 KB.
  kWithinPatches,
};

/// True if triangles and pieces of rows that one of several grey lights reaches in part carry N·L of every
/// light where no highlight is within reach, and not all scalars (decision 28).
template <WidestNormals kWidest>
inline constexpr bool kMaySumLights = kWidest == WidestNormals::kAny;

/// The prepared part of a triangle whose normals are too far apart for a patch.
template <std::size_t Count, WidestNormals kWidest>
struct WideOrVeryWide {
  static constexpr bool kHasVeryWide = kWidest == WidestNormals::kAny;
  struct None {};
  union {
    WideTriangle<Count> wide;
    std::conditional_t<kHasVeryWide, VeryWideTriangle<Count>, None> very_wide;
  };
  Factor widest_piece;  ///< squared angle of a piece of a row, at most
  bool is_very_wide;
  bool middle_left;  ///< the middle vertex is on the left of the long edge
  bool in_lower;     ///< the current row is in the lower half; kept if is_very_wide
};

/// Sets up the first `used` scalars of a wide triangle, or all of a triangle beyond 60 degrees. `Frame` is a
/// TriangleFrame whose chords are measured and whose vertices are ArcVertex. `widest` is the squared angle of
/// the widest piece.
template <class Frame, std::size_t Count, WidestNormals kWidest>
constexpr void prepare_wide(Frame& frame, std::size_t used, Factor widest,
                            WideOrVeryWide<Count, kWidest>& triangle) {
  triangle.widest_piece = widest;
  triangle.middle_left = frame.middle_left;
  if constexpr (WideOrVeryWide<Count, kWidest>::kHasVeryWide) {
    triangle.is_very_wide = frame.chords.widest() > kWidestArc;
    if (triangle.is_very_wide) {
      triangle.in_lower = false;
      triangle.very_wide.prepare(frame);
      return;
    }
  }
  triangle.wide.prepare(frame, used);
}

/// The pixels of a piece of a row (RestartedRun); `Pixels` is a SecondDifferenceRun with colours.
template <class Pixels>
class PieceRun : public Pixels {
 public:
  /// Returns the number of pixels up to the end of the piece, at least 1.
  [[nodiscard]] constexpr std::int32_t length() const { return length_; }
  constexpr void set_length(std::int32_t length) { length_ = length; }

 private:
  std::int32_t length_ = INT32_MAX;
};

/// A piece of a row, from one of its pixels on.
template <std::size_t Count>
struct WidePiece {
  RowEnds<Count> ends;
  PieceColumn column;
  std::int32_t skipped;  ///< pixels of the piece that are not drawn
  std::int32_t length;   ///< pixels up to its end

  [[nodiscard]] ARCSPAN_INLINE constexpr PieceSteps steps() const { return piece_steps(column, ends.angle2); }
  /// Starts all scalars of `run` at the first pixel of the piece.
  template <class Run>
  ARCSPAN_INLINE constexpr void start(const PieceSteps& steps, Run& run) const {
    unrolled<Run::kUsed>([&](auto i) { start_scalar(steps, i, run, i); });
  }
  /// Starts scalar i of the piece as scalar `to` of `run`, at the first pixel of the piece.
  template <class Run>
  ARCSPAN_INLINE constexpr void start_scalar(const PieceSteps& steps, std::size_t i, Run& run,
                                             std::size_t to) const {
    run.start_at(to, parabola_of(steps, ends.left[i], ends.right[i]));
  }
  /// Starts the diffuse_scalar() as scalar 0 of `run`, at the first pixel of the piece.
  template <class Lighting, class Run>
  ARCSPAN_INLINE constexpr void start_diffuse(const PieceSteps& steps, const Lighting& lighting,
                                              std::uint32_t lit, Run& run) const {
    run.start_at(0, parabola_of(steps, lighting.diffuse_scalar(ends.left, lit),
                                lighting.diffuse_scalar(ends.right, lit)));
  }
};

/// Steps the scalars of both edges from row to row (RowWalker), and draws rows in pieces. It changes the
/// prepared triangle in place. `Pixels` uses the first Pixels::kUsed of its `Count` scalars.
template <class Pixels, std::size_t Count, WidestNormals kWidest = WidestNormals::kAny>
class WideWalker {
 public:
  using Run = RestartedRun<WideWalker, PieceRun<Pixels>>;
  using Prepared = WideOrVeryWide<Count, kWidest>;
  static constexpr std::size_t kUsed = Pixels::kUsed;
  constexpr explicit WideWalker(Prepared& triangle)
      : triangle_(&triangle), short_(&triangle.wide.upper_edge), rows_(&triangle.wide.upper_rows) {}

  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const { return Run(*this, start); }
  /// Returns the run of the piece in which a pixel lies, from this pixel on.
  [[nodiscard]] ARCSPAN_INLINE constexpr PieceRun<Pixels> start_run(const RowStart& start) const {
    const Piece piece = piece_at(start);
    return run_of<PieceRun<Pixels>>(piece, piece.steps());
  }

  constexpr void next_row() {
    if constexpr (Prepared::kHasVeryWide) {
      if (triangle_->is_very_wide) {
        triangle_->very_wide.skip_rows(1, triangle_->in_lower);
        return;
      }
    }
    triangle_->wide.long_edge.template advance<kUsed>();
    short_->template advance<kUsed>();
  }
  constexpr void enter_lower() {
    if constexpr (Prepared::kHasVeryWide) {
      if (triangle_->is_very_wide) {
        triangle_->in_lower = true;
        triangle_->very_wide.enter_lower();
      }
    }
    short_ = &triangle_->wide.lower_edge;
    rows_ = &triangle_->wide.lower_rows;
  }

 public:
  using Piece = WidePiece<Count>;

  /// Returns the run that begins at a pixel of a piece.
  template <class RunType>
  [[nodiscard]] ARCSPAN_INLINE static constexpr RunType run_of(const Piece& piece, const PieceSteps& steps) {
    RunType run;
    piece.start(steps, run);
    return started(piece, run);
  }
  /// Moves a run from the first pixel of a piece to the first that is drawn, and returns it.
  template <class RunType>
  ARCSPAN_INLINE static constexpr RunType& started(const Piece& piece, RunType& run) {
    if (piece.skipped != 0) run.skip(piece.skipped);
    run.set_length(piece.length);
    return run;
  }

  /// Returns the piece in which a pixel lies.
  [[nodiscard]] ARCSPAN_INLINE constexpr Piece piece_at(const RowStart& start) const {
    Piece piece;
    if (kHasFastRow && !is_very_wide()) {
      piece.ends.angle2 = rows_->squared(short_->fraction.factor());
      if (is_one_piece(piece.ends.angle2, triangle_->widest_piece, start)) {
        set_ends(piece.ends);
        piece.column = {start.fraction, start.width, 16};
        piece.skipped = start.skipped;
        piece.length = INT32_MAX;
        return piece;
      }
    }
    // The address of `piece` is not passed on, so that it can be in registers.
    RowPixel pixel{start.inside, start.width, start.bits};
    Piece one_of_several;
    set_piece(pixel, one_of_several);
    unrolled<kUsed>([&](auto i) {
      piece.ends.left[i] = one_of_several.ends.left[i];
      piece.ends.right[i] = one_of_several.ends.right[i];
    });
    piece.ends.angle2 = one_of_several.ends.angle2;
    piece.column = one_of_several.column;
    piece.skipped = one_of_several.skipped;
    piece.length = one_of_several.length;
    return piece;
  }

 private:
  /// Sets the scalars at both ends of the current row.
  ARCSPAN_INLINE constexpr void set_ends(RowEnds<Count>& ends) const {
    const ArcEdge<Count>& left = triangle_->middle_left ? *short_ : triangle_->wide.long_edge;
    const ArcEdge<Count>& right = triangle_->middle_left ? triangle_->wide.long_edge : *short_;
    const std::int32_t left_excess = left.excess();
    const std::int32_t right_excess = right.excess();
    unrolled<kUsed>([&](auto i) {
      ends.left[i] = left.at(i, left_excess);
      ends.right[i] = right.at(i, right_excess);
    });
  }

  /// Sets `piece` to the one of several pieces of a row in which `start` lies; it changes `start`.
  ARCSPAN_OUTLINE constexpr void set_piece(RowPixel& start, Piece& piece) const {
    RowEnds<Count>& ends = piece.ends;
    piece.length = INT32_MAX;
    if (is_very_wide()) {
      if constexpr (Prepared::kHasVeryWide) {
        piece.length = triangle_->very_wide.template row<kUsed>(triangle_->middle_left, start, ends);
      }
    } else {
      ends.angle2 = rows_->squared(short_->fraction.factor());
      set_ends(ends);
    }
    const RowPiece part = piece_of_row(start, halvings_of(ends.angle2, triangle_->widest_piece, start));
    narrow_to<kUsed>(part, ends);
    piece.column = column_of(part);
    if (part.length < piece.length) piece.length = part.length;
    piece.skipped = static_cast<std::int32_t>(part.inside >> part.bits);
  }

  /// Programs that are optimised for size have one function for all rows.
  static constexpr bool kHasFastRow = !kOptimisedForSize;

  [[nodiscard]] constexpr bool is_very_wide() const {
    return Prepared::kHasVeryWide && triangle_->is_very_wide;
  }

  Prepared* triangle_;
  ArcEdge<Count>* short_;
  RowAngles* rows_;
};

}  // namespace arcspan
