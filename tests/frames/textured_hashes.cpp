// SPDX-License-Identifier: MIT
// Prints the hashes of the textured frames, drawn at once, or in bands if an argument is given;
// tests/frames/textured_hashes.txt is its output.
#include <tests/frames/textured_frames.hpp>

#include <cstdio>

namespace {

template <std::int32_t Rows>
int print_hashes() {
  static arcspan::scenes::TexturedSpace<Rows> space;  // too large for the stack
  int failures = 0;
  arcspan::scenes::textured_frames(space, [&](const char* name, arcspan::Status status, std::uint32_t hash) {
    if (!arcspan::ok(status)) ++failures;
    std::printf("frame textured %s %s %08x\n", name, arcspan::to_string(status), static_cast<unsigned>(hash));
  });
  return failures;
}

}  // namespace

int main(int argc, char**) { return argc > 1 ? print_hashes<8>() : print_hashes<arcspan::scenes::kHeight>(); }
