#!/usr/bin/env python3
"""Wrong pixels and frame times with culled backs of single-sided materials, on small scenes made
here and on models in ../shared/scenes: the tables of docs/measured/culling.md.

    tests/bench/culling.py           measures, then the tables
    tests/bench/culling.py --table   the tables from the stored results

EDGESHADE names the program.
"""

import json
import pathlib
import struct
import tempfile

from edgeshade_runs import SCENES, figure, percent, replace_between, report, results_of

MODELS = {"bunny": "bunny.draco.glb", "2-cylinder engine": "engine.glb",
          "hospital, electrical": "hospital-electrical.glb", "truck": "truck.draco.glb"}
VIEWS, SIZE, FRAMES = 12, "960x540", 10
COUNTS = ("visible_pixels", "wrong_mask_pixels", "wrong_mask_beyond_1px", "wrong_image_pixels",
          "wrong_image_beyond_1px_not_tied")


def box(low, high):
    """The twelve triangles of a box, wound outwards; inwards if low and high are swapped."""
    corner = [[(high if i >> axis & 1 else low)[axis] for axis in range(3)] for i in range(8)]
    faces = ((0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6))
    return [[corner[i] for i in of] for f in faces for of in ((f[0], f[1], f[2]), (f[0], f[2], f[3]))]


def quad(a, b, c, d):
    return [[a, b, c], [a, c, d]]


def floor(half, y):
    return quad([-half, y, half], [half, y, half], [half, y, -half], [-half, y, -half])


def glb(path, single, double=(), scale=(1, 1, 1)):
    """A file of triangles with a single-sided and a double-sided material, in one node."""
    gltf = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0, "scale": list(scale)}], "meshes": [{"primitives": []}],
            "materials": [{"doubleSided": False}, {"doubleSided": True}],
            "accessors": [], "bufferViews": []}
    data = b""
    for material, triangles in enumerate((single, double)):
        points = [corner for triangle in triangles for corner in triangle]
        if not points:
            continue
        floats = [value for point in points for value in point]
        gltf["meshes"][0]["primitives"].append(
            {"attributes": {"POSITION": len(gltf["accessors"])}, "material": material})
        gltf["accessors"].append({
            "bufferView": len(gltf["bufferViews"]), "componentType": 5126, "type": "VEC3",
            "count": len(points), "min": [min(axis) for axis in zip(*points)],
            "max": [max(axis) for axis in zip(*points)]})
        gltf["bufferViews"].append({"buffer": 0, "byteOffset": len(data), "byteLength": 4 * len(floats)})
        data += struct.pack(f"<{len(floats)}f", *floats)
    gltf["buffers"] = [{"byteLength": len(data)}]
    text = json.dumps(gltf).encode()
    text += b" " * (-len(text) % 4)
    path.write_bytes(struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + len(data), len(text), 0x4E4F534A)
                     + text + struct.pack("<II", len(data), 0x004E4942) + data)
    return path


def furniture():
    return (box([-0.6, 0, -0.5], [0.2, 0.7, 0.3]) + box([1, 0.2, -1.2], [1.4, 1.5, -0.8])
            + box([-1.4, 0.9, -1.5], [-0.7, 1, -0.4]))


def room():
    return floor(4, -0.1) + box([2, 2, 2], [-2, 0, -2]) + furniture()


def sheets():
    """Walls of two coinciding sheets each, and a roof of two."""
    corners = [[-1.8, 0, -1.5], [1.6, 0, -1.2], [1.7, 0, 1.5], [-1.5, 0, 1.3]]
    triangles = floor(4, -0.1) + furniture()
    for a, b in zip(corners, corners[1:]):
        high_a, high_b = [a[0], 1.8, a[2]], [b[0], 1.8, b[2]]
        triangles += quad(a, b, high_b, high_a) + quad(b, a, high_a, high_b)
    roof = [[c[0], 1.9, c[2]] for c in corners]
    return triangles + quad(*roof) + quad(*roof[::-1])


