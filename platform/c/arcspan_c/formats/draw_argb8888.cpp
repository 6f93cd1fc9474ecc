// SPDX-License-Identifier: MIT
#include <arcspan_config.h>

#if ARCSPAN_C_ARGB8888
#include <arcspan/pixel/argb8888.hpp>

#include <arcspan_c/draw_format.hpp>

arcspan::Status arcspan::c::draw_argb8888(arcspan_view& view, const arcspan_target& target) {
  return draw_format<Argb8888>(view, target);
}
#endif
