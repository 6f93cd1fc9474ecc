# SPDX-License-Identifier: MIT
# arcspan as a component of ESP-IDF 5.1 or newer (gcc 12). ESP-IDF reads this file twice: first as a script that ends at
# the registration, then for the build.
get_filename_component(arcspan_root ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)
file(GLOB_RECURSE arcspan_sources ${arcspan_root}/pipeline/arcspan/*.cpp ${arcspan_root}/hal/arcspan/*.cpp)
# Simulated displays run on hosts only.
list(FILTER arcspan_sources EXCLUDE REGEX "/hal/arcspan/hal/sim/")
idf_component_register(SRCS ${arcspan_sources} INCLUDE_DIRS pipeline hal)
target_compile_features(${COMPONENT_LIB} PUBLIC cxx_std_20)
