# SPDX-License-Identifier: MIT
# One translation unit for every shading method and pixel format, so that they build side by side. A method is
# its header's name in pipeline/arcspan/shading; its class is the same in CamelCase.
set(shadings flat gouraud arc)
set(formats rgb565 Rgb565 rgb888 Rgb888 gray8 Gray8 gray4 Gray4 mono Mono)
set(dithered_formats rgb565 Rgb565 gray4 Gray4 mono Mono)

# Adds the renderer SHADING into FORMAT (named FORMAT_NAME) to the target and to the table.
function(add_renderer target shading format_name format dithers)
  set(METHOD "")
  string(REPLACE "_" ";" words ${shading})
  foreach(word IN LISTS words)
    string(SUBSTRING ${word} 0 1 head)
    string(SUBSTRING ${word} 1 -1 tail)
    string(TOUPPER ${head} head)
    string(APPEND METHOD ${head}${tail})
  endforeach()
  set(SHADING ${shading})
  set(FORMAT ${format})
  set(NAME ${shading}_${format_name})
  if(dithers STREQUAL "true")
    set(FORMAT Dithered<${format}>)
    string(APPEND NAME _dithered)
  endif()
  configure_file(renderer.cpp.in renderers/${NAME}.cpp @ONLY)
  target_sources(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/renderers/${NAME}.cpp)
  set(RENDERER_DECLARATIONS
      "${RENDERER_DECLARATIONS}RenderResult render_${NAME}(const RenderJob& job, const RowsDone& rows_done);\n"
      PARENT_SCOPE)
  set(RENDERER_ENTRIES
      "${RENDERER_ENTRIES}      {\"${shading}\", \"${format_name}\", ${dithers}, &render_${NAME}},\n"
      PARENT_SCOPE)
endfunction()

set(RENDERER_DECLARATIONS "")
set(RENDERER_ENTRIES "")
foreach(shading IN LISTS shadings)
  foreach(dithers IN ITEMS false true)
    set(pairs ${formats})
    if(dithers)
      set(pairs ${dithered_formats})
    endif()
    while(pairs)
      list(POP_FRONT pairs format_name format)
      add_renderer(arcspan_tools_core ${shading} ${format_name} ${format} ${dithers})
    endwhile()
  endforeach()
endforeach()
configure_file(renderer_table.cpp.in renderers/table.cpp @ONLY)
target_sources(arcspan_tools_core PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/renderers/table.cpp)
