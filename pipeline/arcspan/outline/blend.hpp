// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/mixed_pixels.hpp>
#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan::detail {

/// True if a mixture of two pixels of this format shows as one: not with two or four levels.
template <PixelFormat F>
inline constexpr bool kCanBlend = F::kBitsPerPixel >= 4;

/// A pixel 0xAARRGGBB with a share of `share` / 32 of `other`, 0...32. Colours count as much as they are
/// opaque.
[[nodiscard]] constexpr std::uint32_t blended_with_alpha(std::uint32_t pixel, std::uint32_t other,
                                                         std::uint32_t share) {
  const std::uint32_t a = (pixel >> 24) * (32 - share);
  const std::uint32_t b = (other >> 24) * share;
  const std::uint32_t alpha = ((a + b + 16) >> 5) << 24;
  if (b == 0) return alpha | (pixel & 0xFFFFFFu);
  if (a == 0) return alpha | (other & 0xFFFFFFu);
  const auto mixed = [=](unsigned shift) {
    const std::uint32_t sum = a * ((pixel >> shift) & 255u) + b * ((other >> shift) & 255u);
    return (sum + (a + b) / 2) / (a + b) << shift;
  };
  return alpha | mixed(16) | mixed(8) | mixed(0);
}

/// The pixel with a share of `share` / 32 of `other`, 0...32, and the rest of `pixel`.
template <PixelFormat F>
[[nodiscard]] ARCSPAN_INLINE constexpr typename F::Encoded blended(typename F::Encoded pixel,
                                                                   typename F::Encoded other,
                                                                   std::uint32_t share) {
  if constexpr (requires { requires F::kHasAlpha; }) {
    return blended_with_alpha(pixel, other, share);
  } else {
    return mixed_pixels<F>(pixel, other, share);
  }
}

}  // namespace arcspan::detail
