# SPDX-License-Identifier: MIT
# Armv7-M: Thumb-2, hardware divide, 64-bit product. Scheduling before registers are given out makes rows and
# pixels spill (docs/decisions/0008-compiler-flags.md).
set(ARCSPAN_CORE_FLAGS "-mcpu=cortex-m3")
set(ARCSPAN_CXX_FLAGS "-fno-schedule-insns")
set(ARCSPAN_SPEED_FLAGS "-frename-registers")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
