// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination_features.hpp>
#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/target.hpp>

#include <cstdint>
#include <type_traits>

namespace arcspan {

/// The factor of a highlight near the terminator, min(1, N·L / e): the self-shadowing term of Kilgard, "A
/// Practical and Robust Bump-mapping Technique for Today's GPUs", 2000, who proposes e = 1/8. Without it the
/// highlight ends abruptly where N·L = 0, which is visible if the exponent is low.
class HighlightFade {
 public:
  constexpr HighlightFade() = default;
  /// `end` is e, 0...1; the default 0 fades nothing.
  constexpr explicit HighlightFade(Coefficient end)
      : end_(static_cast<std::uint32_t>(end.raw())),
        scale_(end_ == 0 ? 0 : (std::uint32_t{1} << 30) / end_) {}

  /// The N·L from which on a highlight has its full strength.
  [[nodiscard]] constexpr Cosine end() const {
    return Cosine::from_raw(static_cast<std::int32_t>(end_ << kDropped));
  }

  /// Returns `power` times the factor, for `power` in 0...1 with 15 fraction bits and N·L > 0.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t operator()(std::uint32_t power,
                                                                  Cosine normal_light) const {
    const std::uint32_t light = static_cast<std::uint32_t>(normal_light.raw()) >> kDropped;
    if (light >= end_) [[likely]]
      return power;
    return (power * ((light * scale_) >> 15)) >> 15;
  }

 private:
  static constexpr int kDropped = Cosine::kFraction - Coefficient::kFraction;

  std::uint32_t end_ = 0;    ///< 15 fraction bits
  std::uint32_t scale_ = 0;  ///< 1 / end_, 15 fraction bits
};

/// Used where highlights end abruptly.
struct NoHighlightFade {
  constexpr NoHighlightFade() = default;
  constexpr explicit NoHighlightFade(Coefficient) {}
  [[nodiscard]] static constexpr Cosine end() { return {}; }
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t operator()(std::uint32_t power, Cosine) const {
    return power;
  }
};

/// The fade of an illumination with these features.
template <IlluminationFeatures Features>
using FadeFor = std::conditional_t<Features.fading_highlights, HighlightFade, NoHighlightFade>;

}  // namespace arcspan
