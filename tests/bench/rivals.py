#!/usr/bin/env python3
"""Brute-force volumes and planar shadows against volumes and the published method, for a sun and a
lamp: wrong pixels, frame times, bytes. The tables of docs/measured/rivals.md and the picture
docs/pictures/rivals.png.

    tests/bench/rivals.py             measures, then tables and the picture
    tests/bench/rivals.py --table     tables from the stored results
    tests/bench/rivals.py --picture   only the picture

EDGESHADE names the program.
"""

import pathlib
import random
import subprocess
import sys
import tempfile

from culling import glb
from edgeshade_runs import (PROGRAM, ROOT, against, figure, mean, percent, replace_between, report,
                            results_of)
from lit_models import MODELS, lit_models
from maps import below, bytes_text
from png_bytes import read_png, side_by_side, write_png

SIZE, VIEWS, FRAMES = "160x120", 2, 2
FIRST = "volumes"
FAIL, PASS = "brute force, z-fail", "brute force, z-pass"
PLANAR = {f"planar {count}": f"shadows=planar,planes={count}" for count in (1, 4, 16)}
AGAINST = {"published": "shadows=volumes,layout=published",
           FAIL: "shadows=volumes,layout=brute-force",
           PASS: "shadows=volumes,layout=brute-force,count=z-pass",
           "no shadows": "shadows=none", **PLANAR}


def case(path, light):
    others = against(AGAINST.values())
    judged = report("compare", path, *light, "--size", SIZE, "--views", VIEWS, *others)["results"]
    told = report("bench", path, *light, "--size", SIZE, "--frames", FRAMES, "--warm-up", 1, *others)
    rows = {}
    for name, errors, times in zip([FIRST, *AGAINST], judged, told["results"]):
        visible = errors["visible_pixels"]
        rows[name] = {"mask": percent(errors["wrong_mask_pixels"], visible),
                      "mask_beyond": percent(errors["wrong_mask_beyond_1px"], visible),
                      "wrong": percent(errors["wrong_image_pixels"], visible),
                      "beyond": percent(errors["wrong_image_beyond_1px"], visible),
                      "ms": times["frame_ms"]["median"], "bytes": times["bytes_gpu"],
                      "runs": times["vertex_runs"]}
    return {"renderer": told["results"][0]["device"]["renderer"], "rows": rows}


def measured():
    return {name: case(path, light) for name, path, _, light in lit_models()}


# Slopes of the light's rays across the near plane, per 1 along it. At the last one the program no
# longer uses ZP+.
TILTS = (1, 0.1, 0.01, 0.003, 0.0015, 0.0005)


def leaves():
    """Five hundred small triangles above the eye, around the near plane, and a wall behind them that
    is not clipped."""
    chance = random.Random(2005)
    a, b, c, d = [[x, y, -6] for x, y in ((-4.5, -4.5), (4.5, -4.5), (4.5, 4.5), (-4.5, 4.5))]
    triangles = [[a, b, c], [a, c, d]]
    for _ in range(500):
        middle = [chance.uniform(-1.5, 1.5), chance.uniform(1, 3), chance.uniform(-2.5, 1)]
        triangles.append([[m + chance.uniform(-0.15, 0.15) for m in middle] for _ in range(3)])
    return triangles


def near_plane():
    """An eye in the shadows of leaves, whose outlines cross the near plane."""
    rows = {}
    with tempfile.TemporaryDirectory() as folder:
        path = glb(pathlib.Path(folder) / "leaves.glb", (), leaves())
        for tilt in TILTS:
            judged = report("compare", path, "--camera-from", "0,0,1", "--camera-to", "0,0,-6", "--fov", 70,
                            "--near", 1, "--sun", f"0,1,{tilt}", "--size", "640x480",
                            "--against", AGAINST[FAIL], "--against", AGAINST[PASS])["results"][1:]
            rows[str(tilt)] = [[of[key] for key in ("wrong_mask_pixels", "wrong_mask_beyond_1px")] for of in judged]
    return rows


