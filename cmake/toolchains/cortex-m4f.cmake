# SPDX-License-Identifier: MIT
# Armv7E-M with single-precision FPU. The FPU stays unused, even for moves, and start-up
# leaves it off, so that using it would fault.
# Scheduling before registers are given out needs more of them than there are, and this core issues in order.
set(ARCSPAN_CORE_FLAGS "-mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16 -mgeneral-regs-only -fno-schedule-insns")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
