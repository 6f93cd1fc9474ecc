// SPDX-License-Identifier: MIT
#include <arcspan_config.h>

#if ARCSPAN_C_MONO
#include <arcspan/pixel/mono.hpp>

#include <arcspan_c/draw_format.hpp>

arcspan::Status arcspan::c::draw_mono(arcspan_view& view, const arcspan_target& target) {
  return draw_format<Mono>(view, target);
}
#endif
