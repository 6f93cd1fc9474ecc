# SPDX-License-Identifier: MIT
# Arm MPS2 with application note 385: Cortex-M3, 4 MB + 4 MB SRAM, 16 MB PSRAM for frames.
set(ARCSPAN_BOARD_TOOLCHAIN cortex-m3)
set(ARCSPAN_BOARD_EMULATOR qemu-system-arm -machine mps2-an385)
set(ARCSPAN_BOARD_SOURCES
    ${ARCSPAN_BARE}/cortex_m/start.cpp ${ARCSPAN_BARE}/cortex_m/semihosting.cpp ${ARCSPAN_BARE}/cortex_m/systick.cpp)
# The scenes of tests/firmware draw this many rows at once and cache this many transformed vertices.
set(ARCSPAN_BOARD_BAND_ROWS 120)
set(ARCSPAN_BOARD_CACHED_VERTICES 500)
