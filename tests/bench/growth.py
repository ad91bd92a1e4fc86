#!/usr/bin/env python3
"""How the processor's time for a moving light grows with the scene: the table "Growth" of docs/measured/processor.md.
A GL that draws nothing and names itself hardware stands for the card.

    tests/bench/growth.py           measures, then the table
    tests/bench/growth.py --table   the table from the stored results

EDGESHADE and NULL_GL as for processor.py, GENERATED_MESH as for large_scenes.py. Writes up to 700 MB to a temporary
folder.
"""

import json
import os
import pathlib
import struct
import subprocess
import sys
import tempfile

from edgeshade_runs import SCENES, replace_between, report, results_of
from large_scenes import GENERATED_MESH
from processor import NULL_GL, cell

GARDENS, APART = (1, 10, 100), 14.0
BOXES = (100_000, 1_000_000, 5_000_000, 10_000_000)
SUN = ("--sun", "0.4,1,0.3")
ONE = ("--camera-from", "6,5,8", "--camera-to", "0,0.5,0", "--fov", "45")  # the first garden
FRAMES = 30


def write_gardens(count, path):
    """Writes places of the garden as glTF, in rows of ten. ONE sees the first, in the middle of its row, and no other row."""
    data = (SCENES / "garden.draco.glb").read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    gltf, rest = json.loads(data[20:20 + length]), data[20 + length:]
    nodes, scene = gltf["nodes"], gltf["scenes"][gltf.get("scene", 0)]

    def copy_of(index):
        node = dict(nodes[index])
        if "children" in node:
            node["children"] = [copy_of(child) for child in node["children"]]
        nodes.append(node)
        return len(nodes) - 1

    roots = scene["nodes"]
    scene["nodes"] = []
    for place in range(count):
        row, column = divmod(place, 10)
        x = APART * ((column + 1) // 2) * (1 if column % 2 else -1)
        nodes.append({"translation": [x, 0.0, APART * row],
                      "children": [copy_of(root) for root in roots]})
        scene["nodes"].append(len(nodes) - 1)
    text = json.dumps(gltf).encode()
    text += b" " * (-len(text) % 4)
    path.write_bytes(b"glTF" + struct.pack("<II", 2, 20 + len(text) + len(rest))
                     + struct.pack("<I", len(text)) + b"JSON" + text + rest)


def of_scene(path, *camera):
    told = report("bench", path, "--light-moves", "--timing", "processor", "--size", "1920x1080",
                  "--frames", FRAMES, "--shadows", "volumes", *SUN, *camera)
    return {"plan": told["plan_ms"], "submit": told["frame_ms"]["median"]}


def triangles_of(path):
    return report("info", path)["triangles"]


def measured():
    os.environ["LD_PRELOAD"] = NULL_GL
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "scene.glb"
        for count in GARDENS:
            write_gardens(count, path)
            rows.append({"scene": f"{count} garden{'s' if count > 1 else ''}",
                         "triangles": triangles_of(path), "one": of_scene(path, *ONE),
                         "all": of_scene(path)})
        for count in BOXES:
            print(count, "triangles of boxes", file=sys.stderr)
            subprocess.run([GENERATED_MESH, "boxes", str(count), path], check=True)
            rows.append({"scene": "boxes", "triangles": triangles_of(path), "all": of_scene(path)})
    return rows


def table(rows):
    lines = ["| scene, light moves | triangles | one in view: plan + submit, ms | all in view |",
             "| --- | --- | --- | --- |"]
    for row in rows:
        lines.append(f"| {row['scene']} | {row['triangles']:,} | {cell(row['one']) if 'one' in row else ''} | {cell(row['all'])} |")
    return "\n".join(lines)


def main():
    results = results_of("growth", measured)
    of = results["machine"]
    replace_between("docs/measured/processor.md", "growth",
                    f"{of['cores']} cores of {of['processor']}, {of['date']}; medians of {FRAMES} frames.\n\n"
                    + table(results["scenes"]))


if __name__ == "__main__":
    main()
