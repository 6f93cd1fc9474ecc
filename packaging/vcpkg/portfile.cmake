vcpkg_download_distfile(archive
    URLS "@URL@/releases/download/v@VERSION@/arcspan-@VERSION@.tar.gz"
    FILENAME "arcspan-@VERSION@.tar.gz"
    SHA512 @SHA512@)
vcpkg_extract_source_archive(SOURCE_PATH ARCHIVE "${archive}")
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}"
    OPTIONS -DCMAKE_INSTALL_LIBDIR=lib -DARCSPAN_TOOLS=OFF -DARCSPAN_TESTS=OFF -DARCSPAN_LINUX_HOST=OFF -DARCSPAN_LIBRARY_UNITY=ON)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/arcspan)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
