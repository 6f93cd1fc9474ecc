// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/highlight_table.hpp>
#include <arcspan/lighting/illumination.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// An object's illumination, and what its tolerance allows.
template <class Illumination>
class AdaptiveIllumination : public Illumination {
 public:
  static constexpr std::int32_t kMostTolerance = 64;

  constexpr AdaptiveIllumination() = default;
  constexpr AdaptiveIllumination(const Illumination& illumination)
      : Illumination(illumination), highlight_table_(illumination.power(), illumination.specular()) {
    if constexpr (kLitEntries != 0) {
      for (std::size_t i = 0; i < kLitEntries; ++i) {
        const auto light = static_cast<std::int32_t>(static_cast<std::uint32_t>(i) << kLitShift);
        lit_ramp_[i] = Illumination::diffuse_colour(Cosine::from_raw(light));
      }
    }
    (void)set_tolerance(1);
  }

  /// 8-bit steps that a pixel may differ from what `Arc` would compute before rounding, 0...kMostTolerance,
  /// else kInvalidArgument and nothing changes.
  [[nodiscard]] constexpr Status set_tolerance(std::int32_t steps) {
    if (steps < 0 || steps > kMostTolerance) return Status::kInvalidArgument;
    const auto tolerance = static_cast<std::uint32_t>(steps) << kStepBits;
    // Of the two errors that may meet in a pixel, a highlight left out has a half, and linear light the rest;
    // farther from highlights they have an eighth and the rest.
    half_tolerance_reach_ = reach_of(tolerance / 2);
    eighth_tolerance_reach_ = reach_of(tolerance / 8);
    linear_limit_ = linear_limit_of(tolerance - tolerance / 2);
    far_linear_limit_ = linear_limit_of(tolerance - tolerance / 8);
    segment_limit_with_highlight_ = segment_limit_of(tolerance, true);
    segment_limit_without_highlight_ = segment_limit_of(tolerance - tolerance / 2, false);
    highlight_patch_limit_ = highlight_patch_limit_of(tolerance);
    return Status::kOk;
  }

  /// The half distance from which on highlights are left out.
  [[nodiscard]] constexpr std::int32_t half_tolerance_reach() const { return half_tolerance_reach_; }

  /// Up to which (squared radius of the normals) * N·L light may be linear at this half distance from
  /// highlights; 28 fraction bits.
  [[nodiscard]] constexpr std::uint32_t linear_limit(std::int32_t half_distance) const {
    return half_distance >= eighth_tolerance_reach_ ? far_linear_limit_ : linear_limit_;
  }

  /// Up to which squared chord of its widest edge a triangle's highlight may be a quadratic surface of its
  /// own; 28 fraction bits.
  [[nodiscard]] constexpr std::uint32_t highlight_patch_limit() const { return highlight_patch_limit_; }
  [[nodiscard]] constexpr const HighlightTable& highlight_table() const { return highlight_table_; }

  /// Whether a scaled distance is beyond the highlight. What the ramp asks comes first, so that it is asked
  /// once.
  [[nodiscard]] ARCSPAN_INLINE constexpr bool misses(std::int32_t distance) const {
    return !highlight_table_.is_white(distance) && distance >= HighlightTable::kReach;
  }

  /// The colour at a scaled distance of the highlight's cosine from 1; N·L > 0.
  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb colour_with_highlight_at(Cosine normal_light,
                                                                            std::int32_t distance) const {
    const PackedRgb ramp = lit_colour(normal_light);
    return misses(distance) ? ramp : ramp.plus(highlight_table_(distance));
  }
  /// The same, encoded; `encoded` is an EncodedColourTable that highlights use. White ones have a way of
  /// their own.
  template <class Format, class Colours>
  [[nodiscard]] ARCSPAN_INLINE constexpr typename Format::Encoded encoded_with_highlight_at(
      Cosine normal_light, std::int32_t distance, const Colours& encoded) const {
    if (highlight_table_.is_white(distance)) [[likely]] {
      return Format::encode(lit_colour(normal_light).plus(highlight_table_(distance)));
    }
    if (distance >= HighlightTable::kReach) return encoded[normal_light];
    return Format::encode(lit_colour(normal_light).plus(highlight_table_(distance)));
  }

  /// Up to which squared angle of a segment colours may be linear, with a highlight within reach or without;
  /// 28 fraction bits.
  [[nodiscard]] constexpr std::uint32_t segment_limit(bool shines) const {
    return shines ? segment_limit_with_highlight_ : segment_limit_without_highlight_;
  }

