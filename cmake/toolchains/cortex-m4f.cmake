# SPDX-License-Identifier: MIT
# Armv7E-M with single-precision FPU; start-up leaves the FPU off, so using it would fault.
set(ARCSPAN_CORE_FLAGS "-mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
