// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/spread_rgb565.hpp>
#include <arcspan/shading/textured/texture_row.hpp>
#include <arcspan/target.hpp>
#include <arcspan/texture/texel_formats.hpp>

#include <cstdint>

namespace arcspan {

/// A sample of a texture: a 5-6-5 colour, and an opacity of 0...16.
struct SampledTexel {
  std::uint16_t rgb565;
  std::uint32_t opacity;
};

/// The nearest texel.
template <TexelFormat Texels, class Steps>
[[nodiscard]] ARCSPAN_INLINE constexpr SampledTexel nearest_texel(const typename Texels::Word* words,
                                                                  const std::uint16_t* palette,
                                                                  const Steps& steps) {
  const auto stored = Texels::stored(words, palette, steps.index());
  return {Texels::ColourFormat::rgb565(stored), Texels::ColourFormat::alpha(stored)};
}

/// Two texels of a row as a spread 5-6-5 pixel, and their opacity, mixed in 32nds.
template <TexelFormat Texels>
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t mixed_texels(const typename Texels::Word* words,
                                                                  const std::uint16_t* palette,
                                                                  std::uint32_t left, std::uint32_t right,
                                                                  std::uint32_t share,
                                                                  std::uint32_t& opacity) {
  using ColourFormat = typename Texels::ColourFormat;
  const auto a = Texels::stored(words, palette, left);
  const auto b = Texels::stored(words, palette, right);
  opacity = (ColourFormat::alpha(a) * (32 - share) + ColourFormat::alpha(b) * share + 16) >> 5;
  return detail::mixed_spread(detail::spread(ColourFormat::rgb565(a)),
                              detail::spread(ColourFormat::rgb565(b)), share);
}

/// The four nearest texels, mixed.
template <TexelFormat Texels, class Steps>
[[nodiscard]] ARCSPAN_INLINE constexpr SampledTexel bilinear_texel(const typename Texels::Word* words,
                                                                   const std::uint16_t* palette,
                                                                   const Steps& steps) {
  const auto& around = steps.around();
  const std::uint32_t here = around.index();
  const std::uint32_t below = around.below(here);
  const std::uint32_t to_right = around.to_right(here);
  const std::uint32_t right = steps.fraction_right();
  const std::uint32_t down = steps.fraction_below();
  std::uint32_t upper_opacity = 0;
  std::uint32_t lower_opacity = 0;
  const std::uint32_t upper =
      mixed_texels<Texels>(words, palette, here, here + to_right, right, upper_opacity);
  const std::uint32_t lower =
      mixed_texels<Texels>(words, palette, below, below + to_right, right, lower_opacity);
  return {detail::joined(detail::mixed_spread(upper, lower, down)),
          (upper_opacity * (32 - down) + lower_opacity * down + 16) >> 5};
}

}  // namespace arcspan
