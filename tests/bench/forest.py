"""Generates a forest as glTF: a ground, and one tree's mesh in many places, rotated and scaled, with
EXT_mesh_gpu_instancing."""

import json
import math
import random
import struct


def frustum(sides, low, high, first):
    """A closed frustum around the y axis; `low` and `high`: (radius, y)."""
    corners = [(radius * math.cos(2 * math.pi * i / sides), y,
                radius * math.sin(2 * math.pi * i / sides))
               for radius, y in (low, high) for i in range(sides)]
    corners += [(0, low[1], 0), (0, high[1], 0)]
    triangles = []
    for i in range(sides):
        j = (i + 1) % sides
        triangles += [(i, sides + i, sides + j), (i, sides + j, j), (2 * sides, i, j),
                      (2 * sides + 1, sides + j, sides + i)]
    return corners, [tuple(first + corner for corner in t) for t in triangles]


def tree(sides, crowns):
    """A trunk and crowns, each closed: 4 * sides * (1 + crowns) triangles."""
    corners, triangles = frustum(sides, (0.08, 0), (0.06, 0.6), 0)
    for i in range(crowns):
        y = 0.35 + 1.6 * i / crowns
        more = frustum(sides, (0.55 * (1 - i / (crowns + 0.5)), y),
                       (0.05, y + 1 / crowns + 0.3 * (1 - i / crowns)), len(corners))
        corners += more[0]
        triangles += more[1]
    return corners, triangles


def write_forest(path, count, sides=12, crowns=6):
    """Returns the number of a tree's triangles."""
    draw = random.Random(1)
    binary, views, accessors = b"", [], []

    def add(values, form, kind, component, bounds=False):
        nonlocal binary
        data = b"".join(struct.pack(form, *value) for value in values)
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(data)})
        accessors.append({"bufferView": len(views) - 1, "componentType": component,
                          "count": len(values), "type": kind})
        if bounds:
            accessors[-1]["min"] = [min(axis) for axis in zip(*values)]
            accessors[-1]["max"] = [max(axis) for axis in zip(*values)]
        binary += data + bytes(-len(data) % 4)
        return len(accessors) - 1

    def mesh(corners, triangles, material):
        indices = [(corner,) for triangle in triangles for corner in triangle]
        return {"primitives": [{
            "attributes": {"POSITION": add(corners, "<3f", "VEC3", 5126, bounds=True)},
            "indices": add(indices, "<H", "SCALAR", 5123), "material": material}]}

    corners, triangles = tree(sides, crowns)
    row, apart = math.ceil(math.sqrt(count)), 3.0
    places, turns, scales = [], [], []
    for i in range(count):
        places.append(tuple((at - (row - 1) / 2 + draw.uniform(-0.3, 0.3)) * apart if axis != 1
                            else 0.0 for axis, at in enumerate((i % row, 0, i // row))))
        angle, scale = draw.uniform(0, math.pi), draw.uniform(0.7, 1.4)
        turns.append((0.0, math.sin(angle), 0.0, math.cos(angle)))
        scales.append((scale, scale * draw.uniform(0.9, 1.2), scale))
    end = row * apart / 2 + 2
    ground = [(-end, 0, -end), (end, 0, -end), (end, 0, end), (-end, 0, end)]
    meshes = [mesh(corners, triangles, 0), mesh(ground, [(0, 2, 1), (0, 3, 2)], 1)]
    attributes = {"TRANSLATION": add(places, "<3f", "VEC3", 5126),
                  "ROTATION": add(turns, "<4f", "VEC4", 5126),
                  "SCALE": add(scales, "<3f", "VEC3", 5126)}
    colors = [[0.25, 0.5, 0.2, 1], [0.7, 0.65, 0.55, 1]]
    text = json.dumps({
        "asset": {"version": "2.0"}, "extensionsUsed": ["EXT_mesh_gpu_instancing"],
        "scenes": [{"nodes": [0, 1]}],
        "nodes": [{"mesh": 1}, {"mesh": 0, "extensions": {
            "EXT_mesh_gpu_instancing": {"attributes": attributes}}}],
        "meshes": meshes,
        "materials": [{"pbrMetallicRoughness": {"baseColorFactor": color, "metallicFactor": 0}}
                      for color in colors],
        "accessors": accessors, "bufferViews": views, "buffers": [{"byteLength": len(binary)}],
    }).encode()
    text += b" " * (-len(text) % 4)
    with open(path, "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(binary)))
        file.write(struct.pack("<I4s", len(text), b"JSON") + text)
        file.write(struct.pack("<I4s", len(binary), b"BIN\0") + binary)
    return len(triangles)
