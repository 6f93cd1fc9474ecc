#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""run_recipe.py RECIPE ARCHIVE WORK: runs a Conan recipe with stand-ins for Conan's functions, as `conan create` would.

ARCHIVE is taken in place of the download. The package's components are then linked with the program of the recipe's
test_package, which is run.
"""

import hashlib
import importlib.util
import pathlib
import subprocess
import sys
import tarfile
import types

import yaml

RECIPE, ARCHIVE, WORK = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
VERSION = ARCHIVE.name.removeprefix("arcspan-").removesuffix(".tar.gz")


def run(*command):
    subprocess.run([str(part) for part in command], check=True)


class Component:
    def __init__(self):
        self.libs, self.requires, self.properties = [], [], {}

    def set_property(self, name, value):
        self.properties[name] = value


class CppInfo(Component):
    def __init__(self):
        super().__init__()
        self.components = {}

    def __getattribute__(self, name):
        found = super().__getattribute__(name)
        if name == "components":
            for part in ("pipeline", "hal", "c"):
                found.setdefault(part, Component())
        return found


class ConanFile:
    def __init__(self):
        self.conan_data = yaml.safe_load((RECIPE / "conandata.yml").read_text())
        self.cpp_info = CppInfo()
        self.source_folder, self.package_folder = str(WORK / f"source/arcspan-{VERSION}"), str(WORK / "package")


class CMakeToolchain:
    def __init__(self, conanfile):
        self.cache_variables, conanfile.toolchain = {}, self

    def generate(self):
        pass


class CMake:
    def __init__(self, conanfile):
        self.conanfile = conanfile

    def configure(self):
        variables = self.conanfile.toolchain.cache_variables.items()
        run("cmake", "-S", self.conanfile.source_folder, "-B", WORK / "build", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Debug",
            "-DCMAKE_INSTALL_LIBDIR=lib", "-DARCSPAN_LIBRARY_UNITY=ON",
            *(f"-D{name}={'ON' if value else 'OFF'}" for name, value in variables))

    def build(self):
        run("cmake", "--build", WORK / "build")

    def install(self):
        run("cmake", "--install", WORK / "build", "--prefix", self.conanfile.package_folder)


def get(conanfile, url, sha256, strip_root):
    if hashlib.sha256(ARCHIVE.read_bytes()).hexdigest() != sha256 or not url.endswith("/" + ARCHIVE.name) or not strip_root:
        sys.exit(f"{url}: not {ARCHIVE}")
    with tarfile.open(ARCHIVE) as packed:
        packed.extractall(pathlib.Path(conanfile.source_folder).parent)


def copy(_, pattern, source, target):
    if not pathlib.Path(source, pattern).is_file() or pathlib.Path(target).name != "licenses":
        sys.exit(f"there is no {pattern} in {source}")


def rmdir(_, folder):
    run("rm", "-r", folder)  # fails if it is not there


def check_min_cppstd(_, standard):
    if standard != 20:
        sys.exit(f"the recipe takes C++{standard}")


def load():
    modules = {"conan": {"ConanFile": ConanFile}, "conan.tools": {}, "conan.tools.build": {"check_min_cppstd": check_min_cppstd},
               "conan.tools.cmake": {"CMake": CMake, "CMakeToolchain": CMakeToolchain, "cmake_layout": lambda *_, **__: None},
               "conan.tools.files": {"copy": copy, "get": get, "rmdir": rmdir}}
    for name, members in modules.items():
        sys.modules[name] = types.ModuleType(name)
        vars(sys.modules[name]).update(members)
    spec = importlib.util.spec_from_file_location("recipe", RECIPE / "conanfile.py")
    recipe = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(recipe)
    return recipe.ArcspanConan()


def main():
    recipe = load()
    # What ConanCenter wants of every recipe.
    for name in ("name", "version", "description", "license", "url", "homepage", "topics", "package_type", "settings"):
        if not getattr(recipe, name, None):
            sys.exit(f"the recipe has no {name}")
    for step in ("validate", "layout", "source", "generate", "build", "package", "package_info"):
        getattr(recipe, step)()
    components = recipe.cpp_info.components
    libraries = []
    for part in ("hal", *components["hal"].requires):
        libraries += components[part].libs
    for component in components.values():
        for library in component.libs:
            if not pathlib.Path(recipe.package_folder, f"lib/lib{library}.a").is_file():
                sys.exit(f"the package has no {library}")
    run("g++", "-std=c++20", RECIPE / "test_package/main.cpp", f"-I{recipe.package_folder}/include", f"-L{recipe.package_folder}/lib",
        *(f"-l{library}" for library in libraries), "-o", WORK / "consumer")
    run(WORK / "consumer")


main()
