# SPDX-License-Identifier: MIT
# 32-bit RISC-V with multiply and compressed instructions, no floating point.
#
# Debian's riscv64-unknown-elf-g++ comes without C++ headers; those of libstdc++ go over the C headers of picolibc
# (picolibc-riscv64-unknown-elf), of which nothing is linked either.
set(CMAKE_SYSTEM_PROCESSOR riscv32)
# Few instructions in a core that issues one at a time: docs/decisions/0008-compiler-flags.md.
set(ARCSPAN_SPEED_FLAGS "-mtune=size -fno-schedule-insns -frename-registers")
include(${CMAKE_CURRENT_LIST_DIR}/bare-metal.cmake)

include(${CMAKE_CURRENT_LIST_DIR}/libstdcxx-headers.cmake)
set(ARCSPAN_C_HEADERS /usr/lib/picolibc/riscv64-unknown-elf/include CACHE PATH "Headers of a C library for RISC-V")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES ARCSPAN_C_HEADERS)

set(CMAKE_CXX_COMPILER riscv64-unknown-elf-g++)
set(CMAKE_ASM_COMPILER riscv64-unknown-elf-g++)
set(arcspan_riscv_flags "-march=rv32imc -mabi=ilp32 -mcmodel=medany")
string(CONCAT CMAKE_CXX_FLAGS_INIT "${arcspan_riscv_flags} -ffreestanding -isystem ${ARCSPAN_CXX_HEADERS}"
              " -isystem ${ARCSPAN_CXX_HEADERS}/arm-none-eabi -isystem ${ARCSPAN_C_HEADERS}")
set(CMAKE_ASM_FLAGS_INIT "${arcspan_riscv_flags}")
