// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/highlight_table.hpp>
#include <arcspan/lighting/illumination.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/shading/arc/row_pieces.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// An object's illumination, a tolerance, and the limits that follow from it for the paths of Adaptive.
template <class Illumination>
class AdaptiveIllumination : public Illumination {
 public:
  static constexpr std::int32_t kMostTolerance = 64;
  /// PieceSteps::exponent from which on a piece of a row may have a stepped distance or HighlightFactors: 4
  /// pixels. Shorter pieces cost less by their scalars.
  static constexpr int kLeastPieceExponent = 18;
  using typename Illumination::Scalars;

  constexpr AdaptiveIllumination() = default;
  constexpr AdaptiveIllumination(const Illumination& illumination)
      : Illumination(illumination), highlight_table_(illumination.power(), illumination.specular()) {
    if constexpr (kLitEntries != 0) {
      for (std::size_t i = 0; i < kLitEntries; ++i) {
        const auto light = static_cast<std::int32_t>(static_cast<std::uint32_t>(i) << kLitShift);
        lit_colours_[i] = Illumination::diffuse_colour(Cosine::from_raw(light));
      }
    }
    (void)set_tolerance(1);
  }

  /// Sets the tolerance: the largest difference from the colour of `Arc` before rounding, in 8-bit steps. It
  /// is 1 at first. Returns kInvalidArgument and changes nothing unless `steps` is in 0...kMostTolerance.
  [[nodiscard]] constexpr Status set_tolerance(std::int32_t steps) {
    if (steps < 0 || steps > kMostTolerance) return Status::kInvalidArgument;
    const auto tolerance = static_cast<std::uint32_t>(steps) << kStepBits;
    // Two errors may add up in a pixel. An omitted highlight gets half of the tolerance and linear light the
    // rest; farther away from highlights, they get an eighth and the rest.
    // Every light may have a highlight that is omitted.
    const auto highlights = static_cast<std::uint32_t>(Illumination::lights());
    half_tolerance_reach_ = reach_of(tolerance / (2 * highlights));
    eighth_tolerance_reach_ = reach_of(tolerance / (8 * highlights));
    linear_limit_ = linear_limit_of(tolerance - tolerance / 2);
    far_linear_limit_ = linear_limit_of(tolerance - tolerance / 8);
    const std::uint32_t rest = tolerance - tolerance / 8;
    far_diffuse_patch_error_ = diffuse_patch_error_of(rest > kPatchError ? rest : kPatchError);
    diffuse_patch_error_ = diffuse_patch_error_of(tolerance - tolerance / 2);
    segment_limit_with_highlight_ = segment_limit_of(tolerance, true);
    segment_limit_without_highlight_ = segment_limit_of(tolerance - tolerance / 2, false);
    distance_limit_ = distance_limit_of(tolerance);
    highlight_patch_limit_ = highlight_patch_limit_of(distance_limit_);
    whole_linear_limit_ = linear_limit_of(tolerance);
    // This path draws one highlight. Those of the other lights are left out and share half of the tolerance.
    linear_share_ = (1u << 15) - (1u << 14) * (highlights - 1) / highlights;
    distance_limit_inverse_ = Illumination::model() == Highlight::kBlinn ? 0  // exact
                              : distance_limit_ < (std::uint32_t{1} << 16)
                                  ? UINT32_MAX
                                  : static_cast<std::uint32_t>((std::uint64_t{1} << 47) / distance_limit_);
    highlight_row_limit_ = highlight_row_limit_of(distance_limit_);
    white_margin_ = (static_cast<std::uint32_t>(steps) + 2) << 2;
    return Status::kOk;
  }

  /// Returns the half distance from which on highlights are omitted, because they are below half the
  /// tolerance: (1 - c) / 2 of the highlight's cosine c, 30 fraction bits.
  [[nodiscard]] constexpr std::int32_t half_tolerance_reach() const { return half_tolerance_reach_; }
  /// Returns the half distance from which on a highlight is below an eighth of the tolerance, in the same
  /// format.
  [[nodiscard]] constexpr std::int32_t eighth_tolerance_reach() const { return eighth_tolerance_reach_; }

