// SPDX-License-Identifier: MIT
#include <arcspan_config.h>

#if ARCSPAN_C_GRAY4
#include <arcspan/pixel/gray4.hpp>

#include <arcspan_c/draw_format.hpp>

arcspan::Status arcspan::c::draw_gray4(arcspan_view& view, const arcspan_target& target) {
  return draw_format<Gray4>(view, target);
}
#endif
