"""A recipe for Conan 2: conan create packaging/conan

It builds the tree that it lies in, against the libraries of the system, which it asks apt for on Debian and Ubuntu.
docs/packages.md says what of it was tried.
"""

import pathlib
import re

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy
from conan.tools.system.package_manager import Apt


class EdgeshadeRecipe(ConanFile):
    name = "edgeshade"
    license = "MIT"
    description = "Pixel-exact shadows for WebGL 1.0 and OpenGL ES 2.0"
    package_type = "static-library"
    settings = "os", "compiler", "build_type", "arch"
    options = {"fPIC": [True, False]}
    default_options = {"fPIC": True}

    def set_version(self):
        text = (pathlib.Path(self.recipe_folder).parents[1] / "CMakeLists.txt").read_text()
        self.version = re.search(r"project\(edgeshade VERSION ([\d.]+)", text).group(1)

    def export_sources(self):
        root = pathlib.Path(self.recipe_folder).parents[1]
        for pattern in ("CMakeLists.txt", "LICENSE", "CHANGELOG.md", "cmake/*", "include/*", "preprocess/*",
                        "shaders_es2/*", "src/*", "packaging/*"):
            copy(self, pattern, root, self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def system_requirements(self):
        Apt(self).install([
            "libglm-dev", "libtinygltf-dev", "libstb-dev", "nlohmann-json3-dev", "libdraco-dev", "libmeshoptimizer-dev",
            "liberfa-dev", "libwebp-dev", "libcli11-dev", "libegl-dev", "libgles-dev", "libglu1-mesa-dev", "libembree-dev",
            "libboost-dev", "libcairo2-dev", "libglfw3-dev"])

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["CMAKE_UNITY_BUILD"] = True
        toolchain.cache_variables["CMAKE_UNITY_BUILD_BATCH_SIZE"] = "8"
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()

    def package_info(self):
        # The package's own edgeshadeConfig.cmake knows its targets and what they need.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs = ["lib/cmake/edgeshade"]
        self.cpp_info.bindirs = ["bin"]
