// SPDX-License-Identifier: MIT
#include <arcspan_config.h>

#if ARCSPAN_C_RGB565_SWAPPED
#include <arcspan/pixel/rgb565_swapped.hpp>

#include <arcspan_c/draw_format.hpp>

arcspan::Status arcspan::c::draw_rgb565_swapped(arcspan_view& view, const arcspan_target& target) {
  return draw_format<Rgb565Swapped>(view, target);
}
#endif
