// SPDX-License-Identifier: MIT
// The widget of platform/lvgl on a board: its frames have the hashes of hosts. Sections for
// lvgl_cost_test.py: frames of the widget, the same rectangles drawn by arcspan.h alone, and the same areas
// refreshed without the scene.
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>
#include <arcspan/bare/run.hpp>

#include <lv_arcspan_view.h>
#include <tests/lvgl/frames.h>

using arcspan::bare::print_line;

int main() {
  if (lvgl_frames_start() != ARCSPAN_OK) return 1;
  bool same = true;
  for (std::uint32_t i = 0; i < LVGL_FRAMES; ++i) {
    arcspan_mark();
    const std::uint32_t hash = lvgl_frames_next();
    arcspan_mark();
    const std::uint32_t draws = lvgl_frames_bare();
    arcspan_mark();
    lvgl_frames_show_scene(false);
    arcspan_mark();
    lvgl_frames_again();
    arcspan_mark();
    lvgl_frames_show_scene(true);
    const bool is_right = hash == lvgl_frame_hashes[i];
    same = same && is_right;
    print_line("frame ", i, ": ", hash, is_right ? "" : ", on hosts another");
    print_line("section: frame ", i);
    print_line("section: bare ", i);
    print_line("section: taking away");
    print_line("section: without ", i);
    print_line("section: between");
    print_line("draws: ", draws);
  }
  return same ? 0 : 2;
}
