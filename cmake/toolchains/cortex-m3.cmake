# SPDX-License-Identifier: MIT
# Armv7-M: Thumb-2, hardware divide, 64-bit product.
# Scheduling before registers are given out needs more of them than there are, and this core issues in order.
set(ARCSPAN_CORE_FLAGS "-mcpu=cortex-m3 -fno-schedule-insns")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