  /// Returns the largest product of the normals' squared radius and N·L for which light may be linear, 28
  /// fraction bits, in a triangle whose half distance from the highlight is at least `half_distance`.
  [[nodiscard]] constexpr std::uint32_t linear_limit(std::int32_t half_distance) const {
    return half_distance >= eighth_tolerance_reach_ ? far_linear_limit_ : linear_limit_;
  }

  /// Returns the error that N·L of a patch beyond kWidestDiffusePatch may have in a small triangle like that
  /// of linear_limit(), 20 fraction bits. Far from highlights it is at least that of `Arc`.
  [[nodiscard]] constexpr std::uint32_t diffuse_patch_error(std::int32_t half_distance) const {
    return half_distance >= eighth_tolerance_reach_ ? far_diffuse_patch_error_ : diffuse_patch_error_;
  }

  /// linear_limit() of a triangle whose highlight's distance is a patch; `chord` is its widest squared chord,
  /// at most that of 16 degrees. The patch's error grows with chord^(3/2), and x^(3/2) <= x (1 + x) / 2 up to
  /// highlight_patch_limit(). Chords beyond that have no such patch.
  [[nodiscard]] constexpr std::uint32_t linear_limit_with_highlight(std::uint32_t chord) const {
    const std::uint32_t x = multiply_high(chord, distance_limit_inverse_);  // 15 fraction bits
    if (x >= 1u << 15) return 0;
    const std::uint32_t used = (x * ((1u << 15) + x)) >> 16;
    return used < linear_share_ ? (whole_linear_limit_ >> 15) * (linear_share_ - used) : 0;
  }

  /// Returns the largest squared chord of a triangle's widest edge for which the highlight's distance may be
  /// a patch, 28 fraction bits.
  [[nodiscard]] constexpr std::uint32_t highlight_patch_limit() const { return highlight_patch_limit_; }
  /// Returns true if highlights are computed from HighlightFactors beyond highlight_patch_limit(): R·V with n
  /// up to 64, unless the tolerance is 0.
  [[nodiscard]] constexpr bool multiplies_highlights() const {
    return Illumination::model() == Highlight::kPhong && distance_limit_ != 0;
  }
  /// Returns true if N·L exceeds the end of the fade, 0 without one, by at least 2^-10, which is more than
  /// any rounding error.
  [[nodiscard]] constexpr bool is_fully_lit(Cosine normal_light) const {
    return normal_light.raw() >= Illumination::fade_end().raw() + (std::int32_t{1} << 20);
  }
  [[nodiscard]] constexpr const HighlightTable& highlight_table() const { return highlight_table_; }

  /// Starts the diffuse_scalar() and the scaled distance of a light's highlight over a piece of a row, from a
  /// to b, as the scalars 0 and 1 of `run`; `lit` is that of the piece. Returns false if the piece is too
  /// short or too wide for that, or not lit throughout by that light.
  template <class Run>
  [[nodiscard]] ARCSPAN_INLINE constexpr bool start_highlight(const Scalars& a, const Scalars& b,
                                                              std::size_t light, std::uint32_t lit,
                                                              const PieceSteps& steps, Factor angle2,
                                                              Run& run) const {
    const std::size_t other = Illumination::highlight_index(light);
    if (steps.exponent < kLeastPieceExponent || angle2 >= highlight_row_limit_) return false;
    if (!is_fully_lit(a[light]) || !is_fully_lit(b[light])) return false;
    const std::int32_t at_a = Illumination::half_distance(a[light], a[other], light);
    const std::int32_t at_b = Illumination::half_distance(b[light], b[other], light);
    if (!highlight_table_.fits(at_a) || !highlight_table_.fits(at_b)) return false;
    const std::int32_t light4 = quadruple_sagitta_of(steps, a[light], b[light]);
    const std::int32_t other4 = quadruple_sagitta_of(steps, a[other], b[other]);
    const auto middle = [](Cosine p, Cosine q, std::int32_t sagitta4) {
      return Cosine::from_raw((p.raw() >> 1) + (q.raw() >> 1) + (sagitta4 >> 2));
    };
    const std::int32_t from = highlight_table_.scaled(at_a);
    const std::int32_t to = highlight_table_.scaled(at_b);
    const std::int32_t half_way = highlight_table_.scaled(Illumination::half_distance(
        middle(a[light], b[light], light4), middle(a[other], b[other], other4), light));
    if constexpr (Illumination::kLights == 1) {
      run.start_at(0, parabola_through(steps, steps.drop, a[0], b[0], light4));
    } else {
      run.start_at(
          0, parabola_of(steps, Illumination::diffuse_scalar(a, lit), Illumination::diffuse_scalar(b, lit)));
    }
    run.start_at(1, parabola_through(steps, 15, Cosine::from_raw(from), Cosine::from_raw(to),
                                     wrap_shl(wrap_sub(wrap_shl(half_way, 1), wrap_add(from, to)), 1)));
    return true;
  }

