#!/usr/bin/env python3
"""How many sun positions `sunhours` counts wrong, against the oracle: the table of
docs/measured/sun-hours.md. Of models in ../shared/scenes, one day seen from above and from the side.

    tests/bench/sun_hours.py           measures, then the table
    tests/bench/sun_hours.py --table   the table from the results that are there

EDGESHADE names the program.
"""

import pathlib
import tempfile
import time

from edgeshade_runs import SCENES, figure, percent, replace_between, report, results_of

MODELS = {"city": "city.draco.glb", "temple": "temple.glb", "garden": "garden.draco.glb"}
PLACE, DAY, STEP, SIZE = "48.14,11.57", "2026-03-21", 30, "480x360"


def camera(told):
    matrix = ("--camera-matrix", ",".join(str(number) for number in told["matrix"]))
    return (*matrix, "--ortho", told["ortho"]) if "ortho" in told else (*matrix, "--fov", told["fov"])


def of_view(path, words, folder):
    began = time.monotonic()
    told = report("sunhours", path, folder / "hours.png", "--place", PLACE, "--date", DAY, "--step", STEP,
                  "--size", SIZE, *words)
    seconds = time.monotonic() - began
    sums = {"wrong_mask_pixels": 0, "wrong_mask_beyond_1px": 0, "visible_pixels": 0, "tie_pixels": 0}
    for position in told["positions"]:
        sun = ",".join(str(number) for number in position["direction"])
        judged = report("compare", path, "--sun", sun, "--size", SIZE, *camera(told["camera"]))
        for key in sums:
            sums[key] += judged[key]
    return {"positions": len(told["positions"]), "mean_hours": told["hours"]["mean"], "seconds": seconds,
            **sums}


def measured():
    with tempfile.TemporaryDirectory() as folder:
        return {name: {"plan": of_view(SCENES / file, ("--plan",), pathlib.Path(folder)),
                       "from the side": of_view(SCENES / file, (), pathlib.Path(folder))}
                for name, file in MODELS.items()}


def table(scenes):
    lines = ["| scene | seen | positions | mean hours | counted wrong, % | beyond 1 px, % | whole run, s |",
             "|" + " --- |" * 7]
    for name, views in scenes.items():
        for view, of in views.items():
            wrong = figure(percent(of["wrong_mask_pixels"], of["visible_pixels"]))
            beyond = figure(percent(of["wrong_mask_beyond_1px"], of["visible_pixels"]))
            lines.append(f"| {name} | {view} | {of['positions']} | {of['mean_hours']:.2f} | {wrong} | {beyond} "
                         f"| {of['seconds']:.1f} |")
    return "\n".join(lines)


if __name__ == "__main__":
    results = results_of("sun_hours", measured)
    told = (f"{results['machine']['cores']} cores of {results['machine']['processor']}, "
            f"{results['machine']['date']}, software renderer, {SIZE}, {PLACE}, {DAY}, a position every "
            f"{STEP} minutes.")
    replace_between("docs/measured/sun-hours.md", "counts", told + "\n\n" + table(results["scenes"]))
