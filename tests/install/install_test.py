#!/usr/bin/env python3
"""Installs a build, moves the installed files elsewhere, and builds the consumer's project against
them: by find_package() and by pkg-config.

    tests/install/install_test.py BUILD
"""

import contextlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(ROOT / "tests/bench"))
from culling import box, floor, glb  # noqa: E402
from packages import require, told  # noqa: E402
from png_bytes import read_png  # noqa: E402

CXX = os.environ.get("CXX", "c++")
HEADERS = ("light_lookup.hpp", "matrix.hpp", "packing.hpp", "shadow_masks.hpp", "silhouettes.hpp",
           "version.hpp")
OWN = {f'"edgeshade/{name}"' for name in HEADERS}
INCLUDE = re.compile(r"^\s*#include\s*(\S+)", re.M)
STANDARD = re.compile("<[a-z_]+>")
VIEW = ("--size", "320x240", "--camera-from", "4,5,6", "--camera-to", "0,0.5,0", "--fov", "45",
        "--light", "1,5,2", "--cull", "off")


def installed(build, folder):
    """The prefix, moved away from where it was installed."""
    told("cmake", "--install", build, "--prefix", folder / "first")
    told("cmake", "--install", build, env={**os.environ, "DESTDIR": str(folder / "staged")})
    require(list((folder / "staged").rglob("edgeshadeConfig.cmake")), "DESTDIR got nothing.")
    shutil.move(folder / "first", folder / "moved")
    return folder / "moved"


def check_files(prefix):
    found = {path.relative_to(prefix).as_posix() for path in prefix.rglob("*") if path.is_file()}
    require({f"include/edgeshade/{name}" for name in HEADERS} == {f for f in found if f.endswith(".hpp")},
            f"Not the headers that belong there: {sorted(found)}")
    require("bin/edgeshade" in found, "The program is not there.")
    require(not any("draco" in name or "erfa" in name for name in found),
            "Libraries of others are installed.")
    for path in prefix.rglob("*"):
        if path.suffix in (".cmake", ".pc", ".hpp"):
            require(str(ROOT) not in path.read_text(), f"{path} names where it was built.")


def check_headers(prefix, folder):
    for name in HEADERS:
        path = prefix / "include/edgeshade" / name
        others = [header for header in INCLUDE.findall(path.read_text())
                  if header not in OWN and not STANDARD.fullmatch(header)]
        require(not others, f"{name} includes {others}.")
        alone = folder / "alone.cpp"
        alone.write_text(f"#include <edgeshade/{name}>\n#include <edgeshade/{name}>\n")
        told(CXX, "-std=c++20", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-fsyntax-only",
             "-I", prefix / "include", alone)


def project(prefix, folder, name, *options):
    build = folder / name
    told("cmake", "-S", HERE / "consumer", "-B", build, f"-DCMAKE_PREFIX_PATH={prefix}", *options)
    told("cmake", "--build", build)
    return build


def shadow_of(path):
    """Rows of the consumer's picture: True in shadow, None where there is nothing."""
    data = path.read_bytes()
    _, size, _, pixels = data.split(b"\n", 3)
    width, height = map(int, size.split())
    kinds = {(51, 51, 51): True, (204, 204, 204): False, (0, 0, 255): None}
    rows = []
    for y in range(height):
        row = pixels[3 * width * y:3 * width * (y + 1)]
        rows.append([kinds[tuple(row[i:i + 3])] for i in range(0, len(row), 3)])
    return rows


def check_picture(path, wanted):
    shadow, wrong, dark = shadow_of(path), 0, 0
    for row, mask in zip(shadow, wanted.rows):
        for x, of in enumerate(row):
            level, alpha = mask[4 * x], mask[4 * x + 3]
            expected = None if alpha == 0 else level == 0
            wrong += of != expected
            dark += of is True
    require(dark > 500, f"The consumer's picture has {dark} pixels in shadow.")
    require(wrong == 0, f"{wrong} pixels of the consumer's picture are not as render --mask has them.")


@contextlib.contextmanager
def display():
    """The environment in which programs can open windows, on an invisible screen."""
    reading, writing = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(writing), "-screen", "0", "640x480x24", "-nolisten", "tcp"],
                              pass_fds=[writing], stderr=subprocess.DEVNULL)
    os.close(writing)
    try:
        with os.fdopen(reading) as number:
            shown = {key: value for key, value in os.environ.items() if key != "WAYLAND_DISPLAY"}
            yield {**shown, "DISPLAY": f":{number.readline().strip()}", "LIBGL_ALWAYS_SOFTWARE": "1"}
    finally:
        server.terminate()
        server.wait()


def check_window(program, folder, wanted):
    missing = [name for name, there in (("GLFW", program.exists()), ("Xvfb", shutil.which("Xvfb"))) if not there]
    if missing:
        print(f"No window is opened: {missing[0]} is not here.")
        return
    with display() as environment:
        told(program, folder / "window.ppm", env=environment)
    check_picture(folder / "window.ppm", wanted)


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        prefix = installed(build, folder)
        check_files(prefix)
        check_headers(prefix, folder)
        program = prefix / "bin/edgeshade"
        scene = glb(folder / "scene.glb", [], floor(4, 0) + box([-0.5, 0.5, -0.5], [0.5, 1.5, 0.5]))
        told(program, "render", scene, folder / "mask.png", "--mask", *VIEW)
        wanted = read_png(folder / "mask.png")

        alone = project(prefix, folder, "alone", "-DCONSUMER_SHADOW_ALONE=ON")
        require(told(alone / "silhouettes") ==
                "6 4\nA mesh has the index 8, but 8 vertices.\n", "Not a cube's silhouettes.")
        whole = project(prefix, folder, "whole")
        told(whole / "draw", folder / "drawn.ppm")
        check_picture(folder / "drawn.ppm", wanted)
        check_window(whole / "window", folder, wanted)

        told(program, "pack", scene, folder / "packed.glb")
        report = json.loads(told(program, "info", scene, "--report", "-"))
        counts = told(whole / "pack_one", scene, folder / "own.glb").split()
        require(counts == [str(report["triangles"]), str(report["edges"])],
                f"packScene() counts {counts}.")
        require((folder / "own.glb").read_bytes() == (folder / "packed.glb").read_bytes(),
                "packScene() and pack write different bytes.")
        refused = subprocess.run([whole / "pack_one", folder / "none.glb", folder / "x"],
                                 capture_output=True, text=True)
        require(refused.returncode == 2 and "none.glb" in refused.stderr, f"It says {refused.stderr}")

        flags = {"PKG_CONFIG_PATH": str(next(prefix.rglob("pkgconfig")))}
        words = told("pkg-config", "--cflags", "--libs", "edgeshade", env={**os.environ, **flags}).split()
        sources = [HERE / "consumer" / name for name in ("draw.cpp", "picture.cpp")]
        told(CXX, "-std=c++20", *sources, "-o", folder / "by_pc", *words)
        told(folder / "by_pc", folder / "by_pc.ppm")
        check_picture(folder / "by_pc.ppm", wanted)
    print("Installed, moved and used.")


if __name__ == "__main__":
    main()
