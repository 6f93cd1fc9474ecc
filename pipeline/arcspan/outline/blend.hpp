// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/blended_alpha.hpp>
#include <arcspan/pixel/mixed_pixels.hpp>
#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan::detail {

/// True if a mixture of two pixels of this format shows as one: not with two or four levels.
template <PixelFormat F>
inline constexpr bool kCanBlend = F::kBitsPerPixel >= 4;

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
