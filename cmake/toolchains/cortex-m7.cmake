# SPDX-License-Identifier: MIT
# Armv7E-M with double-precision FPU. The FPU stays unused, even for moves, and start-up
# leaves it off, so that using it would fault.
set(ARCSPAN_CORE_FLAGS "-mcpu=cortex-m7 -mfloat-abi=hard -mfpu=fpv5-d16 -mgeneral-regs-only")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
