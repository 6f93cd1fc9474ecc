// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/literature/inverse_width.hpp>
#include <arcspan/literature/recurrence_rows.hpp>
#include <arcspan/literature/row_in_pieces.hpp>
#include <arcspan/literature/row_pixel.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/shading/surface/chords.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstdint>

namespace arcspan {

/// A triangle whose `Count` scalars follow great circles: the arcs of the edges, each at its first row, and
/// the rows of the upper and the lower half. An edge or a half without rows to draw is not set.
template <std::size_t Count>
struct RecurrenceTriangle {
  RecurrenceEdge<Count> long_edge;
  RecurrenceEdge<Count> upper_edge;
  RecurrenceEdge<Count> lower_edge;
  RecurrenceRows upper_rows;
  RecurrenceRows lower_rows;
  std::uint8_t slope_drop;  ///< slope_drop() of the rows
  AngleFormat rows;         ///< format of the rows' squared angles
  bool middle_left;         ///< the middle vertex is on the left of the long edge
};

namespace detail {

/// Sets up the rows of both halves.
template <class Frame, std::size_t Count>
constexpr void prepare_recurrence_rows(const Frame& frame, RecurrenceTriangle<Count>& arcs) {
  const NormalChords& chords = frame.chords;
  const AngleFormat format = arcs.rows;
  const SquaredAngle top_middle = scaled_chord(chords.top_middle, format);
  const SquaredAngle top_bottom = scaled_chord(chords.top_bottom, format);
  const SquaredAngle middle_bottom = scaled_chord(chords.middle_bottom, format);
  CornerChords corner{top_middle, top_bottom, middle_bottom};
  const SquaredAngle at_middle = row_angle_at_middle(corner, format, frame.middle_fraction);
  if (frame.has_upper) {
    const SquaredAngle at_top = row_angle_at_corner(corner, format, frame.middle_fraction);
    make_recurrence_rows(at_top, at_middle, format, inverse_width(frame), frame.upper_edge, true,
                         arcs.upper_rows);
  }
  if (frame.has_lower) {
    corner = {middle_bottom, top_bottom, top_middle};
    const SquaredAngle at_bottom =
        row_angle_at_corner(corner, format, Factor::of(1.0) - frame.middle_fraction);
    make_recurrence_rows(at_bottom, at_middle, format, inverse_width(frame), frame.lower_edge, false,
                         arcs.lower_rows);
  }
}

}  // namespace detail

/// Sets up the arcs of a triangle. `Frame` is a TriangleFrame whose chords are measured and whose vertices
/// have `scalars`.
template <class Frame, std::size_t Count>
ARCSPAN_OUTLINE constexpr void prepare_recurrence(Frame& frame, RecurrenceTriangle<Count>& arcs) {
  const NormalChords& chords = frame.chords;
  const auto& top = frame.top->shade.scalars;
  const auto& middle = frame.middle->shade.scalars;
  const auto& bottom = frame.bottom->shade.scalars;
  make_recurrence_edge(frame.long_edge, chords.top_bottom, top, bottom, Count, arcs.long_edge);
  if (frame.has_upper)
    make_recurrence_edge(frame.upper_edge, chords.top_middle, top, middle, Count, arcs.upper_edge);
  if (frame.has_lower)
    make_recurrence_edge(frame.lower_edge, chords.middle_bottom, middle, bottom, Count, arcs.lower_edge);
  const std::uint32_t widest = chords.widest();
  arcs.slope_drop = static_cast<std::uint8_t>(slope_drop(widest));
  arcs.rows = angle_format(widest);
  detail::prepare_recurrence_rows(frame, arcs);
  arcs.middle_left = frame.middle_left;
}

/// The pixels of a row, whose scalars the recurrence steps.
template <class Lighting>
class RecurrenceRun {
 public:
  static constexpr std::size_t kScalars = Lighting::kScalars;

  /// Rounding of the recurrence adds up to m^2 / 4 units of 2^-30 over m pixels, 1.5e-5 over 256. A longer
  /// row is drawn in several pieces.
  [[nodiscard]] static constexpr std::int32_t length() { return 256; }

