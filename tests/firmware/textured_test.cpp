// SPDX-License-Identifier: MIT
// Draws the textured frames in what memory the board has and prints their hashes, which must be those of the
// host.
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/stack.hpp>

#include <tests/frames/textured_frames.hpp>

using namespace arcspan;

namespace {

[[gnu::section(".bss.frame")]] constinit scenes::TexturedSpace<ARCSPAN_BAND_ROWS> space{};

}  // namespace

int main() {
  int failures = 0;
  scenes::textured_frames(space, [&](const char* name, Status status, std::uint32_t hash) {
    if (!ok(status)) ++failures;
    bare::print_line("frame textured ", name, " ", to_string(status), " ", bare::Hex{hash});
  });
  bare::print_line("stack: ", bare::deepest_stack(), " of ", bare::stack_size(), " bytes");
  return failures;
}
