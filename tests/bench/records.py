#!/usr/bin/env python3
"""What the adapted records leave of the published ones, on every model in ../shared/scenes: the
tables of docs/adapted.md.

    tests/bench/records.py           measures, then the tables
    tests/bench/records.py --table   the tables from the results that are there

EDGESHADE names the program.
"""

import json
import math
import sys

from accuracy import NAMES
from edgeshade_runs import RESULTS, SCENES, machine, replace_between, report, write_results

KEPT = ("triangles", "edges", "flat_edges_dropped", "records", "closed_oriented_triangles",
        "largest_opposite_count", "bytes", "vertex_runs", "seconds")


def measured(scene):
    path = SCENES / f"{scene}.glb"
    whole = report("info", path)
    frames = report("bench", path, "--size", FRAME_SIZE, "--frames", FRAMES, "--timing", "processor",
                    "--against", "layout=published")
    adapted, published = frames["results"]
    return {key: whole[key] for key in KEPT} | {
        "device": adapted["device"]["renderer"],
        "adapted": {key: adapted[key] for key in FRAME_KEPT},
        "published": {key: published[key] for key in FRAME_KEPT},
        "ratio": frames["ratios"][0]}
FRAME_KEPT = ("frame_ms", "stage_ms", "vertex_runs", "bytes_gpu")
FRAME_SIZE, FRAMES = "960x540", 8


def mean(values):
    """Geometric."""
    return math.exp(sum(map(math.log, values)) / len(values))


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


def frame_table(results):
    """Published over adapted: above 1 adapted records are better."""
    lines = ["| scene | vertex runs | bytes on the GPU | silhouette stage | rasterise | whole frame |",
             "|" + " --- |" * 6]
    ratios = []
    for scene, of in results["scenes"].items():
        ours, theirs = of["adapted"], of["published"]
        row = (theirs["vertex_runs"] / ours["vertex_runs"], theirs["bytes_gpu"] / ours["bytes_gpu"],
               theirs["stage_ms"]["silhouette"] / ours["stage_ms"]["silhouette"],
               theirs["stage_ms"]["rasterise"] / ours["stage_ms"]["rasterise"],
               1 / of["ratio"]["median"])
        ratios.append(row)
        lines.append(f"| {NAMES[scene]} | " + " | ".join(f"{value:.2f}" for value in row) + " |")
    means = [mean(column) for column in zip(*ratios)]
    lines.append("| geometric mean | " + " | ".join(f"{value:.2f}" for value in means) + " |")
    machine_ = results["machine"]
    device = next(iter(results["scenes"].values()))["device"]
    return (f"{FRAME_SIZE}, {FRAMES} frames of a flight, {device}, {machine_['cores']} cores of "
            f"{machine_['processor']}, {machine_['date']}; processor time on all cores.\n\n"
            + "\n".join(lines))


def main(words):
    stored = RESULTS / "records.json"
    if words[:1] == ["--table"]:
        results = json.loads(stored.read_text())
    else:
        results = {"machine": machine(), "scenes": {scene: measured(scene) for scene in NAMES}}
        write_results("records", results)
    replace_between("docs/adapted.md", "records", table(results))
    replace_between("docs/adapted.md", "frames", frame_table(results))


if __name__ == "__main__":
    main(sys.argv[1:])
