#!/usr/bin/env python3
"""Plane-pair records, all or only proposed ones, against published records and cube maps, on every
model in ../shared/scenes: the tables of docs/measured/records.md.

    tests/bench/records.py           measures, then the tables
    tests/bench/records.py --moving  measures only moving lights; keeps the other results
    tests/bench/records.py --table   the tables from the stored results

EDGESHADE names the program.
"""

import json
import sys

from accuracy import NAMES
from edgeshade_runs import (RESULTS, SCENES, against, machine, mean, replace_between, report,
                            results_of, write_results)

KEPT = ("triangles", "edges", "flat_edges_dropped", "records", "closed_oriented_triangles",
        "largest_opposite_count", "bytes", "vertex_runs", "seconds")
FRAME_KEPT = ("frame_ms", "stage_ms", "vertex_runs", "bytes_gpu")
FRAME_SIZE, FRAMES = "960x540", 8
MAP_SIZES = (1024, 2048, 4096, 8192)

# Settings to compare with proposed records, as arguments of bench.
AGAINST = {"all": "silhouette=all", "published": "layout=published"} | {
    f"map {size}": f"shadows=map,map-size={size}" for size in MAP_SIZES}
# With a moving light, the program's own choice is measured too.
AGAINST_MOVING = AGAINST | {"auto": "shadows=auto"}


def frames_of(path, others, *more):
    """Frame times with proposed records and with all other settings, in one run."""
    told = report("bench", path, "--size", FRAME_SIZE, "--frames", FRAMES, "--timing", "processor",
                  *against(others.values()), *more)
    frames = {way: {key: result[key] for key in FRAME_KEPT}
              for way, result in zip(("proposed", *others), told["results"])}
    return frames | {"device": told["results"][0]["device"]["renderer"],
                     "methods": [result["lights"][0]["method"] for result in told["results"]],
                     "ratios": dict(zip(others, told["ratios"]))}


def moving(path):
    return frames_of(path, AGAINST_MOVING, "--light-moves")


def measured(scene):
    path = SCENES / f"{scene}.glb"
    whole = report("info", path)
    return {key: whole[key] for key in KEPT} | {
        "resting": frames_of(path, AGAINST), "moving": moving(path)}


def measured_moving():
    """The stored results with moving lights measured again."""
    results = json.loads((RESULTS / "records.json").read_text())
    results["machine_moving"] = machine()
    for scene in NAMES:
        results["scenes"][scene]["moving"] = moving(SCENES / f"{scene}.glb")
        write_results("records", results)
    return results


def table(results):
    lines = ["| scene | edges | flat, dropped | closed triangles, % | runs of published / adapted "
             "sides | with all caps | sides' bytes / published sum | with all caps |",
             "|" + " --- |" * 8]
    ratios = []
    for scene, of in results["scenes"].items():
        runs, sizes = of["vertex_runs"], of["bytes"]
        published_sides = runs["published"] - runs["caps"]
        row = (published_sides / runs["sides"], runs["published"] / (runs["sides"] + runs["caps"]),
               sizes["sides"] / sizes["published_equation"],
               (sizes["sides"] + sizes["caps"]) / sizes["published_equation"])
        ratios.append(row)
        lines.append(f"| {NAMES[scene]} | {of['edges']:,} | {of['flat_edges_dropped']:,} | "
                     f"{100 * of['closed_oriented_triangles'] / of['triangles']:.0f} | "
                     f"{row[0]:.2f} | {row[1]:.2f} | {row[2]:.2f} | {row[3]:.2f} |")
    means = [mean(column) for column in zip(*ratios)]
    lines.append("| geometric mean | | | | " + " | ".join(f"{value:.2f}" for value in means) + " |")
    return "\n".join(lines)


def frame_table(results, light):
    """Times, vertex runs and bytes of opposite-vertex records over those of proposed plane-pair
    records; for whole frames also over all plane-pair records. Above 1 proposed records are
    better."""
    lines = ["| scene | vertex runs | bytes on the GPU | silhouette stage | rasterise | whole frame "
             "| whole frame, all plane-pair records |",
             "|" + " --- |" * 7]
    ratios = []
    for scene, of in results["scenes"].items():
        frames = of[light]
        ours, theirs = frames["proposed"], frames["published"]
        row = (theirs["vertex_runs"] / ours["vertex_runs"], theirs["bytes_gpu"] / ours["bytes_gpu"],
               theirs["stage_ms"]["silhouette"] / ours["stage_ms"]["silhouette"],
               theirs["stage_ms"]["rasterise"] / ours["stage_ms"]["rasterise"],
               1 / frames["ratios"]["published"]["median"], 1 / frames["ratios"]["all"]["median"])
        ratios.append(row)
        lines.append(f"| {NAMES[scene]} | " + " | ".join(f"{value:.2f}" for value in row) + " |")
    means = [mean(column) for column in zip(*ratios)]
    lines.append("| geometric mean | " + " | ".join(f"{value:.2f}" for value in means) + " |")
    return "\n".join(lines)


