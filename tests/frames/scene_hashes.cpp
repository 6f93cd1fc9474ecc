// SPDX-License-Identifier: MIT
// Prints the hashes of the golden frames, drawn at once, or in bands if an argument is given;
// tests/frames/hashes.txt is its output.
#include <tests/frames/golden_frames.hpp>

#include <cstdio>

namespace {

template <class Space>
int print_hashes() {
  static Space space;  // too large for the stack
  int failures = 0;
  arcspan::scenes::golden_frames(
      space, [&](const char* shape, const char* method, arcspan::Status status, std::uint32_t hash) {
        if (!arcspan::ok(status)) ++failures;
        std::printf("frame %s %s %s %08x\n", shape, method, arcspan::to_string(status),
                    static_cast<unsigned>(hash));
      });
  return failures;
}

}  // namespace

int main(int argc, char**) {
  return argc > 1 ? print_hashes<arcspan::scenes::Workspace<8, 0>>()
                  : print_hashes<arcspan::scenes::Workspace<arcspan::scenes::kHeight, 500>>();
}
