#!/usr/bin/env python3
"""Tests what can be tested of packaging/conan and packaging/vcpkg without Conan and vcpkg: versions, names of files,
and that CMake configures the sources that the Conan recipe exports, and nothing else.

    tests/install/recipes_test.py
"""

import fnmatch
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import types

sys.dont_write_bytecode = True
from packages import ROOT, require, told  # noqa: E402

CONAN = ROOT / "packaging/conan/conanfile.py"
PORT = ROOT / "packaging/vcpkg/edgeshade"


def copy(_, pattern, source, target):
    """As conan.tools.files.copy(): a star also matches slashes."""
    for path in sorted(pathlib.Path(source).rglob("*")):
        name = path.relative_to(source).as_posix()
        if path.is_file() and fnmatch.fnmatch(name, pattern):
            (pathlib.Path(target) / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, pathlib.Path(target) / name)


def recipe():
    """The recipe's object, with stand-ins for the modules of Conan that it imports."""
    names = {"conan": {"ConanFile": object}, "conan.tools.files": {"copy": copy},
             "conan.tools.cmake": dict.fromkeys(("CMake", "CMakeToolchain", "cmake_layout")),
             "conan.tools.system.package_manager": {"Apt": None}}
    for name, members in names.items():
        sys.modules[name] = types.ModuleType(name)
        vars(sys.modules[name]).update(members)
    for name in ("conan.tools", "conan.tools.system"):
        sys.modules[name] = types.ModuleType(name)
    space = {}
    exec(compile(CONAN.read_text(), str(CONAN), "exec"), space)
    made = space["EdgeshadeRecipe"]()
    made.recipe_folder = str(CONAN.parent)
    return made


def check_conan(version):
    made = recipe()
    made.set_version()
    require(made.version == version, f"The Conan recipe has version {made.version}, CMakeLists.txt {version}.")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        made.export_sources_folder = str(folder / "sources")
        made.export_sources()
        done = subprocess.run(["cmake", "-S", folder / "sources", "-B", folder / "build"], capture_output=True, text=True)
        require(done.returncode == 0, f"CMake can't configure what the Conan recipe exports:\n{done.stderr}")
        told("cmake", "--build", folder / "build", "--target", "edgeshade_shader_header")


def check_vcpkg(version):
    port = json.loads((PORT / "vcpkg.json").read_text())
    require(port["version"] == version, f"The vcpkg port has version {port['version']}, CMakeLists.txt {version}.")
    for name in re.findall(r"\$\{SOURCE_PATH\}/([\w./]+)", (PORT / "portfile.cmake").read_text()):
        require((ROOT / name).exists(), f"The vcpkg port names {name}, which does not exist.")


def main():
    version = re.search(r"project\(edgeshade VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)
    check_conan(version)
    check_vcpkg(version)
    print("The recipes have the right version and files. Conan and vcpkg themselves did not run.")


if __name__ == "__main__":
    main()