  /// Returns true if a scaled distance is beyond the highlight. is_white() comes first because the look-up in
  /// highlight_table_ begins with it too, so the compiler tests it once.
  [[nodiscard]] ARCSPAN_INLINE constexpr bool misses(std::int32_t distance) const {
    return !highlight_table_.is_white(distance) && distance >= HighlightTable::kReach;
  }

  /// Returns the colour with the diffuse_scalar() `diffuse` and a light's highlight at a scaled distance of
  /// its cosine from 1 (HighlightTable); N·L > 0. `weight` is the light's highlight_weight().
  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb colour_with_highlight_at(Cosine diffuse,
                                                                            std::int32_t distance,
                                                                            std::uint32_t weight) const {
    const PackedRgb lit = lit_colour(diffuse);
    return misses(distance) ? lit : lit.plus(highlight_at(distance, weight));
  }
  /// Returns the parts of that colour.
  [[nodiscard]] ARCSPAN_INLINE constexpr PixelLight light_with_highlight_at(Cosine diffuse,
                                                                            std::int32_t distance,
                                                                            std::uint32_t weight) const {
    return {lit_colour(diffuse), misses(distance) ? PackedRgb{} : highlight_at(distance, weight)};
  }
  /// Returns true if no pixel of a triangle with a white highlight saturates, whose N·L is at most `most` and
  /// whose half distances are at least `nearest`; one light only.
  [[nodiscard]] constexpr bool never_saturates(Cosine most, std::int32_t nearest) const {
    const std::uint32_t highest =
        highlight_table_.white(highlight_table_.scaled(nearest < 0 ? 0 : nearest)) + white_margin_;
    return highest < 1024 && lit_colour(most).fits_plus(PackedRgb::grey(highest));
  }
  /// Returns colour_with_highlight_at() by a white highlight: nothing is asked about the reach.
  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb colour_with_white_at(Cosine diffuse,
                                                                        std::int32_t distance) const {
    std::uint32_t white = highlight_table_.white(distance);
    hide_value(white);  // comes first, because the diffuse colour would take a register meanwhile
    return lit_colour(diffuse).plus(PackedRgb::grey(white));
  }
  /// Returns colour_with_white_at() in a triangle that never_saturates(), without any comparison.
  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb colour_with_fitting_white_at(Cosine diffuse,
                                                                                std::int32_t distance) const {
    std::uint32_t white = highlight_table_.white(distance);
    hide_value(white);
    return lit_colour(diffuse).plus_fitting(PackedRgb::grey(white));
  }
  /// Returns the parts of that colour.
  [[nodiscard]] ARCSPAN_INLINE constexpr PixelLight light_with_white_at(Cosine diffuse,
                                                                        std::int32_t distance) const {
    return {lit_colour(diffuse), PackedRgb::grey(highlight_table_.white(distance))};
  }

  /// Returns the largest squared angle of a segment within which colours may be linear, 28 fraction bits;
  /// `shines` is true if a highlight is within reach.
  [[nodiscard]] constexpr std::uint32_t segment_limit(bool shines) const {
    return shines ? segment_limit_with_highlight_ : segment_limit_without_highlight_;
  }

 private:
  static constexpr int kStepBits = 5;  ///< fraction bits of tolerances and colours, in 8-bit steps
  static constexpr int kLitShift = 22;
  static constexpr std::size_t kLitEntries = kHasWideRegisters && Illumination::kLights == 1 ? 1024 : 0;

  /// Returns diffuse_colour(). Targets with wide registers look it up by the top 10 bits of N·L, for all
  /// values of which the table has an entry, so that nothing is clamped.
  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb lit_colour(Cosine normal_light) const {
    if constexpr (kLitEntries != 0) {
      return lit_colours_[static_cast<std::uint32_t>(normal_light.raw()) >> kLitShift];
    } else {
      return Illumination::diffuse_colour(normal_light);
    }
  }

  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb highlight_at(std::int32_t distance,
                                                                std::uint32_t weight) const {
    if constexpr (Illumination::kLights == 1) return highlight_table_(distance);
    return highlight_table_(distance, weight);
  }

