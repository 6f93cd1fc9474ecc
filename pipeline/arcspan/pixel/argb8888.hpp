// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/xrgb8888.hpp>

namespace arcspan {

/// 32 bits per pixel, 0xFFRRGGBB in a native word. Every pixel is opaque, as compositors expect of a layer.
struct Argb8888 : Rgb32<255> {};

static_assert(PixelFormat<Argb8888>);

}  // namespace arcspan
