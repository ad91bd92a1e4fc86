#!/usr/bin/env python3
"""Reads the files of sunhours --surfaces with Python's standard library alone.

    read_back.py EDGESHADE

Writes a scene of a turned house with a pitched roof, a shed and a lawn; runs the program; and
compares areas by node with those of the scene's triangles, hours with bits and with months, and the
mesh with the table.
"""

import array
import base64
import csv
import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile

HOUSE = [(-4, 0, -3), (4, 0, -3), (4, 0, 3), (-4, 0, 3),
         (-4, 5, -3), (4, 5, -3), (4, 5, 3), (-4, 5, 3), (-4, 8, 0), (4, 8, 0)]
HOUSE_FACES = [(0, 1, 2, 3), (0, 4, 5, 1), (2, 6, 7, 3), (4, 8, 9, 5), (6, 9, 8, 7),
               (1, 5, 9, 6, 2), (3, 7, 8, 4, 0)]
SHED = [(-1, 0, -1), (1, 0, -1), (1, 0, 1), (-1, 0, 1),
        (-1, 2, -1), (1, 2, -1), (1, 2, 1), (-1, 2, 1)]
SHED_FACES = [(0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0)]
LAWN = [(-20, 0, -20), (-20, 0, 20), (20, 0, 20), (20, 0, -20)]
TURN = math.radians(23)
NODES = [
    {"name": "house, \"A\"", "mesh": 0, "translation": [1200.5, 0, -840.25],
     "rotation": [0, math.sin(TURN / 2), 0, math.cos(TURN / 2)]},
    {"name": "shed", "mesh": 1, "translation": [1210, 0, -840], "scale": [1.5, 0.5, 2]},
    {"name": "lawn", "mesh": 2, "translation": [1200, -0.01, -840]}]


def triangles_of(faces):
    return [(face[0], face[i - 1], face[i]) for face in faces for i in range(2, len(face))]


MESHES = [(HOUSE, triangles_of(HOUSE_FACES)), (SHED, triangles_of(SHED_FACES)),
          (LAWN, [(0, 1, 2), (0, 2, 3)])]


def scene():
    binary, views, accessors, meshes = b"", [], [], []

    def add(data, kind, component, count, **more):
        nonlocal binary
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(data)})
        accessors.append({"bufferView": len(views) - 1, "componentType": component,
                          "count": count, "type": kind, **more})
        binary += data + b"\0" * (-len(data) % 4)
        return len(accessors) - 1

    for points, triangles in MESHES:
        flat = [float(x) for point in points for x in point]
        positions = add(struct.pack(f"<{len(flat)}f", *flat), "VEC3", 5126, len(points),
                        min=[min(p[i] for p in points) for i in range(3)],
                        max=[max(p[i] for p in points) for i in range(3)])
        indices = [i for triangle in triangles for i in triangle]
        meshes.append({"primitives": [{
            "attributes": {"POSITION": positions},
            "indices": add(struct.pack(f"<{len(indices)}I", *indices), "SCALAR", 5125,
                           len(indices))}]})
    uri = "data:application/octet-stream;base64," + base64.b64encode(binary).decode()
    return {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
            "nodes": NODES, "meshes": meshes, "accessors": accessors, "bufferViews": views,
            "buffers": [{"byteLength": len(binary), "uri": uri}]}


def area_of(a, b, c):
    u, v = [q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]
    return 0.5 * math.sqrt((u[1] * v[2] - u[2] * v[1]) ** 2 + (u[2] * v[0] - u[0] * v[2]) ** 2 +
                           (u[0] * v[1] - u[1] * v[0]) ** 2)


def area_of_node(node):
    points, triangles = MESHES[node["mesh"]]
    scale = node.get("scale", [1, 1, 1])  # turning and moving keep areas
    placed = [[x * s for x, s in zip(point, scale)] for point in points]
    return sum(area_of(*(placed[i] for i in triangle)) for triangle in triangles)


