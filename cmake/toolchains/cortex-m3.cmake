# SPDX-License-Identifier: MIT
# Armv7-M: Thumb-2, hardware divide, 64-bit product.
set(ARCSPAN_CORE_FLAGS "-mcpu=cortex-m3")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
