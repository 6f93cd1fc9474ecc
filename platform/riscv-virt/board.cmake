# SPDX-License-Identifier: MIT
# The emulator's generic RISC-V machine with one rv32 core; no real board, but a real instruction set.
set(ARCSPAN_BOARD_TOOLCHAIN rv32imc)
set(ARCSPAN_BOARD_EMULATOR qemu-system-riscv32 -machine virt -bios none)
set(ARCSPAN_BOARD_SOURCES
    ${ARCSPAN_BARE}/riscv/start.cpp ${ARCSPAN_BARE}/riscv/instret.cpp virt_console.cpp)
