# SPDX-License-Identifier: MIT
# Reads tools/arcspan_tools/shading_method_list.hpp. Sets shading_methods, the list of all classes, and for each of them
# ${class}_NAME (for people) and ${class}_HEADER.
set(list_of_methods ${CMAKE_CURRENT_LIST_DIR}/arcspan_tools/shading_method_list.hpp)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list_of_methods})
file(READ ${list_of_methods} list_of_methods)
string(REGEX MATCHALL "entry\\(\"[^\n]+\"\\)" list_of_methods "${list_of_methods}")
set(shading_methods "")
foreach(entry IN LISTS list_of_methods)
  string(REGEX MATCH "\"(.+)\", (.+), \"(.+)\"" entry "${entry}")
  list(APPEND shading_methods ${CMAKE_MATCH_2})
  set(${CMAKE_MATCH_2}_NAME ${CMAKE_MATCH_1})
  set(${CMAKE_MATCH_2}_HEADER ${CMAKE_MATCH_3})
endforeach()
