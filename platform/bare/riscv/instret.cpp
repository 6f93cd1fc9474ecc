// SPDX-License-Identifier: MIT
// ticks() from minstret (RISC-V Instruction Set Manual, volume II, 3.1.10). A tick is a retired instruction,
// exact in the emulator.
#include <arcspan/bare/board.hpp>

__asm(".option arch, +zicsr");

namespace arcspan::bare {

void initialise_board() {}

std::uint64_t ticks() {
  std::uint32_t high;
  std::uint32_t low;
  std::uint32_t again;
  do {
    __asm volatile("csrr %0, minstreth\n csrr %1, minstret\n csrr %2, minstreth"
                   : "=r"(high), "=r"(low), "=r"(again));
  } while (high != again);
  return (static_cast<std::uint64_t>(high) << 32) | low;
}

}  // namespace arcspan::bare
