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

/// The differences between the weights of an arc's two ends and those of its chord. The point at the fraction
/// t of an arc of the angle psi is (S0 eq. 2)
///
///     sin((1 - t) psi) / sin(psi) A + sin(t psi) / sin(psi) B,
///     sin(t psi) / sin(psi) = t + t (1 - t^2) (rise - bend t^2)
///
/// with series in the squared chord s. The error is below 2^-16 up to 30 degrees and 2^-13 up to 60.
class ArcExcess {
 public:
  ArcExcess() = default;  // without values, so that a union may hold one
  /// `s`: the squared chord, 15 fraction bits, 0...1.
  ARCSPAN_OUTLINE_IF_SMALL constexpr explicit ArcExcess(std::int32_t s) {
    // 1/6, 1/30, 1/140, 1/630 and more; 1/120 and 13/5040, 17 fraction bits.
    const std::int32_t inner = 4369 + ((s * (936 + ((s * 275) >> 15))) >> 15);
    rise_ = (s * (21845 + ((s * inner) >> 15))) >> 15;
    bend_ = (((s * s) >> 15) * (1092 + ((s * 338) >> 15))) >> 15;
  }

  /// Returns the excess of the end that is reached at t = 1: 18 fraction bits. `t` has 15.
  [[nodiscard]] ARCSPAN_INLINE_UNLESS_SMALL constexpr std::int32_t operator()(std::int32_t t) const {
    const std::int32_t t2 = (t * t) >> 15;
    const std::int32_t cubic = (t * (32768 - t2)) >> 13;  // 17 fraction bits, below 0.385
    return (cubic * (rise_ - ((bend_ * t2) >> 15))) >> 16;
  }

 private:
  std::int32_t rise_;  ///< 17 fraction bits
  std::int32_t bend_;
};

/// A point of an arc: the fraction t and the excesses of both ends.
struct ArcPoint {
  std::int32_t t;     ///< 15 fraction bits
  std::int32_t from;  ///< excess of the end at t = 0, 18 fraction bits
  std::int32_t to;

  ARCSPAN_INLINE_UNLESS_SMALL constexpr ArcPoint(const ArcExcess& excess, std::int32_t fraction)
      : t(fraction), from(excess(32768 - fraction)), to(excess(fraction)) {}

  /// Returns a scalar at this point from its values at the ends.
  [[nodiscard]] ARCSPAN_INLINE_UNLESS_SMALL constexpr Cosine between(Cosine a, Cosine b) const {
    const std::int32_t straight =
        wrap_add(a.raw(), scaled_down(wrap_sub(b.raw(), a.raw()), static_cast<std::uint32_t>(t), 15));
    const std::int32_t above =
        wrap_add(wrap_mul(from, round_shift(a.raw(), 15)), wrap_mul(to, round_shift(b.raw(), 15)));
    return Cosine::from_raw(wrap_add(straight, above >> 3));
  }
  /// Returns the weights of both ends, 15 fraction bits.
  [[nodiscard]] constexpr std::int32_t weight_from() const { return 32768 - t + (from >> 3); }
  [[nodiscard]] constexpr std::int32_t weight_to() const { return t + (to >> 3); }
};

/// The scalars of a small triangle whose normals are up to 60 degrees apart: bilinear SLERP at every pixel,
/// along the two edges of a row and then along the row, as wide triangles are drawn (decision 23).
template <class Lighting, std::size_t Used>
class SmallArc {
 public:
  /// The pixels of a row (PixelRun).
  class Run {
   public:
    static constexpr std::size_t kUsed = Used;

    [[nodiscard]] ARCSPAN_INLINE constexpr auto colour(const Lighting& lighting) const ->
        typename PatchRun<Lighting, Used>::Shade {
      return pixel().colour(lighting);
    }
    template <class Format, class Colours>
    [[nodiscard]] ARCSPAN_INLINE constexpr typename Format::Encoded encoded(const Lighting& lighting,
                                                                            const Colours& encoded) const {
      return pixel().template encoded<Format>(lighting, encoded);
    }
    constexpr void next() { u_ += du_; }

   private:
    friend class SmallArc;

    [[nodiscard]] ARCSPAN_INLINE constexpr PatchRun<Lighting, Used> pixel() const {
      const std::int32_t u = u_ >> kMoreBits;
      const ArcPoint point(excess_, u < 0 ? 0 : u > 32768 ? 32768 : u);
      PatchRun<Lighting, Used> pixel;
      unrolled<Used>([&](auto i) { pixel.start_at(i, {point.between(on_long_[i], on_short_[i]), {}, {}}); });
      return pixel;
    }

    std::int32_t u_;  ///< fraction of the row from the long edge, 15 + kMoreBits fraction bits
    std::int32_t du_;
    ArcExcess excess_;
    std::array<Cosine, Used> on_long_;
    std::array<Cosine, Used> on_short_;
  };

