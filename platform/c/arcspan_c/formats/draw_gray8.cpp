// SPDX-License-Identifier: MIT
#include <arcspan_config.h>

#if ARCSPAN_C_GRAY8
#include <arcspan/pixel/gray8.hpp>

#include <arcspan_c/draw_format.hpp>

arcspan::Status arcspan::c::draw_gray8(arcspan_view& view, const arcspan_target& target) {
  return draw_format<Gray8>(view, target);
}
#endif
