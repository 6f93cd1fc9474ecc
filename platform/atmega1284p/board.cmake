# SPDX-License-Identifier: MIT
# Microchip ATmega1284P: 8-bit AVR, 128 KB flash, 16 KB RAM, at 20 MHz.
set(ARCSPAN_BOARD_TOOLCHAIN atmega1284p)
set(ARCSPAN_BOARD_EMULATOR simavr -m atmega1284p -f 20000000)
set(ARCSPAN_BOARD_SOURCES ${ARCSPAN_BARE}/avr/start.cpp usart_console.cpp)
set(ARCSPAN_BOARD_LINKER_SCRIPT ${ARCSPAN_BARE}/avr/stack.ld)
# Rows of a frame that are drawn at once, and transformed vertices that are kept, in the scenes of tests/firmware.
set(ARCSPAN_BOARD_BAND_ROWS 12)
set(ARCSPAN_BOARD_CACHED_VERTICES 0)
# RAM holds the smallest mesh only, and flash is filled by few methods; the processor has no faults.
set(ARCSPAN_BOARD_SMALL ON)
