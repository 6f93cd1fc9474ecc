// SPDX-License-Identifier: MIT
// ticks() from TIMER0 of the nRF51, since its Cortex-M0 has no SysTick (nRF51 Series Reference Manual, 18:
// TIMER). A tick is 1/16 us: one processor cycle on the board, 62.5 instructions in the emulator's
// deterministic mode.
#include <arcspan/bare/board.hpp>
#include <arcspan/bare/registers.hpp>

namespace arcspan::bare {
namespace {

constexpr std::uint32_t kTimer0 = 0x40008000;
constexpr std::uint32_t kTaskStart = kTimer0 + 0x000;
constexpr std::uint32_t kTaskCapture0 = kTimer0 + 0x040;
constexpr std::uint32_t kMode = kTimer0 + 0x504;
constexpr std::uint32_t kBitMode = kTimer0 + 0x508;
constexpr std::uint32_t kPrescaler = kTimer0 + 0x510;
constexpr std::uint32_t kCapture0 = kTimer0 + 0x540;
constexpr std::uint32_t kModeTimer = 0;
constexpr std::uint32_t kBitMode32 = 3;

}  // namespace

void initialise_board() {
  reg32(kMode) = kModeTimer;
  reg32(kBitMode) = kBitMode32;
  reg32(kPrescaler) = 0;
  reg32(kTaskStart) = 1;
}

/// Wraps after 268 s; the upper 32 bits are always 0.
std::uint64_t ticks() {
  reg32(kTaskCapture0) = 1;
  return reg32(kCapture0);
}

}  // namespace arcspan::bare
