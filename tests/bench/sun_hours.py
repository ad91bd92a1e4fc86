#!/usr/bin/env python3
"""Sun positions that `sunhours` counts wrong by masks, against the oracle, and the processor's time
that masks, certified rays and Embree's own rays take, on models in ../shared/scenes over one day, seen
from above and from the side: the tables of docs/measured/sun-hours.md.

    tests/bench/sun_hours.py           measures, then the tables
    tests/bench/sun_hours.py --times   measures only times; takes errors from the stored results
    tests/bench/sun_hours.py --table   the tables from the stored results

EDGESHADE names the program, EDGESHADE_SUN_RAYS that of tests/bench/sun_rays.cpp.
"""

import json
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile

from edgeshade_runs import RESULTS, ROOT, SCENES, figure, percent, replace_between, report, results_of

MODELS = {"city": "city.draco.glb", "temple": "temple.glb", "garden": "garden.draco.glb"}
VIEWS = {"plan": ("--plan",), "from the side": ()}
PLACE, DAY, STEP, SIZE = "48.14,11.57", "2026-03-21", 30, "480x360"
FINE_STEP = 10  # minutes, the default
RUNS = {STEP: 3, FINE_STEP: 1}  # complete runs, of which the median is reported
WRONG = ("positions", "mean_hours", "wrong_mask_pixels", "wrong_mask_beyond_1px", "visible_pixels", "tie_pixels")
RAYS = os.environ.get("EDGESHADE_SUN_RAYS", str(ROOT / "build/release/tests/bench/sun_rays"))


def camera(told):
    matrix = ("--camera-matrix", ",".join(str(number) for number in told["matrix"]))
    return (*matrix, "--ortho", told["ortho"]) if "ortho" in told else (*matrix, "--fov", told["fov"])


def hours(path, words, folder):
    words = words if "--step" in words else (*words, "--step", STEP)
    return report("sunhours", path, folder / "hours.png", "--place", PLACE, "--date", DAY, "--size", SIZE, *words)


def wrong_of(path, words, folder):
    told = hours(path, (*words, "--by", "masks"), folder)
    sums = {"wrong_mask_pixels": 0, "wrong_mask_beyond_1px": 0, "visible_pixels": 0, "tie_pixels": 0}
    for position in told["positions"]:
        sun = ",".join(str(number) for number in position["direction"])
        judged = report("compare", path, "--sun", sun, "--size", SIZE, *camera(told["camera"]))
        for key in sums:
            sums[key] += judged[key]
    return {"positions": len(told["positions"]), "mean_hours": told["hours"]["mean"], **sums}


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def times_of(path, words, folder):
    """Processor seconds of complete runs, masks and rays in turn, and those of sun_rays."""
    runs = {f"{way}_{step}": [] for way in ("masks", "rays") for step in (STEP, FINE_STEP)}
    for step, count in RUNS.items():
        for _ in range(count):
            for way in ("masks", "rays"):
                began = processor_seconds()
                told = hours(path, (*words, "--step", step, "--by", way), folder)
                runs[f"{way}_{step}"].append(processor_seconds() - began)
    told = hours(path, (*words, "--by", "rays"), folder)
    (folder / "hours.json").write_text(json.dumps(told))
    done = subprocess.run([RAYS, path, folder / "hours.json", *SIZE.split("x")], check=True,
                          stdout=subprocess.PIPE)
    return {"runs": runs, **json.loads(done.stdout)}


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
                wrong = ({key: old[model][view][key] for key in WRONG} if old
                         else wrong_of(SCENES / file, words, folder))
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
    lines = ["| scene | view | rays, millions | by masks, s | by rays, s | masks / rays | every 10 min: by masks, s "
             "| by rays, s | masks / rays |", "|" + " --- |" * 9]
    for name, view, of in rows_of(scenes):
        cells = [figure(of["rays"] / 1e6)]
        for step in (STEP, FINE_STEP):
            masks, rays = (statistics.median(of["runs"][f"{way}_{step}"]) for way in ("masks", "rays"))
            cells += [figure(masks), figure(rays), figure(masks / rays)]
        lines.append(f"| {name} | {view} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def rays_table(scenes):
    lines = ["| scene | view | counting by masks, s | Embree: tree, s | rays, s | certified: tree, s | rays, s "
             "| masks / certified | certified / Embree | lit by Embree / by certified |", "|" + " --- |" * 10]
    for name, view, of in rows_of(scenes):
        keys = ("count_s", "tree_s", "rays_s", "certified_tree_s", "certified_rays_s")
        medians = [statistics.median(of[key]) for key in keys]
        masks, _, rays, _, certified = medians
        lines.append(f"| {name} | {view} | " + " | ".join(map(figure, medians))
                     + f" | {figure(masks / certified)} | {certified / rays:.2f} "
                     f"| {of['lit_by_rays'] / of['lit_by_certified_rays']:.5f} |")
    return "\n".join(lines)


if __name__ == "__main__":
    results = results_of("sun_hours", measured)
    told = (f"{results['machine']['cores']} cores of {results['machine']['processor']}, "
            f"{results['machine']['date']}, software renderer, {SIZE}, {PLACE}, {DAY}, a position every "
            f"{STEP} minutes.")
    replace_between("docs/measured/sun-hours.md", "counts", told + "\n\n" + table(results["scenes"]))
    replace_between("docs/measured/sun-hours.md", "times", times_table(results["scenes"]))
    replace_between("docs/measured/sun-hours.md", "rays", rays_table(results["scenes"]))
