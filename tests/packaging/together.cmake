# SPDX-License-Identifier: MIT
# arcspan_together(LIBRARY): compiles the library's sources in a few, for half of the processor time. arduino-builder
# compiles each by itself.
function(arcspan_together library)
  get_target_property(sources ${library} SOURCES)
  foreach(part IN ITEMS pipeline/arcspan platform/c)
    set(those ${sources})
    list(FILTER those INCLUDE REGEX "/${part}/")
    set_source_files_properties(${those} TARGET_DIRECTORY ${library} PROPERTIES UNITY_GROUP ${part})
  endforeach()
  set_target_properties(${library} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
