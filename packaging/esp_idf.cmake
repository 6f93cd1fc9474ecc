# SPDX-License-Identifier: MIT
# arcspan as a component of ESP-IDF 5.1 or newer (gcc 12). ESP-IDF reads this file twice: first as a script that ends at
# the registration, then for the build.
get_filename_component(arcspan_root ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)
file(GLOB_RECURSE arcspan_sources ${arcspan_root}/pipeline/arcspan/*.cpp ${arcspan_root}/hal/arcspan/*.cpp)
# Simulated displays run on hosts only.
list(FILTER arcspan_sources EXCLUDE REGEX "/hal/arcspan/hal/sim/")
include(${CMAKE_CURRENT_LIST_DIR}/c_interface.cmake)
idf_component_register(SRCS ${arcspan_sources} ${arcspan_c_sources} INCLUDE_DIRS pipeline hal platform/c
                       KCONFIG ${CMAKE_CURRENT_LIST_DIR}/c_interface.kconfig)
target_compile_features(${COMPONENT_LIB} PUBLIC cxx_std_20)
target_compile_definitions(${COMPONENT_LIB} PUBLIC ${arcspan_c_definitions})
