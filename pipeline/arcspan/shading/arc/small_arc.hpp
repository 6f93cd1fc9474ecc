// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/reciprocal.hpp>
#include <arcspan/prepare/small_triangle.hpp>
#include <arcspan/shading/arc/arc_vertex.hpp>
#include <arcspan/shading/patch/patch_walker.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// The three vertices of a small triangle, sorted by height.
template <class Raster>
struct SmallCorners {
  const Raster& a;
  const Raster& b;
  const Raster& c;
};
template <class Raster>
SmallCorners(const Raster&, const Raster&, const Raster&) -> SmallCorners<Raster>;

/// Points of an arc from A to B. With D = B - A, t the fraction of the arc, p = t (1 - t) and s the squared
/// chord, S0 eq. 2 is the sum of both ends with weights that exceed 1 together:
///
///     A + w D + e A,     e = p (rise + bend p),     w = t + e (11/32 + 5/16 t),
///
/// with rise and bend fitted in s so that points lie on the circle: within 6e-6 up to 60 degrees, because a
/// sharp highlight shows the length of a normal. Along the circle the error is below 6e-5 up to 30 degrees
/// and 2e-4 up to 60.
///
/// Without highlight bend is left out (`kForHighlights` false), and points are within 2e-4 of the circle up
/// to 45 degrees and 7e-4 at 60.
template <bool kForHighlights>
class ArcSeries {
 public:
  ArcSeries() = default;  // without values, so that a union may hold one
  /// `chord`: the squared chord s, 15 fraction bits, 0...1.
  ARCSPAN_OUTLINE_IF_TIGHT constexpr explicit ArcSeries(std::int32_t chord) {
    const auto s = static_cast<std::uint32_t>(chord);
    std::uint32_t rise = 0;
    if constexpr (!kForHighlights) {
      // s (0.500544 + 0.087609 s + 0.027846 s^2)
      rise = (s * (65607u + ((s * (11483u + ((s * 3650u) >> 15))) >> 15))) >> 15;
    } else {
      // s (0.499956 + 0.083895 s + 0.01464 s^2 + 0.006024 s^3), s^2 (0.04191 + 0.010344 s + 0.004797 s^2)
      const std::uint32_t inner = 10996u + ((s * (1919u + ((s * 790u) >> 15))) >> 15);
      rise = (s * (65530u + ((s * inner) >> 15)) + (1u << 14)) >> 15;
      bend_ = static_cast<std::int32_t>(
          (((s * s) >> 15) * (5493u + ((s * (1356u + ((s * 629u) >> 15))) >> 15))) >> 15);
    }
    rise_ = static_cast<std::int32_t>(rise);
  }

  /// Returns e with 17 fraction bits. `t` has 13; it may be outside of 0...1 by a rounding error.
  [[nodiscard]] ARCSPAN_OUTLINE_IF_TIGHT constexpr std::int32_t operator()(std::int32_t t) const {
    const std::int32_t p = (t * (8192 - t)) >> 10;  // 16 fraction bits, at most 1/4
    if constexpr (!kForHighlights) return (p * rise_) >> 16;
    return (p * (rise_ + ((bend_ * p) >> 16))) >> 16;
  }

 private:
  std::int32_t rise_;  ///< 17 fraction bits
  std::int32_t bend_;
};

/// A point of an arc. Its t is rounded down to 13 bits, which moves it along the circle by at most 1.3e-4.
struct ArcPoint {
  std::int32_t excess;  ///< e, 17 fraction bits
  std::int32_t weight;  ///< w, 15 fraction bits: of the end at t = 1

  template <class Series>
  ARCSPAN_INLINE constexpr ArcPoint(const Series& series, std::int32_t t)
      : excess(series(t)), weight(4 * t + ((excess * (2816 + (t >> 2) + (t >> 4))) >> 15)) {}

  /// Returns a scalar, of which `from` is A, `coarse` the same with 13 fraction bits and `change` is D with
  /// 15.
  [[nodiscard]] ARCSPAN_INLINE constexpr Cosine on(Cosine from, std::int32_t coarse,
                                                   std::int32_t change) const {
    return Cosine::from_raw(
        wrap_add(wrap_add(from.raw(), wrap_mul(weight, change)), wrap_mul(excess, coarse)));
  }
};

