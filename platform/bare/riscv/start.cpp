// SPDX-License-Identifier: MIT
// Reset and traps of RV32 in machine mode (RISC-V Instruction Set Manual, volume II, 3.1: machine-level
// CSRs).
#include <arcspan/bare/board.hpp>
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/memory_map.hpp>
#include <arcspan/bare/run.hpp>

// The toolchain's -march omits the CSR instructions, so that a variant of libgcc matches. They are needed
// here.
__asm(".option arch, +zicsr");

extern "C" {

[[noreturn, gnu::used]] void arcspan_report_trap(std::uint32_t cause, std::uint32_t address) {
  using namespace arcspan::bare;
  print_line("fault: trap ", cause, " at ", Hex{address});
  leave(kExitFault);
}

/// Resets the stack pointer before reporting, because a stack overflow may be the cause.
[[gnu::naked, gnu::aligned(4)]] void arcspan_trap() {
  __asm volatile(
      "la sp, arcspan_stack_top\n"
      "csrr a0, mcause\n"
      "csrr a1, mepc\n"
      "j arcspan_report_trap");
}

[[noreturn, gnu::used]] void arcspan_run() { arcspan::bare::run(); }

[[gnu::naked, gnu::section(".vectors")]] void arcspan_reset() {
  __asm volatile(
      "la sp, arcspan_stack_top\n"
      "la t0, arcspan_trap\n"
      "csrw mtvec, t0\n"
      "j arcspan_run");
}
}
