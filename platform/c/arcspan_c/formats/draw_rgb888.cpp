// SPDX-License-Identifier: MIT
#include <arcspan_config.h>

#if ARCSPAN_C_RGB888
#include <arcspan/pixel/rgb888.hpp>

#include <arcspan_c/draw_format.hpp>

arcspan::Status arcspan::c::draw_rgb888(arcspan_view& view, const arcspan_target& target) {
  return draw_format<Rgb888>(view, target);
}
#endif