  RecurrenceRun() = default;
  constexpr RecurrenceRun(std::int32_t mantissa, std::int32_t shift) : mantissa_(mantissa), shift_(shift) {}

  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb colour(const Lighting& lighting) const {
    typename Lighting::Scalars values;
    unrolled<kScalars>([&](auto i) { values[i] = scalars_[i].x; });
    return lighting.colour(values);
  }
  [[nodiscard]] constexpr RecurrenceScalar& scalar(std::size_t i) { return scalars_[i]; }
  [[nodiscard]] constexpr const RecurrenceScalar& scalar(std::size_t i) const { return scalars_[i]; }
  [[nodiscard]] constexpr RecurrenceStep factor() const { return {mantissa_, shift_, 0}; }
  constexpr void next() {
    unrolled<kScalars>([this](auto i) { scalars_[i].step(mantissa_, shift_); });
  }

 private:
  std::array<RecurrenceScalar, kScalars> scalars_;
  std::int32_t mantissa_;
  std::int32_t shift_;
};

/// Steps the scalars of both edges of a half from row to row (RowWalker). It changes the prepared arcs in
/// place. `Pixels` are those of a row, made of a RecurrenceRun.
template <class Lighting, class Pixels = RecurrenceRun<Lighting>>
class RecurrenceWalker {
 public:
  static constexpr std::size_t kScalars = Lighting::kScalars;
  using Piece = Pixels;
  using Run = literature::RowInPieces<RecurrenceWalker>;

  constexpr explicit RecurrenceWalker(RecurrenceTriangle<kScalars>& arcs)
      : arcs_(&arcs), short_(&arcs.upper_edge), rows_(&arcs.upper_rows) {}

  [[nodiscard]] constexpr Run row(const RowStart& start) const { return Run(*this, start); }
  /// Returns the pixels of the current row from `start` on.
  [[nodiscard]] constexpr Piece piece(const RowStart& start) const {
    const Factor t = rows_->t.factor();
    const Factor t2 = multiply<Factor>(t, t);
    const SquaredAngle angle2 =
        multiply<SquaredAngle>(t2, SquaredAngle::from_raw(rows_->corner) +
                                       multiply<SquaredAngle>(t2, SquaredAngle::from_raw(rows_->rise)));
    const std::int32_t mantissa = wrap_add(rows_->k_corner, wrap_mul(rows_->k_rise, t2.raw()) >> 15);

    const literature::RowPixel first = literature::row_pixel(start);
    const Reciprocal inverse = nonzero_reciprocal(first.width);
    const ArcFraction pixel = arc_fraction(inverse, first.bits);
    const ArcStart arc = arc_start(angle2, arcs_->rows, fraction_of_row(first, inverse), pixel.factor());
    const SlopeScale scale = slope_scale(pixel, arcs_->slope_drop, 0);

    const RecurrenceEdge<kScalars>& left = arcs_->middle_left ? *short_ : arcs_->long_edge;
    const RecurrenceEdge<kScalars>& right = arcs_->middle_left ? arcs_->long_edge : *short_;
    RecurrenceRun<Lighting> run(mantissa, rows_->k_shift);
    unrolled<kScalars>([&](auto i) {
      run.scalar(i) = start_scalar(arc, arcs_->rows, scale, left.scalars[i].x, right.scalars[i].x);
    });
    return Pixels{run};
  }

  constexpr void next_row() {
    arcs_->long_edge.template advance<kScalars>();
    short_->template advance<kScalars>();
    rows_->t.advance();
  }
  constexpr void enter_lower() {
    short_ = &arcs_->lower_edge;
    rows_ = &arcs_->lower_rows;
  }

 private:
  /// Returns the fraction of the row at a pixel, 0...1; `inverse` is the reciprocal of pixel.width.
  [[nodiscard]] static constexpr Factor fraction_of_row(const literature::RowPixel& pixel,
                                                        const Reciprocal& inverse) {
    const std::uint32_t inside = pixel.inside < pixel.width ? pixel.inside : pixel.width;
    const std::uint32_t normalised = inside
                                     << (47 - inverse.exponent);  // the shift that moves the width to bit 31
    return Factor::from_raw(static_cast<std::int32_t>(((normalised >> 16) * inverse.mantissa) >> 16));
  }

  RecurrenceTriangle<kScalars>* arcs_;
  RecurrenceEdge<kScalars>* short_;
  RecurrenceRows* rows_;
};

}  // namespace arcspan
