// SPDX-License-Identifier: MIT
// A stack that is used up must be noticed, by a fault or at the latest when main() returns.
#include <arcspan/bare/stack.hpp>

#include <cstdint>

namespace {

/// Handing down its frame keeps the compiler from making a loop of the recursion.
[[gnu::noipa, gnu::noinline]] std::uint32_t dig(std::uint32_t depth, const volatile std::uint32_t* above) {
  volatile std::uint32_t frame[16];
  for (std::uint32_t i = 0; i < 16; ++i) frame[i] = above[i] + depth;
  return depth == 0 ? 0 : frame[depth & 15u] + dig(depth - 1, frame);
}

}  // namespace

int main() {
  // Each level takes at least 64 bytes, so the last ones lie below the stack's bottom.
  const volatile std::uint32_t first[16] = {1};
  return dig(arcspan::bare::stack_size() / 64, first) == 0 ? 1 : 0;
}
