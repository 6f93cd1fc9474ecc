// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/pixel/pixel_operation.hpp>
#include <arcspan/pixel/spread_rgb565.hpp>
#include <arcspan/shading/textured/texel_light.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// Light on textures, looked up by the scalars that `Arc` interpolates: the level of grey light, a byte for
/// each colour of the ramp, and the highlight of a single light at 128 distances from its peak (512 bytes).
/// `Illumination` has a ramp.
template <class Illumination, TexelLight Colours>
class LightTables {
 public:
  using Scalars = typename Illumination::Scalars;
  static constexpr bool kHasLevels = Colours == TexelLight::kGrey;
  /// The highlights of several lights may overlap, and are added instead.
  static constexpr bool kHasShines = Illumination::kLights == 1;

  constexpr LightTables() = default;
  constexpr explicit LightTables(const Illumination& light) {
    for (std::size_t i = 0; i < levels_.size(); ++i)
      levels_[i] = static_cast<std::uint8_t>(grey_level(light.ramp()[i]));
    for (std::size_t i = 1; i < shines_.size(); ++i) {
      const auto middle = static_cast<std::int32_t>((2 * i + 1) << (kShineBits - 1));
      shines_[i] = detail::wide_spread(detail::colour565(light.highlight_at(middle)));
    }
  }

  /// The light_factor() of grey light at a diffuse scalar.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t factor_at(Cosine scalar) const requires kHasLevels {
    return detail::light_factor(levels_[Illumination::ramp_index(scalar)]);
  }
  /// The highlight of a pixel with these pixel_scalar(), as a wide_spread().
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t shine_at(
      const Illumination& light, const Scalars& scalars) const requires kHasShines {
    if (scalars[0].raw() <= 0) return 0;
    const auto distance =
        static_cast<std::size_t>(clamped_unsigned<7, kShineBits>(light.closeness(scalars, 0)));
    const std::uint32_t full = shines_[distance];
    if constexpr (!Illumination::kFeatures.fading_highlights) return full;
    const std::uint32_t share = light.fade()(std::uint32_t{1} << 15, scalars[0]);
    return detail::lit_spread(full << 4, detail::light_factor(share >> 9));
  }

 private:
  static constexpr int kShineBits = HighlightTable::kReachBits - 7;

  // The first member, so that its address needs no offset.
  std::array<std::uint8_t, kHasLevels ? Illumination::kRampSize : 0> levels_{};
  std::array<std::uint32_t, kHasShines ? 128 : 0> shines_{};  ///< the first is 0
};

}  // namespace arcspan
