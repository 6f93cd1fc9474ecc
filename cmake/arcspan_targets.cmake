# SPDX-License-Identifier: MIT
# Flags shared by every target of the project. Consumers inherit none of them.

# Warnings for our own code, on every target that is linked with it.
add_library(arcspan_warnings INTERFACE)
target_compile_options(
  arcspan_warnings
  INTERFACE -Wall
            -Wextra
            -Wpedantic
            -Wconversion
            -Wsign-conversion
            -Wshadow
            $<$<COMPILE_LANGUAGE:CXX>:-Wold-style-cast>
            -Wcast-align
            -Wundef
            $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor>
            $<$<COMPILE_LANGUAGE:CXX>:-Woverloaded-virtual>
            # Not for boards: their start-up code defines what compilers and vector tables call by reserved names.
            $<$<AND:$<COMPILE_LANG_AND_ID:CXX,Clang>,$<NOT:$<BOOL:${ARCSPAN_BOARD}>>>:-Wreserved-identifier>
            # gcc 12 sees overlapping copies in "literal" + std::string where there are none (its bug 105651).
            $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
            $<$<BOOL:${ARCSPAN_WERROR}>:-Werror>)

# For what nothing runs for long: it compiles in two thirds of the time, in a quarter where sanitizers are on.
add_library(arcspan_cold INTERFACE)
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize=")
  set(ARCSPAN_IS_SANITIZED ON)
  target_compile_options(arcspan_cold INTERFACE -O0)
else()
  target_compile_options(arcspan_cold INTERFACE $<$<CONFIG:Release>:-O1>)
endif()

# What the bar for pipeline/ and hal/ demands of the compiler: no exceptions, no RTTI, no guard variables.
add_library(arcspan_embedded INTERFACE)
target_compile_options(arcspan_embedded INTERFACE -fno-exceptions -fno-rtti -fno-threadsafe-statics
                                                  -ffunction-sections -fdata-sections
                                                  $<$<BOOL:${ARCSPAN_FORBID_FLOAT}>:-mgeneral-regs-only>)

# Declares a library of the project: arcspan_library(NAME DIRECTORY) gives the target arcspan_NAME with the
# alias arcspan::NAME, whose public headers live in DIRECTORY/arcspan.
function(arcspan_library name)
  add_library(arcspan_${name} STATIC)
  add_library(arcspan::${name} ALIAS arcspan_${name})
  set_target_properties(arcspan_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(arcspan_${name} PUBLIC cxx_std_20)
  set_target_properties(arcspan_${name} PROPERTIES CXX_EXTENSIONS OFF)
  if(ARCSPAN_LIBRARY_UNITY)
    set_target_properties(arcspan_${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  endif()
  target_include_directories(
    arcspan_${name} PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}>
                           $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(arcspan_${name} PRIVATE $<BUILD_INTERFACE:arcspan_warnings>
                                                $<BUILD_INTERFACE:arcspan_embedded>)
endfunction()
