// SPDX-License-Identifier: MIT
#include <arcspan_config.h>

#if ARCSPAN_C_BGR888
#include <arcspan/pixel/bgr888.hpp>

#include <arcspan_c/draw_format.hpp>

arcspan::Status arcspan::c::draw_bgr888(arcspan_view& view, const arcspan_target& target) {
  return draw_format<Bgr888>(view, target);
}
#endif
