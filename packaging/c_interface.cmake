# SPDX-License-Identifier: MIT
# Of the variables that Kconfig sets (CONFIG_ARCSPAN_C...): `arcspan_c_sources` and `arcspan_c_definitions`, which the program
# needs too.
set(arcspan_c_sources "")
set(arcspan_c_definitions "")
if(CONFIG_ARCSPAN_C)
  file(GLOB_RECURSE arcspan_c_sources ${CMAKE_CURRENT_LIST_DIR}/../platform/c/arcspan_c/*.cpp)
  set(arcspan_c_definitions ARCSPAN_C_LIGHTS=${CONFIG_ARCSPAN_C_LIGHTS})
  foreach(option IN ITEMS COLOURED_LIGHTS PHONG TOON ARC GOURAUD FLAT TEXTURES_RGB565 TEXTURES_PALETTE8 TEXTURES_PALETTE4 OUTLINES MARKED_OUTLINES
          CURVED_OUTLINES INK CHARACTERS RGB565 RGB565_SWAPPED RGB888 BGR888 XRGB8888 ARGB8888 GRAY8 GRAY4 MONO)
    if(CONFIG_ARCSPAN_C_${option})
      list(APPEND arcspan_c_definitions ARCSPAN_C_${option}=1)
    else()
      list(APPEND arcspan_c_definitions ARCSPAN_C_${option}=0)
    endif()
  endforeach()
endif()
