// SPDX-License-Identifier: MIT
#include <arcspan_config.h>

#if ARCSPAN_C_RGB565
#include <arcspan/pixel/rgb565.hpp>

#include <arcspan_c/draw_format.hpp>

arcspan::Status arcspan::c::draw_rgb565(arcspan_view& view, const arcspan_target& target) {
  return draw_format<Rgb565>(view, target);
}
#endif