/// A scalar along an arc.
struct ScalarOfArc {
  Cosine from;
  std::int32_t coarse;
  std::int32_t change;

  ScalarOfArc() = default;
  ARCSPAN_INLINE constexpr ScalarOfArc(Cosine a, Cosine b)
      : from(a), coarse(a.raw() >> 17), change(change_between(a, b)) {}
  [[nodiscard]] ARCSPAN_INLINE constexpr Cosine at(const ArcPoint& point) const {
    return point.on(from, coarse, change);
  }
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::int32_t change_between(Cosine a, Cosine b) {
    return round_shift(wrap_sub(b.raw(), a.raw()), 15);
  }
};

/// The scalars of a triangle whose normals are up to 60 degrees apart: bilinear SLERP at every pixel, along
/// the two edges of a row and then along the row, as wide triangles are drawn (decision 23).
template <class Lighting, std::size_t Used>
class SmallArc {
 public:
  using Scalars = std::array<Cosine, Lighting::kScalars>;
  using Series = ArcSeries<Used == Lighting::kScalars>;

  /// The pixels of a row (PixelRun).
  class Run {
   public:
    static constexpr std::size_t kUsed = Used;

    [[nodiscard]] ARCSPAN_INLINE constexpr auto colour(const Lighting& lighting) const ->
        typename PatchRun<Lighting, Used>::Shade {
      return pixel().colour(lighting);
    }
    constexpr void next() { u_ += du_; }

   private:
    friend class SmallArc;

    [[nodiscard]] ARCSPAN_INLINE constexpr PatchRun<Lighting, Used> pixel() const {
      const ArcPoint point(series_, u_ >> kMoreBits);
      PatchRun<Lighting, Used> pixel;
      unrolled<Used>([&](auto i) { pixel.start_at(i, {scalars_[i].at(point), {}, {}}); });
      return pixel;
    }

    std::int32_t u_;  ///< fraction of the row from the long edge, 13 + kMoreBits fraction bits
    std::int32_t du_;
    Series series_;
    std::array<ScalarOfArc, Used> scalars_;
  };

  /// Prepares the first `Used` scalars of the vertices, which are sorted by height. The squared chords have
  /// 28 fraction bits.
  template <class Raster>
  constexpr void prepare(const SmallCorners<Raster>& at, const TriangleChords& chords,
                         const SmallTriangle& triangle) {
    const auto scaled = [](std::uint32_t chord) { return static_cast<std::int32_t>((chord + 4096u) >> 13); };
    const std::int32_t top_middle = scaled(chords.top_middle);
    const std::int32_t top_bottom = scaled(chords.top_bottom);
    const std::int32_t middle_bottom = scaled(chords.middle_bottom);
    const std::int32_t top_y = at.a.position.y;
    const std::int32_t bottom_y = at.c.position.y;
    middle_y_ = at.b.position.y;
    d_middle_ = triangle.d_middle;
    long_inverse_ = inverse_of(bottom_y - top_y);
    long_edge_ = Series(top_bottom);
    const std::int32_t first_y = triangle.row * 16 + 8;
    if (first_y < middle_y_) {
      upper_.prepare(top_y, middle_y_ - top_y, {top_middle, top_bottom, middle_bottom}, at.a.shade.scalars,
                     at.b.shade.scalars, at.c.shade.scalars);
    }
    if (first_y + (triangle.rows - 1) * 16 >= middle_y_) {
      lower_.prepare(bottom_y, bottom_y - middle_y_, {middle_bottom, top_bottom, top_middle},
                     at.c.shade.scalars, at.b.shade.scalars, at.a.shade.scalars);
    }
  }

