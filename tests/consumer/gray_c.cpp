// SPDX-License-Identifier: MIT
// What Kconfig has chosen reaches the program: its settings are those of the library.
#include <arcspan.h>
#include <arcspan_config.h>

static_assert(ARCSPAN_C_LIGHTS == 2 && ARCSPAN_C_FLAT == 1 && ARCSPAN_C_ARC == 0 &&
              ARCSPAN_C_CHARACTERS == 1);
static_assert(ARCSPAN_C_GRAY8 == 1 && ARCSPAN_C_RGB565 == 0);

arcspan_status draw_gray(arcspan_view* view, const arcspan_target* target) {
  return arcspan_draw(view, target);
}
