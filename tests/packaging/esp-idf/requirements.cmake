# SPDX-License-Identifier: MIT
# cmake -DARCSPAN_SOURCE_DIR=... -P requirements.cmake: the first pass of ESP-IDF over its components, a script in
# which the registration is a macro that returns. Nothing after it may be reached, nor anything of a project.
set(CMAKE_BUILD_EARLY_EXPANSION 1)
macro(idf_component_register)
  set(registered 1)
  return()
endmacro()
function(read_component)
  include(${ARCSPAN_SOURCE_DIR}/CMakeLists.txt)
  if(NOT registered)
    message(FATAL_ERROR "the component was not registered")
  endif()
endfunction()
read_component()
