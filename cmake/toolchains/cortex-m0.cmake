# SPDX-License-Identifier: MIT
# Armv6-M: no divide instruction, 32-bit product only, 16-bit Thumb.
set(ARCSPAN_CORE_FLAGS "-mcpu=cortex-m0")
set(ARCSPAN_SPEED_FLAGS "-frename-registers -fira-algorithm=priority -fno-if-conversion") # docs/decisions/0008-compiler-flags.md
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
