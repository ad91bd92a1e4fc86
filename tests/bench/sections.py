#!/usr/bin/env python3
"""Wrong pixels of cut scenes, and the time of a dragged plane: docs/measured/sections.md.

    tests/bench/sections.py [--scenes DIR] [--only TABLE]   writes the page's tables
                            [--web FILE]                    from web/compare/measure-sections.mjs

The tables are accuracy, time, and with --web also web. The oracle clips its own triangles. Needs the
programs in build/release.
"""

import argparse
import json
import pathlib
import statistics
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


def times(folder, runs=5):
    """Medians of some runs."""
    asked = [TIMES, *(folder / f"{name}.glb" for name in TIMED)]
    measured = [json.loads(subprocess.run(asked, check=True, capture_output=True, text=True).stdout)
                for _ in range(runs)]
    rows = ["| scene | cut: median, longest | whole: median, longest | tree | with the tree | first step |",
            "| --- | --- | --- | --- | --- | --- |"]
    for of in zip(*measured):
        def figure(shadows, key, digits=1):
            return f"{statistics.median(one[shadows][key] for one in of):.{digits}f}"
        rows.append(f"| {of[0]['scene'].split('.')[0]} "
                    + "".join(f"| {figure(shadows, 'cut_ms')}, {figure(shadows, 'cut_ms_worst')} "
                              for shadows in ("cut", "whole"))
                    + "".join(f"| {figure('cut', key, digits)}, {figure('whole', key, digits)} "
                              for key, digits in (("tree_ms", 1), ("step_ms", 1), ("first_ms", 0))) + "|")
    return "\n".join(rows)


def web(file):
    rows = ["| scene | cut: median, longest | whole: median, longest | to WebGL | first step | map: built, longest task |",
            "| --- | --- | --- | --- | --- | --- |"]
    for scene, of in json.loads(file.read_text()).items():
        cut, whole, lookup = of["cut"], of["whole"], of["lookup_of_cut"]
        built = f"{lookup['build_ms']:.0f}, {lookup['longest_task_ms']:.0f}" \
            if lookup["method"] == "primitive-map" else "none"
        rows.append(f"| {scene.split('.')[0]} | {cut['cut_ms']:.1f}, {cut['cut_ms_worst']:.1f} "
                    f"| {whole['cut_ms']:.1f}, {whole['cut_ms_worst']:.1f} "
                    f"| {cut['upload_ms']:.1f}, {whole['upload_ms']:.1f} | {cut['first_ms']:.0f} | {built} |")
    return "\n".join(rows)


def put(text, name, table):
    begin, end = f"<!-- {name}: begin -->\n", f"<!-- {name}: end -->"
    before, rest = text.split(begin)
    return before + begin + table + "\n" + end + rest.split(end)[1]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scenes", type=pathlib.Path, default=ROOT.parent / "shared/scenes")
    parser.add_argument("--only", choices=("accuracy", "time", "web"), help="this table alone")
    parser.add_argument("--web", type=pathlib.Path, metavar="FILE", help="results in a page")
    options = parser.parse_args()
    if options.only == "web" and not options.web:
        parser.error("--only web needs --web FILE")
    folder = options.scenes
    scenes = [*sorted(folder.glob("*.glb")), ROOT / "assets/pavilion.glb"]
    tables = {"time": lambda: times(folder), "web": lambda: web(options.web), "accuracy": lambda: accuracy(scenes)}
    for name, table in tables.items():
        if options.only in (None, name) and (name != "web" or options.web):
            PAGE.write_text(put(PAGE.read_text(), name, table()))


if __name__ == "__main__":
    main()
