# SPDX-License-Identifier: MIT
# Armv7E-M with double-precision FPU; start-up leaves the FPU off, so using it would fault.
set(ARCSPAN_CORE_FLAGS "-mcpu=cortex-m7 -mfloat-abi=hard -mfpu=fpv5-d16")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
