# SPDX-License-Identifier: MIT
# One translation unit for every shading method, so that they build side by side. A method is its header's name in
# pipeline/arcspan/shading; its class is the same in CamelCase, its name for --shading the same with hyphens.
set(shadings flat gouraud arc phong slerp kuijk_blake lyon duff reflection_map arc_vector)

set(RENDERER_DECLARATIONS "")
set(RENDERER_ENTRIES "")
foreach(SHADING IN LISTS shadings)
  set(METHOD "")
  string(REPLACE "_" "-" NAME ${SHADING})
  string(REPLACE "_" ";" words ${SHADING})
  foreach(word IN LISTS words)
    string(SUBSTRING ${word} 0 1 head)
    string(SUBSTRING ${word} 1 -1 tail)
    string(TOUPPER ${head} head)
    string(APPEND METHOD ${head}${tail})
  endforeach()
  configure_file(renderer.cpp.in renderers/${SHADING}.cpp @ONLY)
  target_sources(arcspan_tools_core PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/renderers/${SHADING}.cpp)
  string(APPEND RENDERER_DECLARATIONS "RenderFunction render_${SHADING};\n")
  string(APPEND RENDERER_ENTRIES "      {\"${NAME}\", &render_${SHADING}},\n")
endforeach()
configure_file(renderer_table.cpp.in renderers/table.cpp @ONLY)
target_sources(arcspan_tools_core PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/renderers/table.cpp)
