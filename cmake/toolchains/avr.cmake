# SPDX-License-Identifier: MIT
# 8-bit AVR by clang. A toolchain file per chip sets ARCSPAN_AVR_CHIP (as for -mmcu) and includes this one.
#
# Debian's avr-g++ is 5.4 and ends at C++17; its linker, start-up code and libgcc serve. Clang before 19 miscompiles the
# pipeline, and every clang takes return addresses for 2 bytes: chips with more than 128 KB of flash, whose are 3, do not
# work (docs/decisions/0020-avr.md).
set(CMAKE_SYSTEM_PROCESSOR avr)
include(${CMAKE_CURRENT_LIST_DIR}/bare-metal.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/libstdcxx-headers.cmake)

set(CMAKE_CXX_COMPILER clang++-19)
# With -Os the program of arc takes 8 % more flash and does not fit 128 KB.
set(CMAKE_CXX_FLAGS_MINSIZEREL "-Oz -DNDEBUG" CACHE STRING "Flags of a build that is optimised for size")
set(CMAKE_CXX_COMPILER_TARGET avr)
set(CMAKE_AR avr-ar CACHE FILEPATH "Archiver")
set(CMAKE_RANLIB avr-ranlib CACHE FILEPATH "Indexer of archives")
# The limits of avr-libc's <stdint.h> are for C but for this; its I/O headers are not used.
string(CONCAT CMAKE_CXX_FLAGS_INIT "-mmcu=${ARCSPAN_AVR_CHIP} -D__STDC_LIMIT_MACROS -isystem ${ARCSPAN_CXX_HEADERS}"
              " -isystem ${ARCSPAN_CXX_HEADERS}/arm-none-eabi -isystem /usr/lib/avr/include")
set(CMAKE_CXX_LINK_EXECUTABLE
    "avr-g++ -mmcu=${ARCSPAN_AVR_CHIP} -nodefaultlibs <LINK_FLAGS> <OBJECTS> -o <TARGET> <LINK_LIBRARIES>")
