# SPDX-License-Identifier: MIT
# 32-bit RISC-V with multiply and compressed instructions, no floating point.
#
# Debian's riscv64-unknown-elf-g++ comes without C++ headers. The freestanding ones of libstdc++ do not depend on
# the processor, so those of the newlib packages for Arm (libstdc++-arm-none-eabi-newlib) serve, over the C
# headers of picolibc (picolibc-riscv64-unknown-elf). Only headers are taken: nothing of either is linked.
set(CMAKE_SYSTEM_PROCESSOR riscv32)
include(${CMAKE_CURRENT_LIST_DIR}/bare-metal.cmake)

file(GLOB arcspan_cxx_headers LIST_DIRECTORIES true /usr/include/newlib/c++/[0-9]*)
list(SORT arcspan_cxx_headers COMPARE NATURAL ORDER DESCENDING)
list(POP_FRONT arcspan_cxx_headers arcspan_newest_headers)
set(ARCSPAN_CXX_HEADERS "${arcspan_newest_headers}" CACHE PATH "Headers of libstdc++ (the folder that holds <concepts>)")
set(ARCSPAN_C_HEADERS /usr/lib/picolibc/riscv64-unknown-elf/include CACHE PATH "Headers of a C library for RISC-V")
# CMake re-reads this file for its compiler checks, which see no cache entries of the project.
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES ARCSPAN_CXX_HEADERS ARCSPAN_C_HEADERS)

set(CMAKE_CXX_COMPILER riscv64-unknown-elf-g++)
set(CMAKE_ASM_COMPILER riscv64-unknown-elf-g++)
set(arcspan_riscv_flags "-march=rv32imc -mabi=ilp32 -mcmodel=medany")
string(CONCAT CMAKE_CXX_FLAGS_INIT "${arcspan_riscv_flags} -ffreestanding -isystem ${ARCSPAN_CXX_HEADERS}"
              " -isystem ${ARCSPAN_CXX_HEADERS}/arm-none-eabi -isystem ${ARCSPAN_C_HEADERS}")
set(CMAKE_ASM_FLAGS_INIT "${arcspan_riscv_flags}")