  /// Returns the run of the row whose centre line is at `y` (28.4). It begins where the coordinate of the
  /// middle vertex is `middle`, 16 fraction bits.
  [[nodiscard]] constexpr Run row(std::int32_t y, std::int32_t middle, std::int32_t) const {
    const bool is_upper = y < middle_y_;
    const Half& half = is_upper ? upper_ : lower_;
    const std::int32_t away = is_upper ? y - half.corner_y : half.corner_y - y;
    const ArcPoint on_long(long_edge_, fraction(away, long_inverse_));
    const ArcPoint on_short(half.short_edge, fraction(away, half.inverse));
    Run run;
    unrolled<Used>([&](auto i) {
      const CornerScalar& scalar = half.scalars[i];
      run.scalars_[i] = ScalarOfArc(scalar.to_far.at(on_long),
                                    on_short.on(scalar.to_far.from, scalar.to_far.coarse, scalar.to_middle));
    });
    run.series_ = Series(half.row_chord(on_long, on_short));
    // The length of the middle row divided by that of this row: 15 fraction bits.
    const Reciprocal inverse = short_reciprocal(static_cast<std::uint32_t>(away));
    const std::uint32_t stretch =
        (static_cast<std::uint32_t>(half.height) * inverse.mantissa) >> (inverse.exponent - 15);
    run.u_ = static_cast<std::int32_t>((static_cast<std::uint32_t>(middle) * stretch) >> 3);
    run.du_ = wrap_mul(d_middle_, static_cast<std::int32_t>(stretch)) >> 3;
    return run;
  }

 private:
  static constexpr int kMoreBits = 15;

  /// Returns 2^31 / length; the length is at most kSmallSize pixels, below 512 sixteenths, as
  /// short_reciprocal() needs.
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::uint32_t inverse_of(std::int32_t length) {
    static_assert(kSmallSize * 16 < 512);
    const Reciprocal inverse = short_reciprocal(static_cast<std::uint32_t>(length));
    return inverse.mantissa << (31 - inverse.exponent);
  }
  /// Returns part / whole, at most 1, with 13 fraction bits.
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::int32_t fraction(std::int32_t part,
                                                                      std::uint32_t inverse_of_whole) {
    return static_cast<std::int32_t>((static_cast<std::uint32_t>(part) * inverse_of_whole) >> 18);
  }
  /// Squared chords, 15 fraction bits.
  struct HalfChords {
    std::int32_t corner_middle;
    std::int32_t corner_far;
    std::int32_t middle_far;
  };
  /// A scalar along both edges of the rows.
  struct CornerScalar {
    ScalarOfArc to_far;      ///< along the long edge
    std::int32_t to_middle;  ///< `change` along the short one
  };
  /// The rows between the middle vertex and the upper or the lower corner, from which arcs are measured.
  struct Half {
    std::int32_t corner_y;  ///< 4 fraction bits
    std::int32_t height;
    std::uint32_t inverse;  ///< of the height
    HalfChords chords;
    Series short_edge;
    std::array<CornerScalar, Used> scalars;

    /// `corner`, `middle` and `far` are the scalars of the corner, of the middle vertex and of the other
    /// corner.
    ARCSPAN_OUTLINE constexpr void prepare(std::int32_t y, std::int32_t rows, const HalfChords& squared,
                                           const Scalars& corner, const Scalars& middle, const Scalars& far) {
      corner_y = y;
      height = rows;
      inverse = inverse_of(rows);
      chords = squared;
      short_edge = Series(squared.corner_middle);
      for (std::size_t i = 0; i < Used; ++i) {
        scalars[i].to_far = ScalarOfArc(corner[i], far[i]);
        scalars[i].to_middle = ScalarOfArc::change_between(corner[i], middle[i]);
      }
    }

    /// Returns the squared chord between the normals at both ends of a row, 15 fraction bits. For unit
    /// vectors |sum k_i N_i|^2 = (sum k_i)^2 - sum k_i k_j |N_i - N_j|^2.
    [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t row_chord(const ArcPoint& on_long,
                                                                  const ArcPoint& on_short) const {
      const std::int32_t far = on_long.weight;
      const std::int32_t middle = -on_short.weight;
      const std::int32_t sum = (on_long.excess - on_short.excess) >> 2;
      const std::int32_t corner = sum - far - middle;
      const std::int32_t of_corner = (middle * chords.corner_middle + far * chords.corner_far) >> 15;
      const std::int32_t apart =
          wrap_add(wrap_mul(corner, of_corner), wrap_mul((middle * far) >> 15, chords.middle_far));
      const std::int32_t chord = wrap_sub(sum * sum, apart) >> 15;
      return chord < 0 ? 0 : chord;  // may exceed 1 by rounding; ArcSeries bears up to 1.4
    }
  };

  std::int32_t middle_y_;  ///< 4 fraction bits
  std::int32_t d_middle_;  ///< change of its coordinate per pixel, 16 fraction bits
  std::uint32_t long_inverse_;
  Series long_edge_;
  Half upper_;  ///< set if the triangle has such rows
  Half lower_;
};

}  // namespace arcspan
