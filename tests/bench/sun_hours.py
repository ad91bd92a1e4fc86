#!/usr/bin/env python3
"""Sun positions that `sunhours` counts wrong, against the oracle, and its time beside that of
Embree's rays, on models in ../shared/scenes over one day, seen from above and from the side: the
tables of docs/measured/sun-hours.md.

    tests/bench/sun_hours.py           measures, then the tables
    tests/bench/sun_hours.py --times   measures only times; takes errors from the stored results
    tests/bench/sun_hours.py --table   the tables from the stored results

EDGESHADE names the program, EDGESHADE_SUN_RAYS that of tests/bench/sun_rays.cpp.
"""

import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

from edgeshade_runs import RESULTS, ROOT, SCENES, figure, percent, replace_between, report, results_of

MODELS = {"city": "city.draco.glb", "temple": "temple.glb", "garden": "garden.draco.glb"}
VIEWS = {"plan": ("--plan",), "from the side": ()}
PLACE, DAY, STEP, SIZE = "48.14,11.57", "2026-03-21", 30, "480x360"
RUNS = 3  # complete runs, of which the median is reported
RAYS = os.environ.get("EDGESHADE_SUN_RAYS", str(ROOT / "build/release/tests/bench/sun_rays"))


def camera(told):
    matrix = ("--camera-matrix", ",".join(str(number) for number in told["matrix"]))
    return (*matrix, "--ortho", told["ortho"]) if "ortho" in told else (*matrix, "--fov", told["fov"])


def hours(path, words, folder):
    return report("sunhours", path, folder / "hours.png", "--place", PLACE, "--date", DAY, "--step", STEP,
                  "--size", SIZE, *words)


def wrong_of(path, words, folder):
    told = hours(path, words, folder)
    sums = {"wrong_mask_pixels": 0, "wrong_mask_beyond_1px": 0, "visible_pixels": 0, "tie_pixels": 0}
    for position in told["positions"]:
        sun = ",".join(str(number) for number in position["direction"])
        judged = report("compare", path, "--sun", sun, "--size", SIZE, *camera(told["camera"]))
        for key in sums:
            sums[key] += judged[key]
    return {"positions": len(told["positions"]), "mean_hours": told["hours"]["mean"], **sums}


def times_of(path, words, folder):
    """Seconds of complete runs, and sun_rays' times for counting and for Embree."""
    runs = []
    for _ in range(RUNS):
        began = time.monotonic()
        told = hours(path, words, folder)
        runs.append(time.monotonic() - began)
    (folder / "hours.json").write_text(json.dumps(told))
    done = subprocess.run([RAYS, path, folder / "hours.json", *SIZE.split("x")], check=True,
                          stdout=subprocess.PIPE)
    return {"seconds": runs, **json.loads(done.stdout)}


def measured():
    old = {}
    if sys.argv[1:2] == ["--times"]:
        old = json.loads((RESULTS / "sun_hours.json").read_text())["scenes"]
    scenes = {}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for model, file in MODELS.items():
            scenes[model] = {}
            for view, words in VIEWS.items():
                wrong = old[model][view] if old else wrong_of(SCENES / file, words, folder)
                scenes[model][view] = wrong | times_of(SCENES / file, words, folder)
    return scenes


def rows_of(scenes):
    return [(name, view, of) for name, views in scenes.items() for view, of in views.items()]


def table(scenes):
    lines = ["| scene | view | positions | mean hours | counted wrong, % | beyond 1 px, % |", "|" + " --- |" * 6]
    for name, view, of in rows_of(scenes):
        wrong = figure(percent(of["wrong_mask_pixels"], of["visible_pixels"]))
        beyond = figure(percent(of["wrong_mask_beyond_1px"], of["visible_pixels"]))
        lines.append(f"| {name} | {view} | {of['positions']} | {of['mean_hours']:.2f} | {wrong} | {beyond} |")
    return "\n".join(lines)


def times_table(scenes):
    lines = ["| scene | view | rays, millions | whole run, s | upload, s | counting, s | Embree: tree, s | rays, s "
             "| counting / rays | lit by rays / by counting |", "|" + " --- |" * 10]
    for name, view, of in rows_of(scenes):
        medians = [statistics.median(of[key]) for key in ("seconds", "upload_s", "count_s", "tree_s", "rays_s")]
        ratio = statistics.median(count / rays for count, rays in zip(of["count_s"], of["rays_s"]))
        lines.append(f"| {name} | {view} | {figure(of['rays'] / 1e6)} | "
                     + " | ".join(map(figure, medians))
                     + f" | {figure(ratio)} | {of['lit_by_rays'] / of['lit_by_count']:.5f} |")
    return "\n".join(lines)


if __name__ == "__main__":
    results = results_of("sun_hours", measured)
    told = (f"{results['machine']['cores']} cores of {results['machine']['processor']}, "
            f"{results['machine']['date']}, software renderer, {SIZE}, {PLACE}, {DAY}, a position every "
            f"{STEP} minutes.")
    replace_between("docs/measured/sun-hours.md", "counts", told + "\n\n" + table(results["scenes"]))
    replace_between("docs/measured/sun-hours.md", "times", times_table(results["scenes"]))