def mixed():
    """Rooms whose triangles alternate between the two kinds, joined at their edges."""
    walls = box([2, 2, 2], [-2, 0, -2]) + box([-0.8, 0.1, -0.8], [0.9, 1.2, 0.7])
    return floor(4, -0.1) + walls[::2], walls[1::2]


def made(folder):
    folder = pathlib.Path(folder)
    return {
        "a room wound inwards": glb(folder / "room.glb", room()),
        "the same, mirrored": glb(folder / "mirrored.glb", room(), scale=(-1, 1.1, 0.9)),
        "a house wound outwards": glb(folder / "house.glb", floor(4, -0.1) + box([-2, 0, -2], [2, 2, 2])
                                      + furniture()),
        "single- and double-sided, joined": glb(folder / "mixed.glb", *mixed()),
        "sheets back to back": glb(folder / "sheets.glb", sheets())}


def single_sided(path, folder):
    """A copy of a GLB without double-sided materials."""
    data = path.read_bytes()
    length = struct.unpack("<I", data[12:16])[0]
    gltf = json.loads(data[20:20 + length])
    for material in gltf["materials"]:
        material["doubleSided"] = False
    text = json.dumps(gltf).encode()
    text += b" " * (-len(text) % 4)
    rest = data[20 + length:]
    copy = pathlib.Path(folder) / path.name
    copy.write_bytes(data[:8] + struct.pack("<III", 20 + len(text) + len(rest), len(text), 0x4E4F534A)
                     + text + rest)
    return copy


def of_scene(path):
    result = {}
    for cull in ("off", "auto"):
        told = report("compare", path, "--views", VIEWS, "--size", SIZE, "--cull", cull,
                      "--against", "shadows=primitive-map")["results"]
        counted, looked_up = ({key: of[key] for key in COUNTS} for of in told)
        frames = report("bench", path, "--size", SIZE, "--frames", FRAMES, "--timing", "processor",
                        "--cull", cull)
        result[cull] = {"volumes": counted, "primitive map": looked_up,
                        "frame_ms": frames["frame_ms"]["median"], "vertex_runs": frames["vertex_runs"]}
    return result


def measured():
    with tempfile.TemporaryDirectory() as folder:
        scenes = made(folder)
        scenes["car, all made single-sided"] = single_sided(SCENES / "car.draco.glb", folder)
        scenes.update({name: SCENES / file for name, file in MODELS.items()})
        return {name: of_scene(path) for name, path in scenes.items()}


def wrong(of):
    share = lambda key: figure(percent(of[key], of["visible_pixels"]))  # noqa: E731
    return (f"{share('wrong_mask_pixels')} | {share('wrong_mask_beyond_1px')} | "
            f"{of['wrong_image_beyond_1px_not_tied']} | {share('wrong_image_pixels')}")


def head(*cells):
    return "| " + " | ".join(cells) + " |\n|" + " --- |" * len(cells)


def errors_table(scenes):
    lines = [head("scene", "shadows", "culling", "mask wrong %", "beyond 1 px %", "not tied", "image wrong %")]
    for name, of in scenes.items():
        for way in ("volumes", "primitive map"):
            lines += [f"| {name} | {way} | {cull} | {wrong(of[cull][way])} |" for cull in ("off", "auto")]
    return "\n".join(lines)


def costs_table(scenes):
    lines = [head("scene", "frame, off, ms", "auto, ms", "vertex runs, off", "auto")]
    for name, of in scenes.items():
        lines.append(f"| {name} | {of['off']['frame_ms']:.1f} | {of['auto']['frame_ms']:.1f} | "
                     f"{of['off']['vertex_runs']:,} | {of['auto']['vertex_runs']:,} |")
    return "\n".join(lines)


if __name__ == "__main__":
    results = results_of("culling", measured)
    told = (f"{results['machine']['cores']} cores of {results['machine']['processor']}, "
            f"{results['machine']['date']}, software renderer, {SIZE}")
    document = "docs/measured/culling.md"
    replace_between(document, "errors", f"{told}, {VIEWS} views.\n\n" + errors_table(results["scenes"]))
    replace_between(document, "costs", f"{told}.\n\n" + costs_table(results["scenes"]))
