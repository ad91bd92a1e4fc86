"""The keys of the verbs' JSON reports, as paths with the kinds of their values."""

import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/bench"))
from culling import box, floor, glb  # noqa: E402

VIEW = ("--size", "48x32")
DAY = ("--place", "48.1,11.6", "--date", "2026-03-20", "--step", "240")

# A name and the words after `edgeshade`, with files of the scene's folder.
CALLS = (
    ("pack", ("pack", "scene.glb", "packed.glb")),
    ("info", ("info", "scene.glb")),
    ("render", ("render", "scene.glb", "picture.png", "--mask", *VIEW, "--light", "1,5,2", "--light-radius", "0.1", "--light-samples", "2")),
    ("compare", ("compare", "scene.glb", "--views", "1", *VIEW)),
    ("compare --against", ("compare", "scene.glb", "--views", "1", *VIEW, "--against", "shadows=map,map-size=64")),
    ("bench", ("bench", "scene.glb", "--frames", "2", *VIEW)),
    ("bench --against", ("bench", "scene.glb", "--frames", "2", *VIEW, "--against", "shadows=map,map-size=64")),
    ("sunhours", ("sunhours", "scene.glb", "hours.png", *VIEW, *DAY, "--at", "0,0.1,0")),
)

# Objects whose keys are numbers of the scene.
BY_NAME = {"edges_by_opposite_count"}


def draw_scene(folder):
    """A box above a floor and an open quad, with degenerate triangles, as scene.glb."""
    glb(folder / "scene.glb", box([-0.5, 0.5, -0.5], [0.5, 1.5, 0.5]),
        floor(4, 0) + [[[1, 1, 1], [2, 1, 1], [2, 2, 1]], [[1, 1, 1], [1, 1, 1], [2, 1, 1]]])


def keys_of(value, path=""):
    """"lights[].method: string" and so on; an array's elements share their keys."""
    kinds = {dict: "object", list: "array", str: "string", bool: "boolean", type(None): "null"}
    if isinstance(value, dict):
        name = path.rsplit(".", 1)[-1]
        lines = []
        for key, inner in value.items():
            lines += keys_of(inner, f"{path}.{'*' if name in BY_NAME else key}".lstrip("."))
        return list(dict.fromkeys(lines)) or [f"{path}: object"]
    if isinstance(value, list) and value:
        return list(dict.fromkeys(line for inner in value for line in keys_of(inner, path + "[]")))
    return [f"{path}: {kinds.get(type(value), 'number')}"]


def report_keys(program, folder):
    """(lines, verbs that can't run here). Throws RuntimeError if one fails otherwise."""
    draw_scene(folder)
    lines, missing = [], []
    for name, words in CALLS:
        done = subprocess.run([program, *words, "--report", "-"], cwd=folder, capture_output=True, text=True)
        if done.returncode == 3:
            missing.append(name)
            continue
        if done.returncode:
            raise RuntimeError(f"edgeshade {' '.join(words)} fails: {done.stderr.strip()}")
        lines += [f"{name} {line}" for line in keys_of(json.loads(done.stdout))]
    return lines, missing
