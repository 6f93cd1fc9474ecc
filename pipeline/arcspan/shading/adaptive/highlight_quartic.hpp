// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/prepare/row_start.hpp>
#include <arcspan/shading/adaptive/highlight_factors.hpp>
#include <arcspan/shading/adaptive/highlight_patch.hpp>
#include <arcspan/shading/patch/diffuse_scalars.hpp>
#include <arcspan/shading/patch/parabola.hpp>
#include <arcspan/shading/patch/patch.hpp>
#include <arcspan/shading/patch/patch_walker.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

/// Highlights R·V of one of several lights where normals are too far apart for a surface of the half distance
/// (decision 7). Along a row the distance (1 + L·V) / 2 - (N·L)(N·V) is a constant less the product of two
/// parabolas: a polynomial of degree 4, which fourth differences step. That takes fewer registers than N·L,
/// N·V and the diffuse scalar.
namespace arcspan {

/// The constants of the polynomials origin - f g of all rows of a triangle. f and g are scalars of a patch,
/// whose second differences do not change.
struct QuarticConstants {
  /// Second, third and fourth differences have 37 fraction bits, these more than a Cosine: their rounding
  /// errors grow with the square, the cube and the fourth power of the row's length.
  static constexpr int kExtraBits = 7;
  /// Least width of a triangle's widest row, in pixels with 16 fraction bits. The differences fit their words
  /// from 9 pixels on; below 12 a quartic costs more than it saves.
  static constexpr std::uint32_t kLeastWidth = std::uint32_t{12} << 16;

  std::int32_t origin;  ///< product_origin()
  std::int32_t third;   ///< correction of a row's first third difference, 37 fraction bits
  std::int32_t fourth;  ///< the fourth difference, 37 fraction bits

  constexpr QuarticConstants() = default;
  /// `second_f` and `second_g` are below 2^-6, as those of any patch of at least kLeastWidth are; `width` is
  /// that of the widest row in pixels, at most kLargestPatch.
  constexpr QuarticConstants(std::int32_t product_origin, Cosine second_f, Cosine second_g,
                             std::int32_t width)
      : origin(product_origin) {
    constexpr int kDropped = Cosine::kFraction - kExtraBits;
    const std::int64_t exact = std::int64_t{-6} * second_f.raw() * second_g.raw();  // 60 fraction bits
    fourth = static_cast<std::int32_t>((exact + (std::int64_t{1} << (kDropped - 1))) >> kDropped);
    // The rest r of rounding would grow to r n^4 / 24 after n pixels. r a in the third difference takes
    // r a n^3 / 6 off, which comes closest for a = 0.23 width.
    const auto rest = static_cast<std::int32_t>(exact - std::int64_t{fourth} * (std::int64_t{1} << kDropped));
    third = wrap_mul(rest, (width * 15) >> 6) >> kDropped;
  }
};

/// The polynomial origin - f g of a row, a scaled distance (HighlightTable).
class QuarticSteps {
 public:
  /// Starts at a pixel. f and g are scalars along one arc, of at most 1/16 rad per pixel, with amplitudes of
  /// at most 1 and 1.25: every difference of their product then fits its word.
  ARCSPAN_INLINE constexpr void start(const Parabola& f, const Parabola& g,
                                      const QuarticConstants& constants) {
    // The differences p1 to p4 of the product p = f g, by the first and second ones of f and g:
    //   p1 = f g1 + f1 (g + g1)
    //   p2 = g2 (f + 2 f1) + f2 (g + 2 g1 + g2) + 2 f1 g1
    //   p3 = 3 (g2 f1 + f2 (g1 + 2 g2))
    //   p4 = 6 f2 g2
    const auto times = [](Cosine a, int up_a, Cosine b, int up_b) {
      return multiply_high(wrap_shl(a.raw(), up_a), wrap_shl(b.raw(), up_b));
    };
    const Cosine f2 = f.second_difference;
    const Cosine g2 = g.second_difference;
    const Cosine next_g = g.x + g.d;
    const Cosine next_g1 = g.d + g2;
    x_ = wrap_sub(constants.origin, wrap_shl(times(f.x, 0, g.x, 0), 2));
    d_ = wrap_sub(0, wrap_add(times(f.x, 0, g.d, 2), times(next_g, 0, f.d, 2)));
    const std::int32_t p2 =  // 36 fraction bits
        wrap_add(wrap_add(times(f.x + f.d + f.d, 0, g2, 8), times(next_g + next_g1, 0, f2, 8)),
                 wrap_shl(times(f.d, 4, g.d, 4), 1));
    constexpr std::int32_t kHalf = std::int32_t{1} << (QuarticConstants::kExtraBits - 1);
    second_ = wrap_sub(kHalf, wrap_shl(p2, 1));  // so that next() rounds to nearest
    const std::int32_t third_of_p3 =             // 40 fraction bits
        wrap_add(times(f.d, 4, g2, 8), times(next_g1 + g2, 4, f2, 8));
    third_ = wrap_sub(constants.third, wrap_mul(third_of_p3, 3) >> 3);
    fourth_ = constants.fourth;
  }
  ARCSPAN_INLINE constexpr void next() {
    x_ = wrap_add(x_, d_);
    d_ = wrap_add(d_, second_ >> QuarticConstants::kExtraBits);
    second_ = wrap_add(second_, third_);
    third_ = wrap_add(third_, fourth_);
  }
  [[nodiscard]] constexpr std::int32_t value() const { return x_; }

