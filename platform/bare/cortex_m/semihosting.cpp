// SPDX-License-Identifier: MIT
// Console and exit through the debugger or emulator ("Semihosting for AArch32 and AArch64", Arm, 2.0:
// operations SYS_WRITE0, SYS_EXIT_EXTENDED; on M-profile the trap is BKPT 0xAB). Without one the trap is a
// HardFault, from which arcspan_fault() of start.cpp returns behind it.
#include <arcspan/bare/board.hpp>

#include <cstdint>

namespace arcspan::bare {
namespace {

constexpr std::uint32_t kSysWrite0 = 0x04;
constexpr std::uint32_t kSysExitExtended = 0x20;
constexpr std::uint32_t kReasonApplicationExit = 0x20026;

}  // namespace
}  // namespace arcspan::bare

/// Its first instruction is the trap, by which arcspan_fault() knows it.
extern "C" [[gnu::naked, gnu::noipa, gnu::noinline]] void arcspan_semihosting(std::uint32_t, const void*) {
  __asm volatile(
      "bkpt 0xab\n"
      "bx lr");
}

namespace arcspan::bare {

void write(const char* text) { arcspan_semihosting(kSysWrite0, text); }

void leave(int status) {
  const std::uint32_t block[2] = {kReasonApplicationExit, static_cast<std::uint32_t>(status)};
  arcspan_semihosting(kSysExitExtended, block);
  for (;;) {
  }
}

}  // namespace arcspan::bare