 private:
  static constexpr int kStepBits = 5;  ///< fraction bits of an 8-bit step
  static constexpr int kLitShift = 22;
  static constexpr std::size_t kLitEntries =
      kHasWideRegisters && Illumination::kLights == 1 && Illumination::kModel == Highlight::kPhong ? 1024 : 0;

  /// diffuse_colour(); where memory is plentiful by the top 10 bits, so that nothing has to be clamped.
  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb lit_colour(Cosine normal_light) const {
    if constexpr (kLitEntries != 0) {
      return lit_ramp_[static_cast<std::uint32_t>(normal_light.raw()) >> kLitShift];
    } else {
      return Illumination::diffuse_colour(normal_light);
    }
  }

  /// factor * tolerance / amount with 28 fraction bits, at most 1.
  [[nodiscard]] static constexpr std::uint32_t of_chord(std::uint32_t tolerance, std::uint32_t factor,
                                                        std::uint32_t amount) {
    const std::uint32_t product = tolerance * factor;
    if (product >= amount) return std::uint32_t{1} << 28;
    return static_cast<std::uint32_t>((static_cast<std::uint64_t>(product) << 28) / amount);
  }

  /// With s the squared radius, N·L rises by at most s/2 of itself above its plane. The plane is lifted by
  /// half of that, so that it is off by s/4 either way.
  [[nodiscard]] constexpr std::uint32_t linear_limit_of(std::uint32_t tolerance) const {
    return of_chord(tolerance, 4, Illumination::most_diffuse());
  }

  /// The half distance where the highlight has fallen to `steps`.
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

  /// A chord of m pixels is off by at most m^2 max|f''| / 8, and at a kink, where a channel is clamped, by
  /// m max|f'| / 4; |(cos^n)'| < 0.61 sqrt(n).
  [[nodiscard]] constexpr std::uint32_t segment_limit_of(std::uint32_t tolerance, bool shines) const {
    constexpr auto kCount = static_cast<std::uint32_t>(Illumination::kLights);
    const std::uint32_t diffuse = Illumination::most_diffuse() * kCount;
    const std::uint32_t second_difference = shines ? Illumination::most_curvature() : diffuse;
    const std::uint32_t limit = of_chord(tolerance, 8, second_difference);
    if (!Illumination::may_clamp(shines)) return limit;
    // f'^2 <= 2 (diffuse^2 + 0.37 specular * n specular), and n specular <= second_difference.
    const std::uint32_t specular = shines ? Illumination::most_specular() * kCount : 0;
    const std::uint64_t slope2 = 2 * (static_cast<std::uint64_t>(diffuse) * diffuse +
                                      (static_cast<std::uint64_t>(specular) * second_difference * 3) / 8);
    if (slope2 == 0) return limit;
    const std::uint64_t at_kink = (static_cast<std::uint64_t>(16 * tolerance * tolerance) << 28) / slope2;
    return at_kink < limit ? static_cast<std::uint32_t>(at_kink) : limit;
  }

  /// A quadratic surface through six distances of a cosine from 1 differs from the product of two surfaces
  /// through six scalars each by at most steps * 2.35 (n + 6) a^3 / 255 in the highlight, a being the widest
  /// chord (decision 7). Of the sharpest highlights `Arc` itself is a step off by rounding.
  [[nodiscard]] constexpr std::uint32_t highlight_patch_limit_of(std::uint32_t tolerance) const {
    constexpr std::uint32_t kSharpest = 64;
    if (Illumination::shininess() > kSharpest) return 0;
    const std::uint64_t height =
        std::uint64_t{Illumination::most_specular()} * (Illumination::shininess() + 6);
    const std::uint64_t most = (std::uint64_t{tolerance} * 108) << 40;  // 255 / 2.35, 40 fraction bits
    std::uint32_t inside = 0;
    for (std::uint32_t bit = 1u << 14; bit != 0; bit >>= 1) {  // of a chord, 16 fraction bits
      const std::uint64_t chord = inside + bit;
      if (((chord * chord * chord) >> 8) * height <= most) inside += bit;
    }
    return (inside * inside) >> 4;
  }

  HighlightTable highlight_table_{};
  std::int32_t half_tolerance_reach_ = 0;
  std::int32_t eighth_tolerance_reach_ = 0;
  std::uint32_t linear_limit_ = 0;
  std::uint32_t far_linear_limit_ = 0;
  std::uint32_t segment_limit_with_highlight_ = 0;
  std::uint32_t segment_limit_without_highlight_ = 0;
  std::uint32_t highlight_patch_limit_ = 0;
  std::array<PackedRgb, kLitEntries> lit_ramp_{};
};

}  // namespace arcspan
