// SPDX-License-Identifier: MIT
// Sections whose number of instructions is known, for count_test.py.
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>

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

}  // namespace

int main() {
  measure(1);
  measure(1001);
  measure(100001);
  return 0;
}
