# SPDX-License-Identifier: MIT
# The emulator's generic RISC-V machine with one rv32 core; no real board, but a real instruction set.
set(ARCSPAN_BOARD_TOOLCHAIN rv32imc)
set(ARCSPAN_BOARD_EMULATOR qemu-system-riscv32 -machine virt -bios none)
set(ARCSPAN_BOARD_SOURCES
    ${ARCSPAN_BARE}/riscv/start.cpp ${ARCSPAN_BARE}/riscv/instret.cpp virt_console.cpp)
# Rows of a frame that are drawn at once, and transformed vertices that are kept, in the scenes of tests/firmware.
set(ARCSPAN_BOARD_BAND_ROWS 120)
set(ARCSPAN_BOARD_CACHED_VERTICES 500)
