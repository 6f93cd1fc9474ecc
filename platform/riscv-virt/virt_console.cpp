// SPDX-License-Identifier: MIT
// Console and exit of the emulator's "virt" machine: an NS16550A at 0x10000000 that is always ready, and the
// SiFive test device at 0x100000, which ends the emulation with the status in its upper 16 bits.
#include <arcspan/bare/board.hpp>
#include <arcspan/bare/registers.hpp>

namespace arcspan::bare {
namespace {

constexpr std::uint32_t kUartTransmit = 0x10000000;
constexpr std::uint32_t kTestDevice = 0x100000;
constexpr std::uint32_t kPass = 0x5555;
constexpr std::uint32_t kFail = 0x3333;

}  // namespace

void write(const char* text) {
  for (; *text != '\0'; ++text) reg8(kUartTransmit) = static_cast<std::uint8_t>(*text);
}

void leave(int status) {
  reg32(kTestDevice) = status == 0 ? kPass : kFail | (static_cast<std::uint32_t>(status) << 16);
  for (;;) {
  }
}

}  // namespace arcspan::bare