  /// Returns factor * tolerance / amount, at most 1, with 28 fraction bits.
  [[nodiscard]] static constexpr std::uint32_t limit_of(std::uint32_t tolerance, std::uint32_t factor,
                                                        std::uint32_t amount) {
    const std::uint32_t product = tolerance * factor;
    if (product >= amount) return std::uint32_t{1} << 28;
    return static_cast<std::uint32_t>((static_cast<std::uint64_t>(product) << 28) / amount);
  }

  /// Returns linear_limit() for a tolerance. With s the squared radius of the normals, N·L is above its plane
  /// by at most s/2 of itself. The plane is lifted by half of that, so that the error is s/4 either way.
  [[nodiscard]] constexpr std::uint32_t linear_limit_of(std::uint32_t tolerance) const {
    if constexpr (Illumination::kHasRamp) return limit_of(tolerance, 4, Illumination::most_ramp());
    return 0;
  }

  /// Returns diffuse_patch_error() for a tolerance.
  [[nodiscard]] constexpr std::uint32_t diffuse_patch_error_of(std::uint32_t tolerance) const {
    if constexpr (Illumination::kHasRamp) {
      const std::uint32_t ramp = Illumination::most_ramp();
      return ramp == 0 ? UINT32_MAX : (tolerance << 20) / ramp;
    }
    return 0;
  }

  /// Returns the square of the largest chord below 1 whose cube times `height` is at most `most`, 28
  /// fraction bits.
  [[nodiscard]] static constexpr std::uint32_t squared_chord_of(std::uint64_t height, std::uint64_t most) {
    std::uint32_t inside = 0;
    for (std::uint32_t bit = 1u << 15; bit != 0; bit >>= 1) {  // of a chord, 16 fraction bits
      const std::uint64_t chord = inside + bit;
      if (((chord * chord * chord) >> 8) * height <= most << 40) inside += bit;
    }
    return (inside * inside) >> 4;
  }

  /// Returns the half distance beyond which the highlight is below `steps`, found by bisection.
  [[nodiscard]] constexpr std::int32_t reach_of(std::uint32_t steps) const {
    std::int32_t inside = 0;
    std::int32_t outside = Illumination::power().half_reach();
    while (outside - inside > 1) {
      const std::int32_t middle = inside + (outside - inside) / 2;
      const std::uint32_t share = (Illumination::most_specular() * Illumination::power()(middle)) >> 15;
      (share >= steps ? inside : outside) = middle;
    }
    return outside;
  }

  /// Returns segment_limit() for a tolerance. Over a segment of the angle m, a colour f differs from its
  /// chord by at most m^2 max|f''| / 8 and, at a kink where a channel is clamped, by m max|f'| / 4;
  /// |(cos^n)'| < 0.61 sqrt(n).
  [[nodiscard]] constexpr std::uint32_t segment_limit_of(std::uint32_t tolerance, bool shines) const {
    const auto lights = static_cast<std::uint32_t>(Illumination::lights());
    const std::uint32_t diffuse = Illumination::most_diffuse() * lights;
    const std::uint32_t curvature = shines ? Illumination::most_curvature() : diffuse;
    const std::uint32_t limit = limit_of(tolerance, 8, curvature);
    // With n = 1 the highlight itself has a kink where its cosine is 0.
    if (!Illumination::may_clamp(shines) && !(shines && Illumination::shininess() == 1)) return limit;
    // f'^2 <= 2 (diffuse^2 + 0.37 specular * n specular), and n specular <= curvature.
    const std::uint32_t specular = shines ? Illumination::most_specular() * lights : 0;
    const std::uint64_t slope2 = 2 * (static_cast<std::uint64_t>(diffuse) * diffuse +
                                      (static_cast<std::uint64_t>(specular) * curvature * 3) / 8);
    if (slope2 == 0) return limit;
    const std::uint64_t at_kink = (static_cast<std::uint64_t>(16 * tolerance * tolerance) << 28) / slope2;
    return at_kink < limit ? static_cast<std::uint32_t>(at_kink) : limit;
  }

