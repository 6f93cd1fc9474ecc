// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/root.hpp>
#include <arcspan/prepare/arc_rows.hpp>
#include <arcspan/shading/illumination.hpp>
#include <arcspan/shading/method.hpp>

#include <array>

namespace arcspan {

/// Spherical-angular Phong shading on scalars (S0 eq. 14): the products of the normal with L, H or V run
/// along great circles down the edges and along the rows, each by one multiply, one shift and sums a step.
template <class Illumination>
struct Arc {
  static constexpr std::size_t kScalars = Illumination::kScalars;
  using Scalars = std::array<Unit, kScalars>;
  using Object = Illumination;
  struct Face {};
  struct Vertex {
    Normal normal;
    Scalars scalars;
  };
  /// The edges' arcs, each at its first row, and the rows of the upper and the lower half.
  struct Prepared {
    ArcEdge<kScalars> long_edge;
    ArcEdge<kScalars> upper_edge;
    ArcEdge<kScalars> lower_edge;
    ArcRows upper_rows;
    ArcRows lower_rows;
    std::int32_t slope_drop;
    ArcClass rows;  ///< the format of the rows' angles
    bool middle_left;
  };
  /// The recurrence's rounding adds up to m^2 / 4 units of 2^-30: 1.5e-5 over 256 pixels, then the row starts
  /// anew.
  static constexpr std::int32_t kLongestRun = 256;
  static constexpr bool kNeedsFaceNormal = false;

  /// Normals farther apart than 60 degrees (squared chord 1) are not interpolated; the triangle is split.
  static constexpr std::uint32_t kWidestChord = 1u << 28;

  [[nodiscard]] static Vertex shade_vertex(const Object& object, const Direction& normal) {
    return {to_normal(normal), object.scalars(normal)};
  }
  [[nodiscard]] static constexpr Face shade_face(const Object&, const Direction&) { return {}; }
  [[nodiscard]] static constexpr bool too_wide(const Vertex& a, const Vertex& b) {
    return squared_chord(a.normal, b.normal) > kWidestChord;
  }

  /// The vertex at the fraction t of the arc from a to b. Wide arcs are halved until the series hold.
  [[nodiscard]] static constexpr Vertex between(const Vertex& a, const Vertex& b, Factor t) {
    Vertex from = a;
    Vertex to = b;
    constexpr Factor kHalf = Factor::of(0.5);
    for (int halvings = 0; halvings < 2 && too_wide(from, to); ++halvings) {
      const Vertex middle = middle_of(from, to);
      if (t == kHalf) return middle;  // exact, and the same from either end
      if (t < kHalf) {
        to = middle;
        t = t + t;
      } else {
        from = middle;
        t = t + t - Factor::of(1.0);
      }
    }
    return on_arc(from, to, t);
  }

  static constexpr void prepare(const TriangleFrame<Arc>& frame, const Face&, Prepared& prepared) {
    const Vertex& top = frame.top->shade;
    const Vertex& middle = frame.middle->shade;
    const Vertex& bottom = frame.bottom->shade;
    const Chords chords{squared_chord(top.normal, middle.normal), squared_chord(top.normal, bottom.normal),
                        squared_chord(middle.normal, bottom.normal)};
    make_arc_edge(frame.long_edge, chords.top_bottom, top.scalars, bottom.scalars, prepared.long_edge);
    if (frame.has_upper) {
      make_arc_edge(frame.upper_edge, chords.top_middle, top.scalars, middle.scalars, prepared.upper_edge);
    }
    if (frame.has_lower) {
      make_arc_edge(frame.lower_edge, chords.middle_bottom, middle.scalars, bottom.scalars,
                    prepared.lower_edge);
    }
    const std::uint32_t widest = chords.widest();
    prepared.slope_drop = arcspan::slope_drop(widest);
    prepared.rows = arc_class(widest);
    with_angle(prepared.rows, [&](auto angle) { prepare_rows<decltype(angle)>(frame, chords, prepared); });
    prepared.middle_left = frame.middle_left;
  }

