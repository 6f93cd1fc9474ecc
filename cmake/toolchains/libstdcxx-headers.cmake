# SPDX-License-Identifier: MIT
# ARCSPAN_CXX_HEADERS, for compilers that come without C++ headers. The freestanding ones of libstdc++ hardly depend on
# the processor, so those of the newlib packages for Arm (libstdc++-arm-none-eabi-newlib) serve. Only headers are taken:
# nothing is linked.
file(GLOB arcspan_cxx_headers LIST_DIRECTORIES true /usr/include/newlib/c++/[0-9]*)
list(SORT arcspan_cxx_headers COMPARE NATURAL ORDER DESCENDING)
list(POP_FRONT arcspan_cxx_headers arcspan_newest_headers)
set(ARCSPAN_CXX_HEADERS "${arcspan_newest_headers}" CACHE PATH "Headers of libstdc++ (the folder that holds <concepts>)")
# CMake re-reads toolchain files for its compiler checks, which see no cache entries of the project.
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES ARCSPAN_CXX_HEADERS)
