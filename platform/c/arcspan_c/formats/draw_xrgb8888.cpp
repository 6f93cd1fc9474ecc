// SPDX-License-Identifier: MIT
#include <arcspan_config.h>

#if ARCSPAN_C_XRGB8888
#include <arcspan/pixel/xrgb8888.hpp>

#include <arcspan_c/draw_format.hpp>

arcspan::Status arcspan::c::draw_xrgb8888(arcspan_view& view, const arcspan_target& target) {
  return draw_format<Xrgb8888>(view, target);
}
#endif