  /// The scalars of a row's pixels.
  class Run {
   public:
    constexpr Run(std::int32_t mantissa, std::int32_t shift) : mantissa_(mantissa), shift_(shift) {}

    [[nodiscard]] constexpr PackedRgb colour(const Object& object) const {
      Scalars values;
      unrolled<kScalars>([&](auto i) { values[i] = scalars_[i].x; });
      return object.colour(values);
    }
    [[nodiscard]] constexpr ArcScalar& scalar(std::size_t i) { return scalars_[i]; }
    constexpr void next() {
      unrolled<kScalars>([this](auto i) { scalars_[i].step(mantissa_, shift_); });
    }

   private:
    std::array<ArcScalar, kScalars> scalars_;
    std::int32_t mantissa_;
    std::int32_t shift_;
  };

  /// Both edges' scalars, from row to row; walks the prepared edges in place.
  class Walker {
   public:
    constexpr explicit Walker(Prepared& prepared)
        : prepared_(&prepared), short_(&prepared.upper_edge), rows_(&prepared.upper_rows) {}

    [[nodiscard]] constexpr Run row(const RowStart& start) const {
      return with_angle(prepared_->rows, [&](auto angle) { return row_as<decltype(angle)>(start); });
    }

    constexpr void next_row() {
      prepared_->long_edge.advance();
      short_->advance();
      rows_->t = wrap_add(rows_->t, rows_->dt);
    }
    constexpr void enter_lower() {
      short_ = &prepared_->lower_edge;
      rows_ = &prepared_->lower_rows;
    }

   private:
    template <class Angle>
    [[nodiscard]] constexpr Run row_as(const RowStart& start) const {
      const Factor t = Factor::from_raw(rows_->t >> 15);
      const Factor t2 = multiply<Factor>(t, t);
      const Angle angle2 = multiply<Angle>(
          t2, Angle::from_raw(rows_->corner) + multiply<Angle>(t2, Angle::from_raw(rows_->rise)));
      const std::int32_t mantissa = wrap_add(rows_->k_corner, wrap_mul(rows_->k_rise, t2.raw()) >> 15);

      const Reciprocal inverse = reciprocal(start.width);
      const ArcFraction pixel = arc_fraction(inverse, start.bits);
      const ArcStart<Angle> arc = arc_start(angle2, fraction_of_row(start, inverse), pixel.factor());
      const SlopeScale scale = slope_scale(pixel, prepared_->slope_drop, 0);

      const ArcEdge<kScalars>& left = prepared_->middle_left ? *short_ : prepared_->long_edge;
      const ArcEdge<kScalars>& right = prepared_->middle_left ? prepared_->long_edge : *short_;
      Run run(mantissa, rows_->k_shift);
      unrolled<kScalars>(
          [&](auto i) { run.scalar(i) = start_scalar(arc, scale, left.scalars[i].x, right.scalars[i].x); });
      return run;
    }

    /// Where the row's first pixel is between its ends, 0...1; `inverse` is the width's reciprocal.
    [[nodiscard]] static constexpr Factor fraction_of_row(const RowStart& start, const Reciprocal& inverse) {
      const std::uint32_t inside = start.inside < start.width ? start.inside : start.width;
      const std::uint32_t normalised = inside << (47 - inverse.exponent);  // as the width has its bit 31 set
      return Factor::from_raw(static_cast<std::int32_t>(((normalised >> 16) * inverse.mantissa) >> 16));
    }

    Prepared* prepared_;
    ArcEdge<kScalars>* short_;
    ArcRows* rows_;
  };

 private:
  /// Squared chords of a triangle's edges, 28 fraction bits.
  struct Chords {
    std::uint32_t top_middle;
    std::uint32_t top_bottom;
    std::uint32_t middle_bottom;

    [[nodiscard]] constexpr std::uint32_t widest() const {
      const std::uint32_t upper = top_middle > top_bottom ? top_middle : top_bottom;
      return upper > middle_bottom ? upper : middle_bottom;
    }
  };

