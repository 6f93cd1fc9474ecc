// SPDX-License-Identifier: MIT
// Without a debugger a program goes on behind what it prints. It ends by a reset, which the emulator takes
// for the end; if a core locks up, the emulator aborts.
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/registers.hpp>

using namespace arcspan;

int main() {
  constexpr std::uint32_t kInterruptAndReset = 0xE000ED0C;  // AIRCR: its key, and SYSRESETREQ
  bare::print_line("nobody reads ", 1u);
  bare::print_line("this either");
  bare::reg32(kInterruptAndReset) = 0x05FA0004;
  for (;;) {
  }
}
