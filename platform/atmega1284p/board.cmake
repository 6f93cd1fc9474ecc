# SPDX-License-Identifier: MIT
# Microchip ATmega1284P: 8-bit AVR, 128 KB flash, 16 KB RAM, at 20 MHz.
set(ARCSPAN_BOARD_TOOLCHAIN atmega1284p)
set(ARCSPAN_BOARD_EMULATOR simavr -m atmega1284p -f 20000000)
set(ARCSPAN_BOARD_SOURCES ${ARCSPAN_BARE}/avr/start.cpp usart_console.cpp)
set(ARCSPAN_BOARD_LINKER_SCRIPT ${ARCSPAN_BARE}/avr/stack.ld)
# The scenes of tests/firmware draw this many rows at once and cache this many transformed vertices.
set(ARCSPAN_BOARD_BAND_ROWS 8)
set(ARCSPAN_BOARD_CACHED_VERTICES 0)
# RAM holds only the smallest mesh, flash only a few shading methods. The processor has no fault exceptions.
set(ARCSPAN_BOARD_SMALL ON)
