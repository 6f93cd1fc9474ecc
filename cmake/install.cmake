# SPDX-License-Identifier: MIT
# Install and export: find_package(arcspan) gives arcspan::pipeline, arcspan::hal and arcspan::c, and arcspan::hal_sim and
# arcspan::linux_host where they were built.
include(CMakePackageConfigHelpers)

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/arcspan)
set(libraries arcspan_pipeline arcspan_hal)
if(NOT ARCSPAN_BOARD)
  list(APPEND libraries arcspan_c)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/platform/c/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
          FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp" PATTERN formats EXCLUDE)
endif()
if(TARGET arcspan_hal_sim AND PROJECT_IS_TOP_LEVEL)
  list(APPEND libraries arcspan_hal_sim)
endif()
if(TARGET arcspan_linux_host)
  list(APPEND libraries arcspan_linux_host)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/platform/linux/arcspan DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
          FILES_MATCHING PATTERN "*.hpp")
endif()
install(TARGETS ${libraries} EXPORT arcspan_targets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
foreach(part IN ITEMS pipeline hal)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${part}/arcspan DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
          FILES_MATCHING PATTERN "*.hpp")
endforeach()
install(EXPORT arcspan_targets NAMESPACE arcspan:: DESTINATION ${config_dir} FILE arcspan-targets.cmake)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/arcspan-config.cmake.in
                              ${PROJECT_BINARY_DIR}/arcspan-config.cmake INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/arcspan-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/arcspan-config.cmake ${PROJECT_BINARY_DIR}/arcspan-config-version.cmake
        DESTINATION ${config_dir})

# For builds without CMake: pkg-config --cflags --libs arcspan. Only if both folders lie inside the prefix.
if(NOT IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}" AND NOT IS_ABSOLUTE "${CMAKE_INSTALL_INCLUDEDIR}")
  file(RELATIVE_PATH ARCSPAN_PREFIX_FROM_PC /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  # The header of the C interface must see what its library was compiled with.
  list(TRANSFORM ARCSPAN_C_OPTIONS PREPEND " -D" OUTPUT_VARIABLE ARCSPAN_C_FLAGS)
  list(JOIN ARCSPAN_C_FLAGS "" ARCSPAN_C_FLAGS)
  configure_file(${PROJECT_SOURCE_DIR}/packaging/arcspan.pc.in ${PROJECT_BINARY_DIR}/arcspan.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/arcspan.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()

if(TARGET arcspan)
  install(TARGETS arcspan RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(FILES ${PROJECT_SOURCE_DIR}/packaging/arcspan.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
endif()
