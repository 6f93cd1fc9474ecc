// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/xrgb8888.hpp>

namespace arcspan {

/// 32 bits per pixel, 0xAARRGGBB in a native word. Every drawn pixel is opaque, as compositors expect of a
/// layer. Smooth outlines, ink and Blend::kAlpha over pixels that are not opaque are blended into the alpha;
/// colours are not premultiplied by it.
struct Argb8888 : Rgb32<255> {
  static constexpr bool kHasAlpha = true;
};

static_assert(PixelFormat<Argb8888>);

}  // namespace arcspan
