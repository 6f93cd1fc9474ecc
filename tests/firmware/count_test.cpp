// SPDX-License-Identifier: MIT
// Sections whose number of instructions is known, for count_test.py, in total and by part.
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>

/// Loops that frame_parts.py takes for those of pixels and rows, by their functions' names: 7 instructions
/// per pixel and 11 per row, and those of the loops.
namespace counted {

template <class Count>
[[gnu::always_inline]] inline void draw_pixels(Count left) {
  for (; left != 0; --left) __asm volatile("nop\n nop\n nop\n nop\n nop\n nop\n nop");
}

struct RowDrawer {
  template <class Count>
  [[gnu::always_inline]] static void draw(Count rows, Count pixels) {
    for (; rows != 0; --rows) {
      __asm volatile("nop\n nop\n nop\n nop\n nop\n nop\n nop\n nop\n nop\n nop\n nop");
      draw_pixels(pixels);
    }
  }
};

[[gnu::noipa, gnu::noinline]] void draw(unsigned rows, unsigned pixels) { RowDrawer::draw(rows, pixels); }

}  // namespace counted

namespace {

/// Two instructions a turn, whatever the compiler makes of the rest.
[[gnu::noipa, gnu::noinline]] void loop(unsigned turns) {
#if defined(__riscv)
  __asm volatile("1: addi %0, %0, -1\n bnez %0, 1b" : "+r"(turns));
#else
  __asm volatile(".syntax unified\n1: subs %0, %0, #1\n bne 1b" : "+l"(turns) : : "cc");
#endif
}

void measure(unsigned turns) {
  arcspan_mark();
  loop(turns);
  arcspan_mark();
  arcspan::bare::print_line("section: ", turns, " turns");
  arcspan::bare::print_line("section: between");
}

void measure_frame(unsigned rows, unsigned pixels) {
  arcspan_mark();
  counted::draw(rows, pixels);
  arcspan_mark();
  arcspan::bare::print_line("section: ", rows, " x ", pixels);
  arcspan::bare::print_line("section: between");
}

}  // namespace

int main() {
  measure_frame(10, 1000);
  measure_frame(10, 2000);
  measure_frame(20, 1000);
  measure(1);
  measure(1001);
  measure(100001);
  return 0;
}