  /// Prepares the first `Used` scalars. The squared chords have 28 fraction bits.
  constexpr void prepare(const std::array<const RasterPosition*, 3>& positions,
                         const std::array<const std::array<Cosine, Lighting::kScalars>*, 3>& scalars,
                         const std::array<std::uint32_t, 3>& opposite_chords, const SmallTriangle& triangle) {
    std::size_t top = positions[1]->y < positions[0]->y ? 1 : 0;
    std::size_t bottom = 1 - top;
    if (positions[2]->y < positions[top]->y) {
      top = 2;
    } else if (positions[2]->y >= positions[bottom]->y) {
      bottom = 2;
    }
    const std::size_t middle = 3 - top - bottom;
    // The coordinate of the middle vertex is base + of_b l_b + of_c l_c.
    base_ = middle == 0 ? 65536 : 0;
    of_b_ = middle == 0 ? -1 : middle == 1 ? 1 : 0;
    of_c_ = middle == 0 ? -1 : middle == 2 ? 1 : 0;
    d_middle_ = of_b_ * triangle.db + of_c_ * triangle.dc;
    top_y_ = positions[top]->y;
    middle_y_ = positions[middle]->y;
    bottom_y_ = positions[bottom]->y;
    const auto scaled = [](std::uint32_t chord) { return static_cast<std::int32_t>((chord + 4096u) >> 13); };
    top_middle_ = scaled(opposite_chords[bottom]);
    top_bottom_ = scaled(opposite_chords[middle]);
    middle_bottom_ = scaled(opposite_chords[top]);
    long_edge_ = ArcExcess(top_bottom_);
    upper_edge_ = ArcExcess(top_middle_);
    lower_edge_ = ArcExcess(middle_bottom_);
    for (std::size_t i = 0; i < Used; ++i) {
      top_[i] = (*scalars[top])[i];
      middle_[i] = (*scalars[middle])[i];
      bottom_[i] = (*scalars[bottom])[i];
    }
  }

  /// Returns the run of the row whose centre line is at `y` (28.4). It begins at the barycentric coordinates
  /// l_b and l_c, 16 fraction bits, which are inside the triangle.
  [[nodiscard]] constexpr Run row(std::int32_t y, std::int32_t b, std::int32_t c) const {
    const ArcPoint on_long(long_edge_, fraction(y - top_y_, bottom_y_ - top_y_));
    const bool is_upper = y < middle_y_;
    const std::int32_t from_corner = is_upper ? y - top_y_ : bottom_y_ - y;
    const std::int32_t height = is_upper ? middle_y_ - top_y_ : bottom_y_ - middle_y_;
    const std::int32_t t = fraction(is_upper ? from_corner : height - from_corner, height);
    const ArcPoint on_short(is_upper ? upper_edge_ : lower_edge_, t);
    const std::array<Cosine, Used>& upper_end = is_upper ? top_ : middle_;
    const std::array<Cosine, Used>& lower_end = is_upper ? middle_ : bottom_;
    Run run;
    unrolled<Used>([&](auto i) {
      run.on_long_[i] = on_long.between(top_[i], bottom_[i]);
      run.on_short_[i] = on_short.between(upper_end[i], lower_end[i]);
    });
    run.excess_ = ArcExcess(row_chord(on_long, on_short, is_upper));
    // The length of the middle row divided by that of this row: 15 fraction bits.
    const Reciprocal inverse = nonzero_reciprocal(static_cast<std::uint32_t>(from_corner));
    const std::uint32_t stretch =
        (static_cast<std::uint32_t>(height) * inverse.mantissa) >> (inverse.exponent - 15);
    const auto middle = static_cast<std::uint32_t>(base_ + of_b_ * b + of_c_ * c);
    run.u_ = static_cast<std::int32_t>((middle * stretch) >> (16 - kMoreBits));
    run.du_ = wrap_mul(d_middle_, static_cast<std::int32_t>(stretch)) >> (16 - kMoreBits);
    return run;
  }

 private:
  static constexpr int kMoreBits = 13;

  /// Returns part / whole, 15 fraction bits; 0 <= part <= whole <= 128 pixels.
  [[nodiscard]] static constexpr std::int32_t fraction(std::int32_t part, std::int32_t whole) {
    const Reciprocal inverse = nonzero_reciprocal(static_cast<std::uint32_t>(whole));
    return static_cast<std::int32_t>((static_cast<std::uint32_t>(part) * inverse.mantissa) >>
                                     (inverse.exponent - 15));
  }

  /// Returns the squared chord between the normals at both ends of a row, 15 fraction bits. For unit vectors
  /// |sum k_i N_i|^2 = (sum k_i)^2 - sum k_i k_j |N_i - N_j|^2.
  [[nodiscard]] constexpr std::int32_t row_chord(const ArcPoint& on_long, const ArcPoint& on_short,
                                                 bool is_upper) const {
    const std::int32_t from = on_short.weight_from();
    const std::int32_t to = on_short.weight_to();
    const std::int32_t top = on_long.weight_from() - (is_upper ? from : 0);
    const std::int32_t middle = is_upper ? -to : -from;
    const std::int32_t bottom = on_long.weight_to() - (is_upper ? 0 : to);
    const std::int32_t sum = top + middle + bottom;
    const auto product = [](std::int32_t p, std::int32_t q) { return (p * q) >> 15; };
    const std::int32_t chord = product(sum, sum) - product(product(top, middle), top_middle_) -
                               product(product(top, bottom), top_bottom_) -
                               product(product(middle, bottom), middle_bottom_);
    return chord < 0 ? 0 : chord > 32768 ? 32768 : chord;
  }

  std::int32_t base_;
  std::int32_t of_b_;
  std::int32_t of_c_;
  std::int32_t d_middle_;  ///< its change per pixel, 16 fraction bits
  std::int32_t top_y_;     ///< of the vertices, 4 fraction bits
  std::int32_t middle_y_;
  std::int32_t bottom_y_;
  std::int32_t top_middle_;  ///< squared chords, 15 fraction bits
  std::int32_t top_bottom_;
  std::int32_t middle_bottom_;
  ArcExcess long_edge_;
  ArcExcess upper_edge_;
  ArcExcess lower_edge_;
  std::array<Cosine, Used> top_;
  std::array<Cosine, Used> middle_;
  std::array<Cosine, Used> bottom_;
};

}  // namespace arcspan
