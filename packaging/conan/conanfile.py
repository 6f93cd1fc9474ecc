# SPDX-License-Identifier: MIT
from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy, get, rmdir
import os


class ArcspanConan(ConanFile):
    name = "arcspan"
    version = "@VERSION@"
    description = "Phong-shaded 3D in integers: a fixed-function pipeline for machines without FPU, heap or GPU"
    license = "MIT"
    url = "@URL@"
    homepage = "@URL@"
    topics = ("3d", "graphics", "embedded", "fixed-point")
    package_type = "static-library"
    settings = "os", "arch", "compiler", "build_type"

    def validate(self):
        check_min_cppstd(self, 20)

    def layout(self):
        cmake_layout(self, src_folder="src")

    def source(self):
        get(self, **self.conan_data["sources"][self.version], strip_root=True)

    def generate(self):
        toolchain = CMakeToolchain(self)
        for option in ("ARCSPAN_TOOLS", "ARCSPAN_TESTS", "ARCSPAN_LINUX_HOST"):
            toolchain.cache_variables[option] = False
        toolchain.cache_variables["ARCSPAN_LIBRARY_UNITY"] = True
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        CMake(self).install()
        rmdir(self, os.path.join(self.package_folder, "lib", "cmake"))
        rmdir(self, os.path.join(self.package_folder, "lib", "pkgconfig"))

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "arcspan")
        parts = {"pipeline": [], "hal": ["pipeline"], "c": ["hal", "pipeline"]}
        for part, needs in parts.items():
            component = self.cpp_info.components[part]
            component.set_property("cmake_target_name", f"arcspan::{part}")
            component.libs = [f"arcspan_{part}"]
            component.requires = needs
