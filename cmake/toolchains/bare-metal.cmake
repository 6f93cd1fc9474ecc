# SPDX-License-Identifier: MIT
# What every target without an operating system has in common. Included by the toolchain files of the families.
set(CMAKE_SYSTEM_NAME Generic)
# A program cannot be linked before a board has given its memory map, so compiler checks build libraries.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

# Desk programs and host tests make no sense here.
set(ARCSPAN_TOOLS OFF CACHE BOOL "Build the arcspan command for the desk")
set(ARCSPAN_TESTS OFF CACHE BOOL "Build the tests")
set(ARCSPAN_INSTALL OFF CACHE BOOL "Generate install and export rules")

set(CMAKE_CXX_FLAGS_RELEASE_INIT "-O2")
set(CMAKE_CXX_FLAGS_MINSIZEREL_INIT "-Os")
# ARCSPAN_SPEED_FLAGS of a core are for -O2 only: most make programs a little larger.
string(STRIP "-O2 ${ARCSPAN_SPEED_FLAGS}" speed)
set(CMAKE_CXX_FLAGS_RELEASE "${speed}" CACHE STRING "Flags of a release build")