 private:
  std::int32_t x_;
  std::int32_t d_;
  std::int32_t second_;
  std::int32_t third_;
  std::int32_t fourth_;
};

/// The diffuse_scalar(), stepped by second differences, and the scaled distance of a highlight.
class QuarticHighlight {
 public:
  static constexpr std::size_t kUsed = 3;  ///< scalars of the patch: the diffuse scalar and both factors

  ARCSPAN_INLINE constexpr void start(const PatchScalar& diffuse, const PatchScalar& light,
                                      const PatchScalar& eye, const QuarticConstants& constants,
                                      const RowStart& start) {
    diffuse_.start(0, diffuse, start.fraction);
    distance_.start(parabola_from_edge(light, start.fraction), parabola_from_edge(eye, start.fraction),
                    constants);
    // One by one, because next() drops bits: a cut row must have the colours of the whole one.
    for (std::int32_t left = start.skipped; left > 0; --left) next();
  }
  ARCSPAN_INLINE constexpr void next() {
    diffuse_.next();
    distance_.next();
  }
  [[nodiscard]] constexpr Cosine diffuse() const { return diffuse_.scalars()[0]; }
  [[nodiscard]] constexpr std::int32_t distance() const { return distance_.value(); }

 private:
  SecondDifferenceRun<1> diffuse_;
  QuarticSteps distance_;
};

template <class Lighting>
using HighlightQuarticRun = SteppedHighlightRun<Lighting, QuarticHighlight, HighlightPixels::kAny>;

/// Steps a patch of the diffuse scalar and both factors of a highlight (RowWalker).
template <class Lighting, std::size_t Count>
class HighlightQuarticWalker : public PatchWalker<HighlightQuarticRun<Lighting>, Count> {
 public:
  using Base = PatchWalker<HighlightQuarticRun<Lighting>, Count>;
  using typename Base::Run;

  constexpr HighlightQuarticWalker(Patch<Count>& patch, bool middle_left, const QuarticConstants& constants,
                                   std::uint32_t weight)
      : Base(patch, middle_left), patch_(&patch), constants_(constants), weight_(weight) {}
  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
    Run run;
    run.start((*patch_)[0], (*patch_)[1], (*patch_)[2], constants_, start);
    run.set_weight(weight_);
    return run;
  }

 private:
  const Patch<Count>* patch_;
  QuarticConstants constants_;
  std::uint32_t weight_;
};

/// Prepares a HighlightQuarticWalker for a TriangleFrame that is lit_throughout() by the lights `lit`, of
/// which the highlight of `light` is within reach.
template <class Lighting, class Frame, std::size_t Count>
constexpr void prepare_quartic(const Lighting& lighting, const Frame& frame, std::size_t light,
                               std::uint32_t lit, Patch<Count>& patch, QuarticConstants& constants) {
  const EdgeSagittaFactors factors = sagitta_factors_of(frame.chords);
  make_patch_scalar(frame, factors, diffuse_scalars(lighting, frame, lit), patch[0]);
  make_patch_scalar(frame, factors, values_of(frame, light), patch[1]);
  make_patch_scalar(frame, factors, scaled_eye_of(lighting, frame, light), patch[2]);
  constants = QuarticConstants(product_origin(lighting, light), patch[1].second_difference,
                               patch[2].second_difference, static_cast<std::int32_t>(frame.width >> 16));
}

}  // namespace arcspan
