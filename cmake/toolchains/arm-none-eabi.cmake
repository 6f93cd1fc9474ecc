# SPDX-License-Identifier: MIT
# GNU Arm Embedded. A toolchain file per core sets ARCSPAN_CORE_FLAGS, perhaps ARCSPAN_CXX_FLAGS, and includes this one.
set(CMAKE_SYSTEM_PROCESSOR arm)
include(${CMAKE_CURRENT_LIST_DIR}/bare-metal.cmake)

set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_ASM_COMPILER arm-none-eabi-g++)
set(CMAKE_CXX_FLAGS_INIT "-mthumb ${ARCSPAN_CORE_FLAGS} -ffreestanding ${ARCSPAN_CXX_FLAGS}")
set(CMAKE_ASM_FLAGS_INIT "-mthumb ${ARCSPAN_CORE_FLAGS}")
