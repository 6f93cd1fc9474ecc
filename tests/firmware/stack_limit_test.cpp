// SPDX-License-Identifier: MIT
// A program that uses more of its stack than the board's limit, but not all of it, must leave with the status
// of an overflow.
#include <arcspan/bare/stack.hpp>

#include <cstdint>

namespace {

/// Goes down until `first` is more than the limit away.
[[gnu::noipa, gnu::noinline]] std::uint32_t dig(const volatile std::uint8_t* first) {
  volatile std::uint8_t frame[16];
  for (volatile std::uint8_t& byte : frame) byte = 1;
  const std::uintptr_t used =
      reinterpret_cast<std::uintptr_t>(first) - reinterpret_cast<std::uintptr_t>(&frame);
  return frame[0] + (used > arcspan::bare::stack_limit() ? 0u : dig(first));
}

}  // namespace

int main() {
  const volatile std::uint8_t first = 0;
  return dig(&first) == 0 ? 1 : 0;
}
