// SPDX-License-Identifier: MIT
#include <arcspan/bare/board.hpp>
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/memory_map.hpp>
#include <arcspan/bare/run.hpp>
#include <arcspan/bare/stack.hpp>

// Refers to main() by its symbol, because C++ forbids calling it.
extern "C" int arcspan_program() __asm("main");

namespace arcspan::bare {
namespace {

void set_up_memory() {
  const std::uint32_t* from = arcspan_data_image;
  for (std::uint32_t* word = arcspan_data_begin; word < arcspan_data_end; ++word) *word = *from++;
  for (std::uint32_t* word = arcspan_bss_begin; word < arcspan_bss_end; ++word) *word = 0;
}

}  // namespace

void run() {
  set_up_memory();
  paint_stack();
  initialise_board();
  const int status = arcspan_program();
  if (deepest_stack() >= stack_size()) {
    print_line("stack overflow: all of its ", stack_size(), " bytes were written");
    leave(kExitStackOverflow);
  }
  if (deepest_stack() > stack_limit()) {
    print_line("stack limit: ", deepest_stack(), " bytes were used, ", stack_limit(), " are allowed");
    leave(kExitStackOverflow);
  }
  leave(status);
}

}  // namespace arcspan::bare
