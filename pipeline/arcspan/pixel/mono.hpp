// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/format_bases.hpp>

namespace arcspan {

/// One bit per pixel, set if the luma is at least 128; eight pixels per byte, the leftmost in the highest
/// bit.
struct Mono : LumaBits<1> {};

static_assert(PixelFormat<Mono>);

}  // namespace arcspan
