// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/format_bases.hpp>

namespace arcspan {

/// 2-bit luma, four pixels per byte, the leftmost in the highest bits.
struct Gray2 : LumaBits<2> {};

static_assert(PixelFormat<Gray2>);

}  // namespace arcspan