  template <class Angle>
  static constexpr void prepare_rows(const TriangleFrame<Arc>& frame, const Chords& chords,
                                     Prepared& prepared) {
    const Angle top_middle = chord_as<Angle>(chords.top_middle);
    const Angle top_bottom = chord_as<Angle>(chords.top_bottom);
    const Angle middle_bottom = chord_as<Angle>(chords.middle_bottom);
    const CornerChords<Angle> from_top{top_middle, top_bottom, middle_bottom};
    const CornerChords<Angle> from_bottom{middle_bottom, top_bottom, top_middle};
    const Angle at_middle = row_angle_at_middle(from_top, frame.middle_fraction);
    if (frame.has_upper) {
      const Angle at_top = row_angle_at_corner(from_top, frame.middle_fraction);
      make_arc_rows(at_top, at_middle, frame.inverse_width, frame.upper_edge, true, prepared.upper_rows);
    }
    if (frame.has_lower) {
      const Angle at_bottom = row_angle_at_corner(from_bottom, Factor::of(1.0) - frame.middle_fraction);
      make_arc_rows(at_bottom, at_middle, frame.inverse_width, frame.lower_edge, false, prepared.lower_rows);
    }
  }

  /// Middle of an arc by dichotomy: (a + b) / sqrt(2 + z), z = 2 a·b = 2 - s. Opposite normals have no middle
  /// and give the zero vector, which is dark.
  [[nodiscard]] static constexpr Vertex middle_of(const Vertex& a, const Vertex& b) {
    const Factor rest = Factor::of(4.0) - chord_as<Factor>(squared_chord(a.normal, b.normal));
    ReciprocalRoot root = reciprocal_root(static_cast<std::uint32_t>(rest.raw()));
    if (rest.raw() <= 64) root.mantissa = 0;
    // The root is of the raw value, 15 fraction bits up: 1/sqrt(value) = 2^7.5 / sqrt(raw), 46341 = 2^15.5.
    const auto scaled = [&root](std::int64_t sum) {
      const std::int64_t product = ((sum * root.mantissa) >> 8) * 46341;
      return (product + (std::int64_t{1} << (root.exponent - 1))) >> root.exponent;
    };
    const auto component = [&scaled](NormalComponent p, NormalComponent q) {
      return NormalComponent::from_raw(static_cast<std::int16_t>(scaled(std::int64_t{p.raw()} + q.raw())));
    };
    Vertex middle;
    middle.normal = {component(a.normal.x, b.normal.x), component(a.normal.y, b.normal.y),
                     component(a.normal.z, b.normal.z)};
    for (std::size_t i = 0; i < kScalars; ++i) {
      middle.scalars[i] = Unit::from_raw(
          static_cast<std::int32_t>(scaled(std::int64_t{a.scalars[i].raw()} + b.scalars[i].raw())));
    }
    return middle;
  }

  /// S0 eq. 2 at the fraction t of an arc of at most 60 degrees.
  [[nodiscard]] static constexpr Vertex on_arc(const Vertex& a, const Vertex& b, Factor t) {
    const Factor chord = chord_as<Factor>(squared_chord(a.normal, b.normal));
    const ArcStart<Factor> at = arc_start(angle_of_chord(chord), t, Factor{});
    const auto component = [&at](NormalComponent p, NormalComponent q) {
      const Factor middle = Factor::from_raw(p.raw() + q.raw());  // 14 bits summed: 15 bits of the mean
      const Factor rise = Factor::from_raw((q.raw() - p.raw()) * 2);
      const Factor sum = middle + multiply<Factor>(at.even, middle) + multiply<Factor>(at.odd, rise);
      return NormalComponent::from_raw(static_cast<std::int16_t>(round_shift(sum.raw(), 1)));
    };
    constexpr SlopeScale kWholeArc = slope_scale(ArcFraction{}, 15, 0);  // only x is wanted of start_scalar()
    Vertex point;
    point.normal = {component(a.normal.x, b.normal.x), component(a.normal.y, b.normal.y),
                    component(a.normal.z, b.normal.z)};
    for (std::size_t i = 0; i < kScalars; ++i) {
      point.scalars[i] = start_scalar(at, kWholeArc, a.scalars[i], b.scalars[i]).x;
    }
    return point;
  }
};

}  // namespace arcspan
