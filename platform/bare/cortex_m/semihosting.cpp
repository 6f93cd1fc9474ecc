// SPDX-License-Identifier: MIT
// Console and exit through the debugger or emulator ("Semihosting for AArch32 and AArch64", Arm, 2.0:
// operations SYS_WRITE0, SYS_EXIT_EXTENDED; on M-profile the trap is BKPT 0xAB).
#include <arcspan/bare/board.hpp>

#include <cstdint>

namespace arcspan::bare {
namespace {

constexpr std::uint32_t kSysWrite0 = 0x04;
constexpr std::uint32_t kSysExitExtended = 0x20;
constexpr std::uint32_t kReasonApplicationExit = 0x20026;

void semihosting(std::uint32_t operation, const void* argument) {
  register std::uint32_t r0 __asm("r0") = operation;
  register const void* r1 __asm("r1") = argument;
  __asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

}  // namespace

void write(const char* text) { semihosting(kSysWrite0, text); }

void leave(int status) {
  const std::uint32_t block[2] = {kReasonApplicationExit, static_cast<std::uint32_t>(status)};
  semihosting(kSysExitExtended, block);
  for (;;) {
  }
}

}  // namespace arcspan::bare
