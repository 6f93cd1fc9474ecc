// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/pixel_light.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/spread_rgb565.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstdint>
#include <type_traits>

namespace arcspan {

/// Which colours the light on a texture may have.
enum class TexelLight : std::uint8_t {
  kNone,      ///< texels keep their colours: signs, emitters, light that is painted into the texture
  kGrey,      ///< all channels of ambient and diffuse light are equal; one product per pixel
  kColoured,  ///< one product per channel
};

namespace detail {

/// texel * light for a channel: 8 bits times a PackedRgb channel, as a PackedRgb channel.
[[nodiscard]] constexpr std::uint32_t lit_channel(std::uint32_t texel, std::uint32_t light) {
  // The half step of the light is left out of the product, and added once. 257 / 2^16 is 1 / 255.
  const std::uint32_t above = light < 2 ? 0 : light - 2;
  return ((texel * above * 257u + 0x8000u) >> 16) + 2;
}

}  // namespace detail

/// The colour of a texel that keeps its colour (PackableColour).
struct UnlitTexel {
  std::uint32_t texel;

  ARCSPAN_INLINE constexpr explicit UnlitTexel(std::uint16_t shown) : texel(shown) {}
  // Not trivial, because compilers would store what they copy within operations.
  ARCSPAN_INLINE constexpr UnlitTexel(const UnlitTexel& other) : texel(other.texel) {}

  [[nodiscard]] constexpr std::uint16_t rgb565() const { return static_cast<std::uint16_t>(texel); }
  [[nodiscard]] constexpr PackedRgb packed() const { return PackedRgb::of(Rgb565::decode(rgb565())); }
};

/// The level of grey light, 0...64, rounded.
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t grey_level(PackedRgb light) {
  return ((light.lanes >> 22) + 8) >> 4;
}

/// The colour of a texel under light (PackableColour). As a 5-6-5 pixel it is computed from `factor`, with
/// grey light of 65 levels in one word, and the highlight `shine`; as other formats with all bits of `light`.
/// Both are rounded.
template <TexelLight Colours>
struct LitTexel {
  static constexpr bool kGrey = Colours == TexelLight::kGrey;
  /// The light_factor() of grey light, or the red, green and blue of coloured light, 0...1023.
  using Factor = std::conditional_t<kGrey, std::uint32_t, std::array<std::uint32_t, 3>>;

  std::uint16_t texel;
  PixelLight light;
  Factor factor;
  std::uint32_t shine;  ///< the highlight as a wide_spread()

  ARCSPAN_INLINE constexpr LitTexel(std::uint16_t shown, const PixelLight& reflected, const Factor& factors,
                                    std::uint32_t highlight)
      : texel(shown), light(reflected), factor(factors), shine(highlight) {}
  // Member by member, because small cores would copy colours within operations by memcpy.
  ARCSPAN_INLINE constexpr LitTexel(const LitTexel& other)
      : LitTexel(other.texel, other.light, other.factor, other.shine) {}
  [[nodiscard]] ARCSPAN_INLINE static constexpr Factor factor_of(PackedRgb diffuse) {
    if constexpr (kGrey) {
      return detail::light_factor(grey_level(diffuse));
    } else {
      return {(diffuse.lanes >> 11) & 1023u, diffuse.lanes >> 22, diffuse.lanes & 1023u};
    }
  }
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::uint32_t shine_of(PackedRgb highlight) {
    return highlight.lanes == 0 ? 0 : detail::wide_spread(detail::joined(detail::spread(highlight)));
  }

  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint16_t rgb565() const {
    std::uint32_t lit;
    if constexpr (kGrey) {
      lit = detail::lit_pixel(texel, factor);
    } else {
      const std::uint32_t red = (texel >> 11) * factor[0] + 512u;
      const std::uint32_t green = (texel >> 5 & 63u) * factor[1] + 512;
      const std::uint32_t blue = (texel & 31u) * factor[2] + 512;
      lit = ((green >> 10) << 22) | ((red >> 10) << 11) | (blue >> 10);
    }
    if (shine != 0) lit = detail::saturated_sum<true>(lit, shine);
    return detail::joined_wide(lit);
  }
  [[nodiscard]] constexpr PackedRgb packed() const {
    const std::uint32_t green = light.diffuse.lanes >> 22;
    const std::uint32_t red = kGrey ? green : (light.diffuse.lanes >> 11) & 1023u;
    const std::uint32_t blue = kGrey ? green : light.diffuse.lanes & 1023u;
    const Rgb8 unlit = Rgb565::decode(texel);
    const PackedRgb lit =
        PackedRgb::of(detail::lit_channel(unlit.r, red), detail::lit_channel(unlit.g, green),
                      detail::lit_channel(unlit.b, blue));
    return lit.plus(light.highlight);
  }
};

/// A colour `C` of a texel whose format has alpha (AlphaColour, MaskedColour). `kIsMask` if the opacity is 0
/// or 16 only.
template <class C, bool kIsMask>
struct AlphaTexel : C {
  std::uint32_t opacity;  ///< 0...16

  [[nodiscard]] constexpr std::uint32_t alpha() const { return opacity; }
  /// Unless an operation blends, a texel is drawn if it is at least half opaque.
  [[nodiscard]] constexpr bool covers(std::int32_t, std::int32_t) const {
    return kIsMask ? opacity != 0 : opacity >= 8;
  }
};

}  // namespace arcspan