def map_table(results):
    """Frame times with cube maps over those with proposed records, for a resting light and a moving
    one."""
    lines = ["| scene | " + " | ".join(f"{size} x {size}" for size in MAP_SIZES) + " |",
             "|" + " --- |" * (1 + len(MAP_SIZES))]
    columns = [[] for _ in MAP_SIZES]
    for scene, of in results["scenes"].items():
        cells = []
        for column, size in zip(columns, MAP_SIZES):
            pair = [1 / of[light]["ratios"][f"map {size}"]["median"]
                    for light in ("resting", "moving")]
            column.append(pair)
            cells.append("{:.2f}, {:.2f}".format(*pair))
        lines.append(f"| {NAMES[scene]} | " + " | ".join(cells) + " |")
    means = [[mean(values) for values in zip(*column)] for column in columns]
    lines.append("| geometric mean | "
                 + " | ".join("{:.2f}, {:.2f}".format(*pair) for pair in means) + " |")
    return "\n".join(lines)


def stage_table(results):
    """The parts of a frame's time."""
    lines = ["| scene | frame, ms | ambient | silhouette | rasterise | lit | published records: the "
             "same |", "|" + " --- |" * 7]
    for scene, of in results["scenes"].items():
        cells = []
        for way in ("proposed", "published"):
            frame = of["resting"][way]
            stages = frame["stage_ms"]
            cells.append([frame["frame_ms"]["median"]] + [
                stages[stage] for stage in ("ambient", "silhouette", "rasterise", "lit")])
        lines.append(f"| {NAMES[scene]} | " + " | ".join(f"{value:.1f}" for value in cells[0])
                     + " | " + ", ".join(f"{value:.1f}" for value in cells[1]) + " |")
    return "\n".join(lines)


def auto_table(results):
    """Frame times of other methods with a moving light over those with volumes, and over those of
    --shadows auto."""
    ways = ("published", *(f"map {size}" for size in MAP_SIZES))
    lines = ["| scene | auto draws by | volumes / auto | " + " | ".join(
        f"{way}: / volumes, / auto" for way in ways) + " |", "|" + " --- |" * (3 + len(ways))]
    rows = []
    for scene, of in results["scenes"].items():
        ratios = {way: 1 / ratio["median"] for way, ratio in of["moving"]["ratios"].items()}
        row = [1 / ratios["auto"]] + [value for way in ways
                                      for value in (ratios[way], ratios[way] / ratios["auto"])]
        rows.append(row)
        lines.append(f"| {NAMES[scene]} | {of['moving']['methods'][-1]} | {row[0]:.2f} | "
                     + " | ".join(f"{a:.2f}, {b:.2f}" for a, b in zip(row[1::2], row[2::2])) + " |")
    means = [mean(column) for column in zip(*rows)]
    lines.append(f"| geometric mean | | **{means[0]:.2f}** | " + " | ".join(
        f"{a:.2f}, **{b:.2f}**" for a, b in zip(means[1::2], means[2::2])) + " |")
    return "\n".join(lines)


def conditions(results, light):
    machine_ = results.get("machine_moving" if light == "moving" else "machine", results["machine"])
    device = next(iter(results["scenes"].values()))[light]["device"]
    return (f"{FRAME_SIZE}, {FRAMES} frames of a flight, {device}, {machine_['cores']} cores of "
            f"{machine_['processor']}, {machine_['date']}; processor time on all cores.\n\n")


def main():
    if sys.argv[1:2] == ["--moving"]:
        results = measured_moving()
    else:
        results = results_of("records", lambda: {scene: measured(scene) for scene in NAMES})
    replace_between("docs/measured/records.md", "records", table(results))
    replace_between("docs/measured/records.md", "frames",
                    "The light at rest. " + conditions(results, "resting")
                    + frame_table(results, "resting")
                    + "\n\nA light that moves in every frame. " + conditions(results, "moving")
                    + frame_table(results, "moving"))
    replace_between("docs/measured/records.md", "auto", auto_table(results))
    replace_between("docs/measured/records.md", "maps", map_table(results))
    replace_between("docs/measured/records.md", "stages", stage_table(results))


if __name__ == "__main__":
    main()
