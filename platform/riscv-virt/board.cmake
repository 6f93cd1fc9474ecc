# SPDX-License-Identifier: MIT
# The emulator's generic RISC-V machine with one rv32 core. The board does not exist, its instruction set does.
set(ARCSPAN_BOARD_TOOLCHAIN rv32imc)
set(ARCSPAN_BOARD_EMULATOR qemu-system-riscv32 -machine virt -bios none)
set(ARCSPAN_BOARD_SOURCES
    ${ARCSPAN_BARE}/riscv/start.cpp ${ARCSPAN_BARE}/riscv/instret.cpp virt_console.cpp)
# The scenes of tests/firmware draw this many rows at once and cache this many transformed vertices.
set(ARCSPAN_BOARD_BAND_ROWS 120)
set(ARCSPAN_BOARD_CACHED_VERTICES 500)
