#!/usr/bin/env python3
"""Volumes, published records and shadow maps on a GPU, on every model in ../shared/scenes: frame
times, wrong pixels, cost of filling.

    tests/bench/gpu.py frames [NAME...]    flies through those scenes, or all
    tests/bench/gpu.py compare [NAME...]   compares them with the oracle
    tests/bench/gpu.py table               docs/measured/gpu.md from the stored results

Other results are kept. Frames take two minutes on a GPU, comparing four on 16 cores.

EDGESHADE names the program.
"""

import fcntl
import json
import sys

from accuracy import MAP_SIZES, NAMES, condensed
from edgeshade_runs import (RESULTS, SCENES, against, figure, machine, mean, percent, replace_between,
                            report, write_results)

SIZE, LARGE = "1920x1080", "3840x2160"
FRAMES, VIEWS = 24, 16
SUN = ("--sun", "0.4,1,0.3")

MAPS = {f"map {size}": f"shadows=map,map-size={size}" for size in MAP_SIZES}
RECORDS = {"published": "layout=published", "all": "silhouette=all"}
LOOKED_UP = {"primitive map": "shadows=primitive-map"}

# The methods compared in each flight, and further settings.
FLIGHTS = {
    "resting": (RECORDS | MAPS | LOOKED_UP, ()),
    "moving": (RECORDS | MAPS, ("--light-moves",)),
    "sun": (RECORDS | MAPS | LOOKED_UP, SUN),
    "moving sun": ({"published": RECORDS["published"]} | MAPS, (*SUN, "--light-moves")),
}


def condensed_run(run):
    kept = ("frame_ms", "stage_ms", "plan_ms", "vertex_runs", "fill", "bytes_gpu", "repeated")
    return {key: run[key] for key in kept}


def flown(path, others, words, size=SIZE, timing=None):
    asked = ("--timing", timing) if timing else ()
    told = report("bench", path, "--size", size, "--frames", FRAMES, "--shadows", "volumes",
                  *asked, *words, *against(others.values()))
    runs = told.get("results", [told])
    ways = ("ours", *others)
    return {"device": {key: runs[0]["device"][key] for key in ("vendor", "renderer", "version")},
            "timing": runs[0]["timing"],
            "runs": {way: condensed_run(run) for way, run in zip(ways, runs)},
            "ratios": {way: ratio["median"]
                       for way, ratio in zip(ways[1:], told.get("ratios", []))}}


def flights(scene):
    path = SCENES / f"{scene}.glb"
    of = {light: flown(path, *flight) for light, flight in FLIGHTS.items()}
    of["large"] = flown(path, {}, ("--light-moves",), LARGE)
    of["processor"] = flown(path, {"published": RECORDS["published"]}, ("--light-moves",),
                            timing="processor")
    return of


def compared(scene):
    return condensed(report("compare", SCENES / f"{scene}.glb", "--size", "960x540", "--views",
                            VIEWS, *against((RECORDS | MAPS | LOOKED_UP).values())))


def ratio_table(results, light, ways):
    """Frame times of other methods over those of this program: above 1 this program is faster."""
    lines = ["| scene | ours, ms | " + " | ".join(ways) + " |", "|" + " --- |" * (2 + len(ways))]
    columns = [[] for _ in ways]
    for scene, of in results.items():
        flight = of[light]
        row = [1 / flight["ratios"][way] for way in ways]
        for column, value in zip(columns, row):
            column.append(value)
        lines.append(f"| {NAMES[scene]} | {flight['runs']['ours']['frame_ms']['median']:.2f} | "
                     + " | ".join(f"{value:.2f}" for value in row) + " |")
    lines.append("| geometric mean | | " + " | ".join(f"**{mean(column):.2f}**"
                                                      for column in columns) + " |")
    return "\n".join(lines)


