// SPDX-License-Identifier: MIT
// Draws the golden frames in what memory the board has and prints their hashes, which must be those of the
// host.
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/stack.hpp>

#include <tests/frames/golden_frames.hpp>

using namespace arcspan;

namespace {

[[gnu::section(".bss.frame")]] constinit scenes::Workspace<ARCSPAN_BAND_ROWS, ARCSPAN_CACHED_VERTICES>
    space{};

constexpr bool wanted(int shape, int method) {
#ifdef ARCSPAN_SCENE_METHOD
  return shape == 0 && method == ARCSPAN_SCENE_METHOD;
#else
  return scenes::all_frames(shape, method);
#endif
}

}  // namespace

int main() {
  int failures = 0;
  scenes::golden_frames<wanted>(
      space, [&](const char* shape, const char* method, Status status, std::uint32_t hash) {
        if (!ok(status)) ++failures;
        bare::print_line("frame ", shape, " ", method, " ", to_string(status), " ", bare::Hex{hash});
      });
  bare::print_line("stack: ", bare::deepest_stack(), " of ", bare::stack_size(), " bytes");
  return failures;
}
