# SPDX-License-Identifier: MIT
# Armv7E-M with single-precision FPU. The FPU stays unused, even for moves, and start-up
# leaves it off, so that using it would fault. Scheduling as for cortex-m3.cmake.
set(ARCSPAN_CORE_FLAGS "-mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16 -mgeneral-regs-only")
set(ARCSPAN_CXX_FLAGS "-fno-schedule-insns")
set(ARCSPAN_SPEED_FLAGS "-frename-registers")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