  /// Returns the squared chord up to which the highlight's distance may be a patch, as long as the bound
  /// holds that highlights then differ by at most specular * 2.35 (n + 6) a^3 / 255 from those of the product
  /// of two surfaces, where `specular` is the full highlight and a is the widest chord (decision 7). It is 0
  /// with tolerance 0, and with R·V for n > 64, where `Arc` itself is one step off by rounding and
  /// HighlightTable::scaled_factor() too large. Blinn's distance is linear in N·H, so that its surface is the
  /// surface of N·H, and needs no limit.
  [[nodiscard]] constexpr std::uint32_t distance_limit_of(std::uint32_t tolerance) const {
    if (tolerance == 0) return 0;
    if (Illumination::model() == Highlight::kBlinn) return std::uint32_t{1} << 28;
    constexpr std::uint32_t kSharpest = 64;
    if (Illumination::shininess() > kSharpest) return 0;
    const std::uint64_t height =
        std::uint64_t{Illumination::most_specular()} * (Illumination::shininess() + 6);
    const std::uint32_t limit = squared_chord_of(height, std::uint64_t{tolerance} * 108);  // 255 / 2.35
    constexpr std::uint32_t kWidest = (std::uint32_t{1} << 26) - 1;  // of a chord of 1/2
    return limit < kWidest ? limit : kWidest;
  }

  /// Returns highlight_patch_limit(), of distance_limit_of(). For n <= 4 the bound holds up to 24 degrees,
  /// and up to 28 with another 2 % of error. For other exponents it holds up to a chord of b = 16 degrees,
  /// from where on the error grows by another factor of 1 + 3 (a^2 - b^2).
  [[nodiscard]] constexpr std::uint32_t highlight_patch_limit_of(std::uint32_t limit) const {
    if (Illumination::model() == Highlight::kBlinn) return limit;
    constexpr std::uint32_t kWidest = 64168232;        // 28.3 degrees
    constexpr std::uint32_t kBluntBounded = 46414929;  // 24 degrees
    constexpr std::uint32_t kBounded = 20797469;       // 16 degrees
    constexpr std::uint32_t kBlunt = 4;
    const std::uint32_t within = limit < kWidest ? limit : kWidest;
    if (Illumination::shininess() <= kBlunt) return within <= kBluntBounded ? within : within - (within >> 6);
    if (within <= kBounded) return within;
    return within - 2 * multiply_high(within << 2, (within - kBounded) << 2);
  }

  /// Returns the largest squared angle of a piece of a row over which the highlight's distance may be a
  /// parabola, of distance_limit_of(). With the squared angle s the parabola's error is 1 + 1.9 s times that
  /// of the bound, which grows with s^(3/2).
  [[nodiscard]] constexpr Factor highlight_row_limit_of(std::uint32_t distance_limit) const {
    const auto limit = static_cast<std::int32_t>(distance_limit >> 13);
    if (Illumination::model() == Highlight::kBlinn) return Factor::from_raw(limit);
    const std::int32_t square = wrap_mul(limit, limit) >> 15;
    return Factor::from_raw(limit - square - (square >> 2));
  }

  HighlightTable highlight_table_{};
  std::int32_t half_tolerance_reach_ = 0;
  std::int32_t eighth_tolerance_reach_ = 0;
  std::uint32_t linear_limit_ = 0;
  std::uint32_t far_linear_limit_ = 0;
  std::uint32_t diffuse_patch_error_ = 0;
  std::uint32_t far_diffuse_patch_error_ = 0;
  std::uint32_t segment_limit_with_highlight_ = 0;
  std::uint32_t segment_limit_without_highlight_ = 0;
  std::uint32_t distance_limit_ = 0;
  std::uint32_t highlight_patch_limit_ = 0;
  std::uint32_t distance_limit_inverse_ = 0;  ///< 1 / distance_limit_of(), 47 - 28 fraction bits; 0 if exact
  std::uint32_t whole_linear_limit_ = 0;      ///< linear_limit() for all of the tolerance
  std::uint32_t linear_share_ = 0;  ///< of the tolerance beside omitted highlights, 15 fraction bits
  Factor highlight_row_limit_{};
  std::uint32_t white_margin_ = 0;  ///< the most by which errors may raise a pixel, as a value of PackedRgb
  std::array<PackedRgb, kLitEntries> lit_colours_{};
};

}  // namespace arcspan
