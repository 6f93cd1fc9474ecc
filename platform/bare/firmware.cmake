# SPDX-License-Identifier: MIT
# Functions that build programs for the board ARCSPAN_BOARD (a folder of platform/), linked with libgcc only, and run
# them in its emulator.
set(ARCSPAN_BARE ${CMAKE_CURRENT_LIST_DIR})
set(ARCSPAN_BOARD_FOLDER ${PROJECT_SOURCE_DIR}/platform/${ARCSPAN_BOARD})
if(NOT EXISTS ${ARCSPAN_BOARD_FOLDER}/board.cmake)
  message(FATAL_ERROR "ARCSPAN_BOARD: there is no platform/${ARCSPAN_BOARD}/board.cmake")
endif()
set(ARCSPAN_BOARD_LINKER_SCRIPT ${ARCSPAN_BARE}/sections.ld)
include(${ARCSPAN_BOARD_FOLDER}/board.cmake)
list(TRANSFORM ARCSPAN_BOARD_SOURCES PREPEND ${ARCSPAN_BOARD_FOLDER}/ REGEX "^[^/]+$")

# Last on every link line, because the libraries before it need it.
set(CMAKE_CXX_STANDARD_LIBRARIES "-lgcc")

# The board layer is an object library, so that the linker always includes the vector table.
add_library(
  arcspan_board OBJECT
  ${ARCSPAN_BOARD_SOURCES} ${ARCSPAN_BARE}/console.cpp ${ARCSPAN_BARE}/mark.cpp ${ARCSPAN_BARE}/memory_functions.cpp ${ARCSPAN_BARE}/run.cpp
  ${ARCSPAN_BARE}/stack.cpp)
target_compile_features(arcspan_board PUBLIC cxx_std_20)
set_target_properties(arcspan_board PROPERTIES CXX_EXTENSIONS OFF)
target_include_directories(arcspan_board PUBLIC ${ARCSPAN_BARE} ${ARCSPAN_BOARD_FOLDER})
target_link_libraries(arcspan_board PUBLIC arcspan_embedded arcspan_warnings arcspan::hal arcspan::pipeline)
set_source_files_properties(
  ${ARCSPAN_BARE}/memory_functions.cpp
  PROPERTIES COMPILE_OPTIONS $<IF:$<CXX_COMPILER_ID:GNU>,-fno-tree-loop-distribute-patterns,-fno-builtin>)
if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
  # Only GCC knows noipa. The sources add noinline for clang.
  target_compile_options(arcspan_board PUBLIC -Wno-unknown-attributes)
endif()

# arcspan_firmware(NAME SOURCES...): builds a program for the board.
function(arcspan_firmware name)
  add_executable(${name} ${ARGN})
  set_target_properties(${name} PROPERTIES SUFFIX .elf CXX_EXTENSIONS OFF LINK_DEPENDS
                                                       "${ARCSPAN_BOARD_LINKER_SCRIPT};${ARCSPAN_BOARD_FOLDER}/memory.ld")
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE arcspan_board)
  target_link_options(${name} PRIVATE -Wl,--gc-sections -Wl,--fatal-warnings -Wl,-L,${ARCSPAN_BOARD_FOLDER} -Wl,-Map,${name}.map)
  if(CMAKE_SYSTEM_PROCESSOR STREQUAL avr)
    # Added to avr-g++'s default linker script for the chip and its start-up code.
    target_link_options(${name} PRIVATE ${ARCSPAN_BOARD_LINKER_SCRIPT})
  else()
    target_link_options(${name} PRIVATE -nostdlib -T ${ARCSPAN_BOARD_LINKER_SCRIPT})
  endif()
endfunction()

# arcspan_firmware_test(NAME PROGRAM [ARGUMENTS of run-firmware...]): runs a program in the board's emulator.
function(arcspan_firmware_test name program)
  add_test(NAME firmware.${ARCSPAN_BOARD}.${name}
           COMMAND ${PROJECT_SOURCE_DIR}/platform/qemu/run-firmware ${ARGN} $<TARGET_FILE:${program}> -- ${ARCSPAN_BOARD_EMULATOR})
  set_tests_properties(firmware.${ARCSPAN_BOARD}.${name} PROPERTIES LABELS firmware TIMEOUT 120)
endfunction()
