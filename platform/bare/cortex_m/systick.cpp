// SPDX-License-Identifier: MIT
// ticks() from SysTick (Armv7-M Architecture Reference Manual, B3.3). On a board a tick is a processor cycle.
// In the emulator's deterministic mode (-icount shift=0) an instruction takes 1 ns, so a tick is as many
// instructions as the period of the processor clock has nanoseconds.
#include <arcspan/bare/board.hpp>
#include <arcspan/bare/registers.hpp>

namespace arcspan::bare {
namespace {

constexpr std::uint32_t kControl = 0xE000E010;
constexpr std::uint32_t kReload = 0xE000E014;
constexpr std::uint32_t kValue = 0xE000E018;
constexpr std::uint32_t kEnableWithInterruptFromProcessorClock = 7;
constexpr std::uint32_t kMaximum = 0xFFFFFF;

volatile std::uint32_t wraps = 0;

}  // namespace

void initialise_board() {
  reg32(kReload) = kMaximum;
  reg32(kValue) = 0;
  reg32(kControl) = kEnableWithInterruptFromProcessorClock;
}

std::uint64_t ticks() {
  std::uint32_t before;
  std::uint32_t value;
  do {
    before = wraps;
    value = reg32(kValue);
  } while (before != wraps);  // repeat if an interrupt came between the two reads
  return (static_cast<std::uint64_t>(before) << 24) | (kMaximum - value);
}

}  // namespace arcspan::bare

extern "C" void arcspan_systick() { arcspan::bare::wraps = arcspan::bare::wraps + 1; }
