#!/usr/bin/env python3
"""Wrong pixels of cut scenes, and the time of a dragged plane: docs/measured/sections.md.

    tests/bench/sections.py [--scenes DIR]    writes the page's two tables

The oracle clips its own triangles. Needs the programs in build/release.
"""

import argparse
import json
import pathlib
import struct
import subprocess
import tempfile

from edgeshade_runs import ROOT

PROGRAM = ROOT / "build/release/edgeshade"
TIMES = ROOT / "build/release/tests/bench/section_times"
PAGE = ROOT / "docs/measured/sections.md"
TIMED = ("bunny.draco", "hospital-electrical", "city.draco", "engine", "temple")


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def matrix_of(node):
    if "matrix" in node:
        return [[node["matrix"][4 * c + r] for c in range(4)] for r in range(4)]
    x, y, z, w = node.get("rotation", (0, 0, 0, 1))
    scale, move = node.get("scale", (1, 1, 1)), node.get("translation", (0, 0, 0))
    turn = ((1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
            (2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
            (2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)))
    return [[turn[i][j] * scale[j] for j in range(3)] + [move[i]] for i in range(3)] + [[0, 0, 0, 1]]


def bounds_of(path):
    """Corners of the box around a GLB's meshes, by their accessors' bounds."""
    data = path.read_bytes()
    gltf = json.loads(data[20:20 + struct.unpack("<I", data[12:16])[0]])
    points = []

    def walk(index, above):
        node = gltf["nodes"][index]
        place = product(above, matrix_of(node))
        for primitive in gltf["meshes"][node["mesh"]]["primitives"] if "mesh" in node else ():
            accessor = gltf["accessors"][primitive["attributes"]["POSITION"]]
            for corner in range(8):
                at = [accessor["max" if corner >> axis & 1 else "min"][axis] for axis in range(3)] + [1]
                points.append([sum(place[r][c] * at[c] for c in range(4)) for r in range(3)])
        for child in node.get("children", ()):
            walk(child, place)

    for root in gltf["scenes"][gltf.get("scene", 0)]["nodes"]:
        walk(root, [[float(i == j) for j in range(4)] for i in range(4)])
    return [min(axis) for axis in zip(*points)], [max(axis) for axis in zip(*points)]


def sections_of(low, high):
    size = [b - a for a, b in zip(low, high)]
    middle = [0.5 * (a + b) for a, b in zip(low, high)]
    askew = (0.6, -0.5, 0.7)
    box = [a + 0.21 * s for a, s in zip(low, size)] + [a + 0.83 * s for a, s in zip(low, size)]
    return (["--section", f"1,0,0,{-(middle[0] + 0.013 * size[0])}"],
            ["--section", f"0,-1,0,{low[1] + 0.61 * size[1]}"],
            ["--section", ",".join(map(str, (*askew, -sum(a * b for a, b in zip(askew, middle)))))],
            ["--section-box", ",".join(map(str, box))])


def counts_of(scene, section, shadows, method, light):
    with tempfile.NamedTemporaryFile(suffix=".json") as report:
        subprocess.run([PROGRAM, "compare", scene, "--views", "2", "--size", "320x200", *section,
                        "--section-shadows", shadows, "--shadows", method, *light, "--report", report.name],
                       check=True, capture_output=True)
        return json.load(open(report.name))


def accuracy(scenes):
    rows = ["| scene | visible pixels | wrong beyond 1 px | of these not tied |", "| --- | --- | --- | --- |"]
    total = [0, 0, 0]
    for scene in scenes:
        low, high = bounds_of(scene)
        lamp = [0.5 * (a + b) + 0.11 * (b - a) for a, b in zip(low, high)]
        lights = (["--sun", "1,2,0.7"], ["--light", ",".join(map(str, lamp))])
        sums = [0, 0, 0]
        for section in sections_of(low, high):
            for shadows in ("cut", "whole"):
                for method in ("volumes", "lookup"):
                    for light in lights:
                        counts = counts_of(scene, section, shadows, method, light)
                        for i, key in enumerate(("visible_pixels", "wrong_image_beyond_1px",
                                                 "wrong_image_beyond_1px_not_tied")):
                            sums[i] += counts[key]
        rows.append(f"| {scene.name.split('.')[0]} | {sums[0]:,} | {sums[1]} | {sums[2]} |")
        total = [a + b for a, b in zip(total, sums)]
        print(rows[-1], flush=True)
    rows.append(f"| all | {total[0]:,} | {total[1]} | **{total[2]}** |")
    return "\n".join(rows)


def times(folder):
    measured = json.loads(subprocess.run([TIMES, *(folder / f"{name}.glb" for name in TIMED)], check=True,
                                         capture_output=True, text=True).stdout)
    rows = ["| scene | cut: median, longest | whole: median, longest | tree | first step |",
            "| --- | --- | --- | --- | --- |"]
    for of in measured:
        cut, whole = of["cut"], of["whole"]
        rows.append(f"| {of['scene'].split('.')[0]} | {cut['cut_ms']:.1f}, {cut['cut_ms_worst']:.1f} "
                    f"| {whole['cut_ms']:.1f}, {whole['cut_ms_worst']:.1f} | {cut['tree_ms']:.1f} "
                    f"| {cut['first_ms']:.0f} |")
    return "\n".join(rows)


def put(text, name, table):
    begin, end = f"<!-- {name}: begin -->\n", f"<!-- {name}: end -->"
    before, rest = text.split(begin)
    return before + begin + table + "\n" + end + rest.split(end)[1]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scenes", type=pathlib.Path, default=ROOT.parent / "shared/scenes")
    folder = parser.parse_args().scenes
    scenes = [*sorted(folder.glob("*.glb")), ROOT / "assets/pavilion.glb"]
    text = put(PAGE.read_text(), "time", times(folder))
    PAGE.write_text(put(text, "accuracy", accuracy(scenes)))


if __name__ == "__main__":
    main()
