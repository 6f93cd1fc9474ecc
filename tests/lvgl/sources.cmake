# SPDX-License-Identifier: MIT
# Finds LVGL, which is not part of this repository: `lvgl` is its folder, or empty; `lvgl_sources` what lv_conf.h enables on
# boards, `lvgl_test_sources` what its test module takes besides. The other sources would be empty.
set(ARCSPAN_LVGL_DIR "" CACHE PATH "Sources of LVGL 9.6, for the tests of lv_arcspan_view")
set(lvgl ${ARCSPAN_LVGL_DIR})
set(archive ${PROJECT_SOURCE_DIR}/../shared/third_party/lvgl.tar.xz)
if(NOT lvgl AND EXISTS ${archive})
  set(lvgl ${CMAKE_CURRENT_BINARY_DIR}/lvgl)
  if(NOT EXISTS ${lvgl}/lvgl.h)
    file(ARCHIVE_EXTRACT INPUT ${archive} DESTINATION ${CMAKE_CURRENT_BINARY_DIR})
  endif()
endif()
if(NOT lvgl)
  return()
endif()

set(folders core display draw/sw draw/convert fs image indev layouts libs/bin_decoder logging misc osal stdlib themes tick
    widgets/bar widgets/image widgets/label widgets/slider)
set(test_folders debugging/test draw/snapshot libs/lodepng)
set(lvgl_sources "")
foreach(folder IN LISTS folders)
  file(GLOB_RECURSE found CONFIGURE_DEPENDS ${lvgl}/src/${folder}/*.c)
  list(APPEND lvgl_sources ${found})
endforeach()
file(GLOB found CONFIGURE_DEPENDS ${lvgl}/src/*.c ${lvgl}/src/draw/*.c ${lvgl}/src/font/*.c ${lvgl}/src/font/*/*.c)
list(FILTER found EXCLUDE REGEX "lv_font_(montserrat_[^1]|montserrat_1[^4]|dejavu|source|simsun|unscii)")
list(APPEND lvgl_sources ${found})
set(lvgl_test_sources "")
foreach(folder IN LISTS test_folders)
  file(GLOB_RECURSE found CONFIGURE_DEPENDS ${lvgl}/src/${folder}/*.c)
  list(APPEND lvgl_test_sources ${found})
endforeach()

# arcspan_lvgl_library(NAME SOURCES...): LVGL with the widget and the frames of the tests.
function(arcspan_lvgl_library name)
  set(ours ${PROJECT_SOURCE_DIR}/platform/lvgl/lv_arcspan_unit.c ${PROJECT_SOURCE_DIR}/platform/lvgl/lv_arcspan_view.c
      ${PROJECT_SOURCE_DIR}/tests/lvgl/frames.c)
  add_library(${name} STATIC ${ARGN} ${ours})
  target_compile_options(${name} PRIVATE -w)
  set_source_files_properties(${ours} PROPERTIES COMPILE_OPTIONS "-std=c99;-Wall;-Wextra;-Wno-reserved-identifier;-Werror")
  target_compile_definitions(${name} PUBLIC LV_CONF_INCLUDE_SIMPLE)
  target_include_directories(${name} SYSTEM PUBLIC ${lvgl} ${lvgl}/include)
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR}/tests/lvgl ${PROJECT_SOURCE_DIR}/platform/lvgl)
  target_link_libraries(${name} PUBLIC arcspan_c_of_lvgl)
  target_link_options(${name} PUBLIC -Wl,--wrap=arcspan_draw) # for frames.c
endfunction()