def near(found, wanted, tolerance, about):
    assert abs(found - wanted) <= tolerance * max(1.0, abs(wanted)), f"{about}: {found}, {wanted}"


def glb_of(path):
    data = path.read_bytes()
    magic, version, length = struct.unpack("<4sII", data[:12])
    assert (magic, version, length) == (b"glTF", 2, len(data))
    size = struct.unpack("<I", data[12:16])[0]
    return json.loads(data[20:20 + size]), data[28 + size:]


def check_mesh(path, rows):
    gltf, binary = glb_of(path)

    def values(index, code):
        accessor = gltf["accessors"][index]
        view = gltf["bufferViews"][accessor["bufferView"]]
        found = array.array(code)
        found.frombytes(binary[view["byteOffset"]:view["byteOffset"] + view["byteLength"]])
        return found

    for node in gltf["nodes"]:
        primitive = gltf["meshes"][node["mesh"]]["primitives"][0]
        positions = values(primitive["attributes"]["POSITION"], "f")
        hours = values(primitive["attributes"]["_HOURS"], "f")
        indices = values(primitive["indices"], "I")
        weighted = 0.0
        for i in range(0, len(indices), 3):
            corners = [positions[3 * v:3 * v + 3] for v in indices[i:i + 3]]
            weighted += area_of(*corners) * hours[indices[i]]
        mine = [row for row in rows if row["node"] == node["name"]]
        assert mine, node["name"]
        near(weighted, sum(float(r["area_m2"]) * float(r["hours"]) for r in mine), 1e-4,
             "hours of the mesh")


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "scene.gltf").write_text(json.dumps(scene()))
        names = ["cells.csv", "bits.npy", "cells.glb"]
        result = subprocess.run(
            [program, "sunhours", folder / "scene.gltf", *(folder / name for name in names),
             "--surfaces", "--grid", "1.5", "--place", "48.14,11.57", "--from", "2026-01-01",
             "--to", "2026-12-31", "--step", "240", "--when", "--report", folder / "report.json"],
            capture_output=True, text=True, check=False)
        if result.returncode == 3:
            print(result.stderr)
            return 77
        assert result.returncode == 0, result.stderr
        report = json.loads((folder / "report.json").read_text())
        with open(folder / "cells.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        assert len(rows) == report["cells"]

        for node in NODES:
            area = sum(float(r["area_m2"]) for r in rows if r["node"] == node["name"])
            near(area, area_of_node(node), 1e-6, node["name"])
        counted = sum(float(r["area_m2"]) for r in rows if not r["left_out"])
        near(counted, report["area"], 1e-12, "area of the report")

        data = (folder / "bits.npy").read_bytes()
        assert data[:8] == b"\x93NUMPY\x01\x00"
        size = struct.unpack("<H", data[8:10])[0]
        header = eval(data[10:10 + size].decode())  # a literal, as numpy reads it
        positions = report["positions"]
        assert header["shape"] == (len(rows), (len(positions) + 7) // 8), header
        bits = data[10 + size:]
        for i, row in enumerate(rows):
            mine = bits[i * header["shape"][1]:(i + 1) * header["shape"][1]]
            lit = [p for p in range(len(positions)) if mine[p // 8] >> (7 - p % 8) & 1]
            near(4.0 * len(lit), float(row["hours"]), 1e-12, f"bits of cell {i}")
            for month in range(1, 13):
                name = f"{month:02}"
                near(4.0 * sum(positions[p]["time"][5:7] == name for p in lit),
                     float(row["hours_" + name]), 1e-12, f"month {name} of cell {i}")
            if not lit:
                assert row["first"] == row["last"] == "", row
            else:
                assert row["first"] < positions[lit[0]]["time"] <= positions[lit[-1]]["time"]
                assert positions[lit[-1]]["time"] < row["last"], row
        assert any(float(r["hours"]) > 0 for r in rows)
        check_mesh(folder / "cells.glb", rows)
        print(f"{len(rows)} cells, {len(positions)} positions: all agree")
    return 0


sys.exit(main())
