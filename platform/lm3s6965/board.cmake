# SPDX-License-Identifier: MIT
# Stellaris LM3S6965 evaluation board: Cortex-M3, 256 KB flash, 64 KB RAM, SSD0323 OLED on SSI0.
set(ARCSPAN_BOARD_TOOLCHAIN cortex-m3)
set(ARCSPAN_BOARD_EMULATOR qemu-system-arm -machine lm3s6965evb)
set(ARCSPAN_BOARD_SOURCES
    ${ARCSPAN_BARE}/cortex_m/start.cpp ${ARCSPAN_BARE}/cortex_m/semihosting.cpp ${ARCSPAN_BARE}/cortex_m/systick.cpp ssi.cpp)
# The scenes of tests/firmware draw this many rows at once and cache this many transformed vertices.
set(ARCSPAN_BOARD_BAND_ROWS 24)
set(ARCSPAN_BOARD_CACHED_VERTICES 500)
