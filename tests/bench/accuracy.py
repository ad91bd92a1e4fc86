#!/usr/bin/env python3
"""Volumes and shadow maps against the oracle, on every model in ../shared/scenes.

    tests/bench/accuracy.py                 compares all scenes (an hour on two cores), then writes the table
    tests/bench/accuracy.py --volumes       compares only volumes; keeps the results of maps
    tests/bench/accuracy.py --table         writes docs/measured/accuracy.md from the stored results
    tests/bench/accuracy.py --take FOLDER   takes reports of `compare` that were made manually
"""

import json
import pathlib
import sys

from edgeshade_runs import (RESULTS, SCENES, against, figure, machine, percent, replace_between, report,
                            write_results)

MAP_SIZES = (1024, 2048, 4096, 8192)
NAMES = {"bunny.draco": "bunny", "hospital-electrical": "hospital, electrical",
         "city.draco": "city", "car.draco": "car", "engine": "2-cylinder engine",
         "oaktree": "oak tree", "garden.draco": "garden", "temple": "temple",
         "truck.draco": "truck", "duck": "duck"}


PUBLISHED = ["layout=published"]
MAPS = [f"shadows=map,map-size={size}" for size in MAP_SIZES]


def compare(scene, settings):
    return report("compare", SCENES / f"{scene}.glb", "--views", 16, *against(settings))


def condensed(full):
    """A report without its single views, which are of little use to a reader."""
    return [{key: value for key, value in result.items() if key != "by_view"}
            for result in full.get("results", [full])]


def wrong(run):
    return figure(percent(run["wrong_image_pixels"], run["visible_pixels"]))


def table(results):
    head = ("| scene | visible pixels | volumes | beyond 1 px, not tied | opposite-vertex records | "
            + " | ".join(f"map {size}" for size in MAP_SIZES) + " |")
    lines = [head, "|" + " --- |" * (5 + len(MAP_SIZES))]
    for scene, runs in results["scenes"].items():
        volumes, published = runs[0], runs[1]
        maps = {run["settings"]["map-size"]: wrong(run) for run in runs[2:]}
        cells = [NAMES.get(scene, scene), f"{volumes['visible_pixels']:,}", wrong(volumes),
                 str(volumes["wrong_image_beyond_1px_not_tied"]), wrong(published)]
        lines.append("| " + " | ".join(cells + [maps.get(size, "") for size in MAP_SIZES]) + " |")
    return "\n".join(lines)


def main(words):
    stored = RESULTS / "accuracy.json"
    if words[:1] == ["--table"]:
        results = json.loads(stored.read_text())
    elif words[:1] == ["--volumes"]:
        results = json.loads(stored.read_text())
        for scene, runs in results["scenes"].items():
            made = condensed(compare(scene, PUBLISHED))
            results["scenes"][scene] = made + [run for run in runs if run["name"] in MAPS]
        write_results("accuracy", results)
    else:
        results = {"machine": machine(), "scenes": {}}
        for scene in NAMES:
            if words[:1] == ["--take"]:
                made = pathlib.Path(words[1]) / f"{scene}.json"
                if not made.exists():
                    continue
                full = json.loads(made.read_text())
            else:
                full = compare(scene, PUBLISHED + MAPS)
            results["scenes"][scene] = condensed(full)
        write_results("accuracy", results)
    replace_between("docs/measured/accuracy.md", "accuracy", table(results))


if __name__ == "__main__":
    main(sys.argv[1:])
