# SPDX-License-Identifier: MIT
# Every shading method, for the tools and for the firmware that measures costs. A method is its header's name in
# pipeline/arcspan/shading; its class is the same in CamelCase, its name for --shading the same with hyphens.
# Where one header holds several classes, an entry is HEADER:CLASS and the name comes from the class.
set(shadings flat gouraud arc segment adaptive phong slerp kuijk_blake lyon duff reflection_map arc_vector
    dichotomy:DichotomyLinear dichotomy:DichotomyQuadratic dichotomy:DichotomyCubic)

# From an entry: HEADER, METHOD (the class), SHADING (a name for files and functions), NAME (for people).
macro(arcspan_shading entry)
  string(REGEX REPLACE ":.*" "" HEADER ${entry})
  if("${entry}" MATCHES ":(.*)")
    set(METHOD ${CMAKE_MATCH_1})
    string(REGEX REPLACE "([a-z0-9])([A-Z])" "\\1_\\2" SHADING ${METHOD})
    string(TOLOWER ${SHADING} SHADING)
  else()
    set(SHADING ${entry})
    set(METHOD "")
    string(REPLACE "_" ";" words ${SHADING})
    foreach(word IN LISTS words)
      string(SUBSTRING ${word} 0 1 head)
      string(SUBSTRING ${word} 1 -1 tail)
      string(TOUPPER ${head} head)
      string(APPEND METHOD ${head}${tail})
    endforeach()
  endif()
  string(REPLACE "_" "-" NAME ${SHADING})
  foreach(folder . arc segment adaptive literature)
    if(EXISTS ${PROJECT_SOURCE_DIR}/pipeline/arcspan/shading/${folder}/${HEADER}.hpp)
      set(HEADER ${folder}/${HEADER})
      break()
    endif()
  endforeach()
endmacro()
