// SPDX-License-Identifier: MIT
// Console, exit and counter of an ATmega1284P (data sheet, 19: USART0, 16: Timer/Counter1). The console has 8
// data bits and one stop bit at an eighth of the clock. The exit status is the last line of the output,
// because simavr does not return one.
#include <arcspan/bare/board.hpp>
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/registers.hpp>

namespace arcspan::bare {
namespace {

constexpr std::uintptr_t kUsartStatus = 0xC0;   // UCSR0A
constexpr std::uintptr_t kUsartControl = 0xC1;  // UCSR0B
constexpr std::uintptr_t kUsartData = 0xC6;     // UDR0
constexpr std::uint8_t kTransmitted = 0x40;     // TXC0
constexpr std::uint8_t kTransmitEmpty = 0x20;   // UDRE0
constexpr std::uint8_t kDoubleSpeed = 0x02;     // U2X0
constexpr std::uint8_t kTransmit = 0x08;        // TXEN0

constexpr std::uintptr_t kTimerFlags = 0x36;       // TIFR1
constexpr std::uintptr_t kTimerInterrupts = 0x6F;  // TIMSK1
constexpr std::uintptr_t kTimerControl = 0x81;     // TCCR1B
constexpr std::uintptr_t kTimerCountLow = 0x84;    // TCNT1L; reading it latches TCNT1H
constexpr std::uintptr_t kTimerCountHigh = 0x85;   // TCNT1H
constexpr std::uint8_t kOverflow = 0x01;           // TOV1, TOIE1
constexpr std::uint8_t kCountCycles = 0x01;        // CS10
constexpr std::uintptr_t kSleepControl = 0x53;     // SMCR
constexpr std::uint8_t kSleepEnabled = 0x01;       // SE
constexpr std::uint8_t kPowerDown = 0x04;          // SM1

volatile std::uint32_t overflows;

}  // namespace

void initialise_board() {
  reg8(kUsartStatus) = kDoubleSpeed;
  reg8(kUsartControl) = kTransmit;
  reg8(kTimerInterrupts) = kOverflow;
  reg8(kTimerControl) = kCountCycles;
  __asm volatile("sei");
}

void write(const char* text) {
  for (; *text != '\0'; ++text) {
    while ((reg8(kUsartStatus) & kTransmitEmpty) == 0) {
    }
    reg8(kUsartStatus) = kTransmitted | kDoubleSpeed;  // writing 1 clears it
    reg8(kUsartData) = static_cast<std::uint8_t>(*text);
  }
}

void leave(int status) {
  print_line("exit: ", static_cast<std::uint32_t>(status));
  while ((reg8(kUsartStatus) & kTransmitted) == 0) {
  }
  reg8(kSleepControl) = kPowerDown | kSleepEnabled;
  for (;;) __asm volatile("cli\n sleep");  // it never wakes without interrupts, and the simulator ends
}

/// Unit: processor cycles.
std::uint64_t ticks() {
  __asm volatile("cli" ::: "memory");
  std::uint32_t high = overflows;
  const std::uint32_t low_byte = reg8(kTimerCountLow);
  const std::uint32_t count = low_byte | (std::uint32_t{reg8(kTimerCountHigh)} << 8);
  // An overflow may have happened whose interrupt is still pending.
  if ((reg8(kTimerFlags) & kOverflow) != 0 && count < 0x8000u) ++high;
  __asm volatile("sei" ::: "memory");
  return (std::uint64_t{high} << 16) | count;
}

}  // namespace arcspan::bare

/// Timer/Counter1 overflow: vector 16 in the data sheet's table 11-1, 15 in names, which count from 0.
extern "C" __attribute__((signal, used)) void __vector_15() {
  arcspan::bare::overflows = arcspan::bare::overflows + 1;
}
