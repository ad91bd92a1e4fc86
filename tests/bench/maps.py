#!/usr/bin/env python3
"""Shadow maps of all kinds and filters, for a sun and a lamp: wrong pixels, frames, bytes. The
tables of docs/measured/maps.md and the picture docs/pictures/maps.png.

    tests/bench/maps.py             measures, then tables and the picture
    tests/bench/maps.py --rest      measures only missing results, scene by scene, then as above
    tests/bench/maps.py --table     tables from the stored results
    tests/bench/maps.py --picture   only the picture

EDGESHADE names the program.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

from edgeshade_runs import (PROGRAM, RESULTS, ROOT, figure, machine, percent, replace_between,
                            report, results_of, write_results)
from lit_models import MODELS, lit_models
from png_bytes import Picture, read_png, side_by_side, write_png

SIZE, VIEWS, FRAMES = "240x135", 2, 2
MAP = "shadows=map,map-size="

# All maps have the same number of texels: 1024 x 1024, and for lamps 6 x 512 x 512.
SUN = {"one map 1024": "1024", "PCF 3": "1024,pcf=3", "Poisson": "1024,filter=poisson",
       "VSM": "1024,filter=vsm", "ESM": "1024,filter=esm",
       "cascades 4 x 512": "512,map-kind=cascades", "cascades 4 x 512, Poisson": "512,map-kind=cascades,filter=poisson",
       "cascades 4 x 512, VSM": "512,map-kind=cascades,filter=vsm",
       "cascades 1 x 1024": "1024,map-kind=cascades,cascades=1",
       # A lattice's nodes and the cut casters come in addition. Moments take two texels per place,
       # with the same number of bytes.
       "rectilinear warp 1024": "1024,map-kind=warped",
       "non-orthogonal warp 1024": "1024,map-kind=warped,warp=non-orthogonal",
       "rectilinear warp 1024, Poisson": "1024,map-kind=warped,filter=poisson",
       "non-orthogonal warp 1024, Poisson": "1024,map-kind=warped,warp=non-orthogonal,filter=poisson",
       "MSM 724": "724,filter=msm", "MSM 1024": "1024,filter=msm",
       "cascades 4 x 1024": "1024,map-kind=cascades"}
LAMP = {"cube 6 x 512": "512", "PCF 3": "512,pcf=3", "Poisson": "512,filter=poisson",
        "VSM": "512,filter=vsm", "ESM": "512,filter=esm", "MSM 6 x 362": "362,filter=msm",
        "paraboloids 2 x 888": "888,map-kind=paraboloid",
        "paraboloids 2 x 888, VSM": "888,map-kind=paraboloid,filter=vsm"}


def case(path, light, contenders):
    """Errors and times of one case. `compare` tunes biases for the fewest wrong pixels over its views,
    as a user would."""
    against = [word for of in contenders.values() for word in ("--against", MAP + of)]
    judged = report("compare", path, *light, "--size", SIZE, "--views", VIEWS, *against)["results"]
    tuned = [f"{MAP}{of},map-bias={result['settings']['map-bias']}"
             for of, result in zip(contenders.values(), judged[1:])]
    told = report("bench", path, *light, "--size", SIZE, "--frames", FRAMES, "--warm-up", 1,
                  *(word for of in tuned for word in ("--against", of)))
    rows = {}
    for name, errors, times in zip(["volumes", *contenders], judged, told["results"]):
        visible = errors["visible_pixels"]
        rows[name] = {"wrong": percent(errors["wrong_image_pixels"], visible),
                      "beyond": percent(errors["wrong_image_beyond_1px"], visible),
                      "bias": errors["settings"].get("map-bias"),
                      "ms": times["frame_ms"]["median"], "bytes": times["bytes_gpu"]}
    return {"renderer": told["results"][0]["device"]["renderer"], "rows": rows}


def measured():
    """Measures all cases, and stores the results after each, since they take most of an hour."""
    kept = RESULTS / "maps.json"
    results = json.loads(kept.read_text())["scenes"] if sys.argv[1:2] == ["--rest"] and kept.exists() else {}
    for name, path, kind, light in lit_models(kept=tuple(results)):
        results[name] = case(path, light, {"sun": SUN, "lamp": LAMP}[kind])
        write_results("maps", {"machine": machine(), "scenes": results})
    return results


def bytes_text(count):
    return figure(count / 2**20)


def row_of(name, shadows, row):
    bias = "" if row["bias"] is None else f"{row['bias']:g}"
    return (f"| {name} | {shadows} | {figure(row['wrong'])} | {figure(row['beyond'])} | {bias} | "
            f"{figure(row['ms'])} | {bytes_text(row['bytes'])} |")


def head(first):
    return [f"| {first} | shadows | image wrong, % | beyond 1 px, % | bias | frame, ms | MB |",
            "|" + " --- |" * 7]


def table(results):
    """For each light the means over scenes, with equal weights, then the single scenes."""
    machine, scenes = results["machine"], results["scenes"]
    renderer = next(iter(scenes.values()))["renderer"]
    lines = [f"{machine['cores']} cores of {machine['processor']}, {machine['date']}, {renderer}, {SIZE}, "
             f"{VIEWS} views, {FRAMES} frames.", ""]
    lines += ["| light | shadows | image wrong, % | beyond 1 px, % | scenes with fewer wrong pixels than the first map |",
              "|" + " --- |" * 5]
    for kind, first in (("sun", next(iter(SUN))), ("lamp", next(iter(LAMP)))):
        of = [scene["rows"] for name, scene in scenes.items() if name.endswith(kind)]
        for shadows in of[0]:
            mean = {key: sum(rows[shadows][key] for rows in of) / len(of) for key in ("wrong", "beyond")}
            better = sum(rows[shadows]["wrong"] < rows[first]["wrong"] for rows in of)
            lines.append(f"| {kind} | {shadows} | {figure(mean['wrong'])} | {figure(mean['beyond'])} | "
                         f"{'' if shadows == first else f'{better} of {len(of)}'} |")
    lines += ["", *head("scene, light")]
    lines += [row_of(name, shadows, row) for name, of in scenes.items() for shadows, row in of["rows"].items()]
    return "\n".join(lines)


def below(pictures, gap=4):
    """Joins pictures of equal width into one, from top to bottom."""
    blank = [bytes([255] * len(pictures[0].rows[0]))] * gap
    rows = []
    for picture in pictures:
        rows += ([] if not rows else blank) + list(picture.rows)
    return Picture(pictures[0].width, len(rows), pictures[0].channels, rows)


def draw_picture():
    """The pavilion by every method, coarse enough to show their differences."""
    view = ("--size", "240x180", "--camera-from", "3.4,2.2,4.6", "--camera-to", "0.4,0.5,0.6", "--fov", "40")
    sun, lamp = ("--sun", "0.6,0.7,0.5"), ("--light", "0.4,2.1,0.9")
    rows = [
        [(sun, "shadows=volumes"), (sun, MAP + "512"), (sun, MAP + "256,map-kind=cascades"), (sun, MAP + "512,pcf=3")],
        [(sun, MAP + "512,filter=poisson"), (sun, MAP + "512,filter=vsm,map-bias=0.5"),
         (sun, MAP + "512,filter=esm"), (sun, MAP + "256,map-kind=cascades,filter=vsm,map-bias=0.5")],
        [(sun, MAP + "512,map-kind=warped"), (sun, MAP + "512,map-kind=warped,warp=non-orthogonal"),
         (sun, MAP + "512,filter=msm,map-bias=0.5"),
         (sun, MAP + "512,map-kind=warped,warp=non-orthogonal,filter=msm,map-bias=0.5")],
        [(lamp, "shadows=volumes"), (lamp, MAP + "256"), (lamp, MAP + "444,map-kind=paraboloid"),
         (lamp, MAP + "444,map-kind=paraboloid,filter=vsm,map-bias=0.5")]]
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out.png"

        def drawn(light, setting):
            words = [word for part in setting.split(",") for word in ("--" + part.split("=")[0], part.split("=")[1])]
            subprocess.run([PROGRAM, "render", MODELS["pavilion"], out, *view, *light, *words], check=True,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            return read_png(out)

        write_png(ROOT / "docs" / "pictures" / "maps.png",
                  below([side_by_side([drawn(*one) for one in row]) for row in rows]))


def main():
    if sys.argv[1:2] != ["--picture"]:
        replace_between(ROOT / "docs" / "measured" / "maps.md", "maps", table(results_of("maps", measured)))
    if sys.argv[1:2] != ["--table"]:
        draw_picture()


if __name__ == "__main__":
    main()
