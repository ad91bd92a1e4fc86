#!/usr/bin/env python3
"""Cost of a new pose, for a generated figure with a skin, a generated ball with morph targets, and
the model with a skin in ../shared/scenes: the tables of docs/measured/posing.md.

    tests/bench/posing.py           measures natively and in Chromium, then the tables
    tests/bench/posing.py --table   the tables from the stored results

Chromium runs build/web, which './run web --build-only' makes; run 'npm ci' in web/ first.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

from edgeshade_runs import ROOT, SCENES, figure, replace_between, results_of

TOOLS = ROOT / "build" / "release" / "tests" / "bench"
AUTHORED = {"figure": ("figure", 32, 53), "ball": ("ball", 100, 100)}
MAN = SCENES / "looks" / "man.glb"
SIDES = ("volumes", "map 1024", "map 2048")


def scenes(folder):
    """Name and file of each scene; generated scenes are written each time."""
    for name, (kind, sides, rings) in AUTHORED.items():
        path = pathlib.Path(folder) / f"{name}.glb"
        subprocess.run([TOOLS / "write_moving_scene", kind, path, str(sides), str(rings)],
                       check=True)
        yield name, path
    if MAN.exists():
        yield "man", MAN
    else:
        print(f"skipped: {MAN} is not there", file=sys.stderr)


def told_by(*words):
    return json.loads(subprocess.run(words, check=True, stdout=subprocess.PIPE).stdout)


def measured():
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        for name, path in scenes(folder):
            print(name, file=sys.stderr)
            found[name] = {"native": told_by(TOOLS / "posing_times", path),
                           "browser": told_by("node", ROOT / "web/compare/measure-posing.mjs", path)}
    return found


def stages(results):
    lines = ["| scene | deforming triangles | positions and normals | records, planes and boxes | "
             "silhouettes | bound of layers | with uploads, in a viewer | in Chromium |",
             "|" + " --- |" * 8]
    for name, of in results.items():
        native, at = of["native"], of["native"]["stages"]
        lines.append(
            f"| {name} | {native['deforming_triangles']:,} | {figure(at['pose_ms'])} | "
            f"{figure(at['refresh_ms'])} | {figure(at['silhouettes_ms'])} | "
            f"{figure(at['layers_ms'])} | {figure(native['volumes']['pose_and_upload_ms'])} | "
            f"{figure(of['browser']['volumes']['pose_ms'])} |")
    return "\n".join(lines)


def frames(results):
    heads = [f"{side}: {pose}" for side in SIDES for pose in ("another pose", "the same")]
    lines = ["| scene | where | " + " | ".join(heads) + " | map 2048 / volumes |",
             "|" + " --- |" * (len(heads) + 3)]
    for name, of in results.items():
        for where in ("native", "browser"):
            at = of[where]
            cells = [f"{at[side][kind]:.1f}" for side in SIDES for kind in ("moving_ms", "still_ms")]
            ratio = at["map 2048"]["moving_ms"] / at["volumes"]["moving_ms"]
            lines.append(f"| {name} | {where} | " + " | ".join(cells) + f" | {ratio:.2f} |")
    return "\n".join(lines)


if __name__ == "__main__":
    results = results_of("posing", measured)["scenes"]
    replace_between("docs/measured/posing.md", "stages", stages(results))
    replace_between("docs/measured/posing.md", "frames", frames(results))
