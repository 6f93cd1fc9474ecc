// SPDX-License-Identifier: MIT
// Reset and faults of Cortex-M (Armv6-M and Armv7-M Architecture Reference Manuals, B1.5: exception model).
// The FPU of a Cortex-M4F or M7 stays off, as it is after reset: a floating-point instruction faults.
#include "start.hpp"

#include <arcspan/bare/board.hpp>
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/memory_map.hpp>
#include <arcspan/bare/run.hpp>

namespace arcspan::bare {
namespace {

const char* exception_name(std::uint32_t number) {
  switch (number) {
    case 2:
      return "NMI";
    case 3:
      return "HardFault";
    case 4:
      return "MemManage";
    case 5:
      return "BusFault";
    case 6:
      return "UsageFault";
    default:
      return "unexpected exception";
  }
}

/// `frame` points to the stacked registers r0-r3, r12, lr, pc, xpsr, unless the stack overflowed.
[[noreturn, gnu::used]] void report_fault(const std::uint32_t* frame) {
  std::uint32_t number;
  __asm volatile("mrs %0, ipsr" : "=r"(number));
  print("fault: ");
  print(exception_name(number));
  if (frame < arcspan_stack_bottom) {
    print_line(", stack overflow");
    leave(kExitStackOverflow);
  }
  print_line(" at ", Hex{frame[6]}, ", called from ", Hex{frame[5]});
  leave(kExitFault);
}

}  // namespace
}  // namespace arcspan::bare

extern "C" {

[[noreturn]] void arcspan_reset() { arcspan::bare::run(); }

/// Skips the trap of semihosting.cpp, which faults without a debugger, so that a program goes on and what it
/// prints is lost. Any other fault is reported; without a debugger the report locks the core up. Resets the
/// stack pointer before, because a stack overflow may be the cause.
[[gnu::naked]] void arcspan_fault() {
  __asm volatile(
      ".syntax unified\n"
      ".weak arcspan_semihosting\n"  // a board may have another console
      "mrs r0, msp\n"
      "ldr r1, =arcspan_stack_bottom\n"
      "cmp r0, r1\n"
      "blo 1f\n"
      "ldr r2, [r0, #24]\n"  // the stacked pc
      "ldr r1, =arcspan_semihosting\n"
      "subs r1, #1\n"  // without the bit of Thumb
      "cmp r1, r2\n"
      "bne 1f\n"
      "adds r2, #2\n"
      "str r2, [r0, #24]\n"
      "bx lr\n"
      "1:\n"
      "ldr r1, =arcspan_stack_top\n"
      "mov sp, r1\n"
      "ldr r1, =%c0\n"
      "bx r1\n"
      ".ltorg" ::"i"(&arcspan::bare::report_fault));
}

/// A board whose counter uses the SysTick interrupt replaces this.
[[gnu::weak]] void arcspan_systick() { arcspan_fault(); }

/// Initial stack pointer, reset, exceptions 2 ... 15. Interrupts are never enabled.
[[gnu::section(".vectors"), gnu::used]] const arcspan::bare::Vector arcspan_vectors[16] = {
    {.stack = arcspan_stack_top},
    {arcspan_reset},
    {arcspan_fault},
    {arcspan_fault},
    {arcspan_fault},
    {arcspan_fault},
    {arcspan_fault},
    {arcspan_fault},
    {arcspan_fault},
    {arcspan_fault},
    {arcspan_fault},
    {arcspan_fault},
    {arcspan_fault},
    {arcspan_fault},
    {arcspan_fault},
    {arcspan_systick}};
}