def stage_table(results):
    lines = ["| scene | frame, ms | ambient | silhouette | rasterise | lit | published records: the "
             "same | planning, ms | processor, ms: ours | published |", "|" + " --- |" * 10]
    for scene, of in results.items():
        cells = []
        for way in ("ours", "published"):
            run = of["moving"]["runs"][way]
            stages = run["stage_ms"]
            cells.append([run["frame_ms"]["median"]] + [
                stages[stage] for stage in ("ambient", "silhouette", "rasterise", "lit")])
        work = [of["processor"]["runs"][way]["frame_ms"]["median"] for way in ("ours", "published")]
        lines.append(f"| {NAMES[scene]} | " + " | ".join(f"{value:.2f}" for value in cells[0])
                     + " | " + ", ".join(f"{value:.2f}" for value in cells[1])
                     + f" | {of['moving']['runs']['ours']['plan_ms']:.2f} | "
                     + " | ".join(f"{value:.2f}" for value in work) + " |")
    return "\n".join(lines)


def fill_table(results):
    lines = ["| scene | " + " | ".join(
        f"{size}: sides and caps drawn | fragments, M | rasterise, ms | ns a triangle | ps a fragment"
        for size in (SIZE, LARGE)) + " |", "|" + " --- |" * 11]
    for scene, of in results.items():
        cells = []
        for flight in ("moving", "large"):
            run = of[flight]["runs"]["ours"]
            fill, ms = run["fill"], run["stage_ms"]["rasterise"]
            cells += [f"{fill['triangles']:,}", f"{fill['fragments'] / 1e6:.1f}", f"{ms:.3f}",
                      f"{1e6 * ms / max(fill['triangles'], 1):.2f}",
                      f"{1e9 * ms / max(fill['fragments'], 1):.1f}"]
        lines.append(f"| {NAMES[scene]} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def accuracy_table(results):
    names = ["volumes", *RECORDS, *MAPS, *LOOKED_UP]
    lines = ["| scene | visible pixels | " + " | ".join(names) + " | beyond 1 px, not tied: volumes "
             "| primitive map |", "|" + " --- |" * (4 + len(names))]
    for scene, of in results.items():
        runs = of["compare"]
        cells = [figure(percent(run["wrong_image_pixels"], run["visible_pixels"])) for run in runs]
        beyond = [runs[i]["wrong_image_beyond_1px_not_tied"] for i in (0, -1)]
        lines.append(f"| {NAMES[scene]} | {runs[0]['visible_pixels']:,} | " + " | ".join(cells)
                     + f" | {beyond[0]} | {beyond[1]} |")
    return "\n".join(lines)


def conditions(machine_, results):
    flight = next(iter(results.values()))["resting"]
    clock = {"query": "the GPU's clock", "finish": "waiting for the GPU"}[flight["timing"]]
    return (f"{flight['device']['renderer']}, {flight['device']['version']}; {machine_['cores']} cores "
            f"of {machine_['processor']}, {machine_['date']}. {SIZE}, {FRAMES} frames of bench's "
            f"flight, base shading, all surfaces from both sides; {clock}.")


def take(what, scenes):
    """Measures `what` for the scenes, one after another, and stores it."""
    measure = {"frames": flights, "compare": compared}[what]
    for scene in scenes or NAMES:
        measured = measure(scene)
        with open(__file__) as file:
            fcntl.flock(file, fcntl.LOCK_EX)  # several scenes may be compared in parallel
            results = stored()
            results["machine"] = machine()
            results["scenes"].setdefault(scene, {})[what] = measured
            write_results("gpu", results)


def stored():
    path = RESULTS / "gpu.json"
    return json.loads(path.read_text()) if path.exists() else {"scenes": {}}


def main(words):
    what = words[0] if words else "--help"
    if what not in ("frames", "compare", "table"):
        raise SystemExit(__doc__)
    if what != "table":
        return take(what, words[1:])
    results = stored()
    page, scenes = "docs/measured/gpu.md", {name: results["scenes"][name] for name in NAMES}
    frames = {name: of["frames"] for name, of in scenes.items()}
    replace_between(page, "conditions", conditions(results["machine"], frames))
    for light in ("resting", "sun", "moving", "moving sun"):
        replace_between(page, light.replace(" ", "-"),
                        ratio_table(frames, light, list(FLIGHTS[light][0])))
    replace_between(page, "stages", stage_table(frames))
    replace_between(page, "fill", fill_table(frames))
    replace_between(page, "accuracy", accuracy_table(scenes))


if __name__ == "__main__":
    main(sys.argv[1:])
