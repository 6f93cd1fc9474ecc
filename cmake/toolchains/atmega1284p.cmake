# SPDX-License-Identifier: MIT
# ATmega1284P: 8-bit AVR with 128 KB flash, the largest whose return addresses have 2 bytes, and 16 KB RAM.
set(ARCSPAN_AVR_CHIP atmega1284p)
include(${CMAKE_CURRENT_LIST_DIR}/avr.cmake)
