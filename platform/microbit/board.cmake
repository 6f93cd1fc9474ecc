# SPDX-License-Identifier: MIT
# BBC micro:bit: nRF51822, Cortex-M0, 256 KB flash, 16 KB RAM.
set(ARCSPAN_BOARD_TOOLCHAIN cortex-m0)
set(ARCSPAN_BOARD_EMULATOR qemu-system-arm -machine microbit)
set(ARCSPAN_BOARD_SOURCES
    ${ARCSPAN_BARE}/cortex_m/start.cpp ${ARCSPAN_BARE}/cortex_m/semihosting.cpp nrf51_timer.cpp)
# The scenes of tests/firmware draw this many rows at once and cache this many transformed vertices.
set(ARCSPAN_BOARD_BAND_ROWS 8)
set(ARCSPAN_BOARD_CACHED_VERTICES 0)
