#!/usr/bin/env python3
"""Cost of keeping a mesh once for all its places, against repeating it, for generated forests: the
tables of docs/measured/instances.md.

    tests/bench/instances.py           measures, then the tables
    tests/bench/instances.py --table   the tables from the stored results
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import time

from edgeshade_runs import PROGRAM, ROOT, figure, replace_between, report, results_of
from forest import write_forest

COUNTS = (10, 100, 1_000, 10_000)
TREES = {36: (3, 2), 96: (6, 3), 240: (12, 4), 336: (12, 6), 1040: (20, 12)}
CHOICES = ("shared", "repeated")
VIEW = ("--size", "960x540", "--shadows", "volumes", "--sun", "1,2,1")


def run(*words):
    """Seconds and peak memory, in MB, of one call."""
    start = time.perf_counter()
    child = subprocess.Popen([PROGRAM, *map(str, words)], stdout=subprocess.DEVNULL,
                             stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        raise RuntimeError(f"{words} failed")
    return {"seconds": time.perf_counter() - start, "megabytes": usage.ru_maxrss / 1024}


def frames(path, frame_count):
    """Frame times of both choices, measured alternately in one process."""
    told = report("bench", path, *VIEW, "--frames", frame_count, "--instances", "shared",
                  "--against", "instances=repeated")
    shared, repeated = told["results"]
    return {"shared": {"frame_ms": shared["frame_ms"]["median"], "bytes": shared["bytes_gpu"]},
            "repeated": {"frame_ms": repeated["frame_ms"]["median"],
                         "bytes": repeated["bytes_gpu"]},
            "ratio": told["ratios"][0]["median"]}


def measured():
    by_count, by_size = {}, {}
    with tempfile.TemporaryDirectory() as folder:
        path, out = pathlib.Path(folder) / "forest.glb", pathlib.Path(folder) / "out"
        for count in COUNTS:
            print(count, file=sys.stderr)
            write_forest(path, count)
            row = frames(path, 8)
            for choice in CHOICES:
                wanted = ("--instances", choice)
                row[choice]["pack"] = run("pack", path, f"{out}.glb", *wanted)
                row[choice]["file"] = pathlib.Path(f"{out}.glb").stat().st_size
                row[choice]["first"] = run("render", path, f"{out}.png", *VIEW, *wanted)
            row["source"] = path.stat().st_size
            if count <= 1_000:
                row["compare"] = {light: report("compare", path, "--size", "320x240", *words)
                                  for light, words in (("sun", ("--sun", "1,2,1")),
                                                       ("lamp", ("--light", "3,10,4")))}
                for told in row["compare"].values():
                    told.pop("by_view", None)
            by_count[str(count)] = row
        for triangles, (sides, crowns) in TREES.items():
            print(triangles, file=sys.stderr)
            assert write_forest(path, 1_000, sides, crowns) == triangles
            by_size[str(triangles)] = frames(path, 12)
    return {"by_count": by_count, "by_size": by_size}


def mb(count):
    return figure(count / 1e6)


def costs(results):
    lines = ["| trees | mesh is | pack, s | packed file, MB | first picture, s | most memory, MB | "
             "records on the GPU, MB | frame, ms |", "|" + " --- |" * 8]
    for count, row in results["by_count"].items():
        for choice in CHOICES:
            of = row[choice]
            lines.append(f"| {int(count):,} | {choice} | {figure(of['pack']['seconds'])} | "
                         f"{mb(of['file'])} | {figure(of['first']['seconds'])} | "
                         f"{of['first']['megabytes']:.0f} | {mb(of['bytes'])} | "
                         f"{figure(of['frame_ms'])} |")
    return "\n".join(lines)


def sizes(results):
    lines = ["| triangles a tree | shared, ms | repeated, ms | shared / repeated |",
             "|" + " --- |" * 4]
    for triangles, row in results["by_size"].items():
        lines.append(f"| {int(triangles):,} | {figure(row['shared']['frame_ms'])} | "
                     f"{figure(row['repeated']['frame_ms'])} | {row['ratio']:.2f} |")
    return "\n".join(lines)


def errors(results):
    lines = ["| trees | light | wrong mask, % | wrong image, % | beyond 1 px | not tied |",
             "|" + " --- |" * 6]
    for count, row in results["by_count"].items():
        for light, told in row.get("compare", {}).items():
            share = 100 / told["pixels"]
            lines.append(f"| {int(count):,} | {light} | "
                         f"{told['wrong_mask_pixels'] * share:.5f} | "
                         f"{told['wrong_image_pixels'] * share:.5f} | "
                         f"{told['wrong_image_beyond_1px']} | "
                         f"{told['wrong_image_beyond_1px_not_tied']} |")
    return "\n".join(lines)


def main():
    results = results_of("instances", measured)["scenes"]
    page = ROOT / "docs" / "measured" / "instances.md"
    for name, table in (("costs", costs), ("sizes", sizes), ("errors", errors)):
        replace_between(page, name, table(results))


if __name__ == "__main__":
    main()