def near_table(results):
    lines = ["| tilt | z-fail: mask wrong, pixels | beyond 1 px | z-pass: mask wrong, pixels | beyond 1 px |",
             "|" + " --- |" * 5]
    lines += [f"| {tilt} | " + " | ".join(str(count) for of in rows for count in of) + " |"
              for tilt, rows in results["scenes"].items()]
    return "\n".join(lines)


def row_of(name, shadows, row, first):
    return (f"| {name} | {shadows} | {figure(row['mask'])} | {figure(row['mask_beyond'])} | "
            f"{figure(row['wrong'])} | {figure(row['beyond'])} | {figure(row['ms'] / first['ms'])} | "
            f"{bytes_text(row['bytes'])} |")


def table(results):
    machine, scenes = results["machine"], results["scenes"]
    renderer = next(iter(scenes.values()))["renderer"]
    lines = [f"{machine['cores']} cores of {machine['processor']}, {machine['date']}, {renderer}, {SIZE}, "
             f"{VIEWS} views, {FRAMES} frames.", "",
             "| scene, light | shadows | mask wrong, % | beyond 1 px, % | image wrong, % | beyond 1 px, % | "
             "frame / volumes' | MB |", "|" + " --- |" * 8]
    lines += [row_of(name, shadows, row, of["rows"][FIRST])
              for name, of in scenes.items() for shadows, row in of["rows"].items()]
    return "\n".join(lines)


def means(results):
    """Means over all scenes and lights, with equal weights; for frame times the geometric mean of
    ratios."""
    cases = [of["rows"] for of in results["scenes"].values()]
    lines = ["| shadows | mask wrong, % | beyond 1 px, % | image wrong, % | beyond 1 px, % | "
             "frame / volumes' | least .. most |", "|" + " --- |" * 7]
    for shadows in cases[0]:
        ratios = [rows[shadows]["ms"] / rows[FIRST]["ms"] for rows in cases]
        errors = [sum(rows[shadows][key] for rows in cases) / len(cases)
                  for key in ("mask", "mask_beyond", "wrong", "beyond")]
        lines.append(f"| {shadows} | {' | '.join(figure(error) for error in errors)} | "
                     f"{figure(mean(ratios))} | {figure(min(ratios))} .. {figure(max(ratios))} |")
    passes = [rows[PASS]["ms"] / rows[FAIL]["ms"] for rows in cases]
    worse = sum(rows[PASS]["mask"] > rows[FAIL]["mask"] for rows in cases)
    better = sum(rows[PASS]["mask"] < rows[FAIL]["mask"] for rows in cases)
    lines += ["", f"A frame of z-pass takes {figure(mean(passes))} of the time of a frame of z-fail "
              f"({figure(min(passes))} .. {figure(max(passes))}). In {worse} of {len(cases)} cases the mask has more "
              f"wrong pixels than with z-fail, in {better} fewer."]
    return "\n".join(lines)


def draw_picture():
    """The pavilion by each method: a sun above, a lamp below."""
    view = ("--size", "240x180", "--camera-from", "3.4,2.2,4.6", "--camera-to", "0.4,0.5,0.6", "--fov", "40")
    settings = ("shadows=volumes", AGAINST[FAIL], AGAINST[PASS], PLANAR["planar 1"], PLANAR["planar 16"])
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out.png"

        def drawn(light, setting):
            words = [word for part in setting.split(",") for word in ("--" + part.split("=")[0], part.split("=")[1])]
            subprocess.run([PROGRAM, "render", MODELS["pavilion"], out, *view, *light, *words], check=True,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            return read_png(out)

        rows = [side_by_side([drawn(light, setting) for setting in settings])
                for light in (("--sun", "0.6,0.7,0.5"), ("--light", "0.4,2.1,0.9"))]
        write_png(ROOT / "docs" / "pictures" / "rivals.png", below(rows))


def main():
    if sys.argv[1:2] != ["--picture"]:
        results = results_of("rivals", measured)
        replace_between("docs/measured/rivals.md", "means", means(results))
        replace_between("docs/measured/rivals.md", "rivals", table(results))
        replace_between("docs/measured/rivals.md", "near", near_table(results_of("rivals_near", near_plane)))
    if sys.argv[1:2] != ["--table"]:
        draw_picture()


if __name__ == "__main__":
    main()
