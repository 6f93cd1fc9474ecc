// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/format_bases.hpp>

namespace arcspan {

/// 4-bit luma, two pixels per byte, the left one in the upper four bits.
struct Gray4 : LumaBits<4> {};

static_assert(PixelFormat<Gray4>);

}  // namespace arcspan
