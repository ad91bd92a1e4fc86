#!/usr/bin/env python3
"""city.py EDGESHADE MAKE_CITY: measures growth and memory of `edgeshade city` on generated cities of 1 to 268
square kilometres, and writes the table in docs/measured/city.md. --table rewrites it from stored results.
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
RESULTS = ROOT / "tests/bench/results/city.json"
PAGE = ROOT / "docs/measured/city.md"
BEGIN, END = "<!-- growth: begin -->", "<!-- growth: end -->"
SIDES = {"gltf": (2, 4, 8, 16, 32), "cityjson": (2, 4, 8)}  # tiles of 512 m
GRID = 2.0


def run(*words):
    """Runs a program; returns its processor seconds and its peak memory in MiB."""
    process = subprocess.Popen([str(word) for word in words], stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{words} ended with status {process.returncode}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def measure(edgeshade, make_city, folder, tiles, kind):
    city = folder / f"{kind}-{tiles}"
    triangles = int(subprocess.run([make_city, city, kind, "1", str(tiles), "16", "20", "8"], check=True,
                                   capture_output=True, text=True).stdout)
    plan = folder / f"{kind}-{tiles}.json"
    planning, plan_memory = run(edgeshade, "city", "plan", city, "--place", "48.14,11.57", "--date", "2026-03-20",
                                "--step", "60", "--min-altitude", "10", "--grid", GRID, "--tiles",
                                max(1, tiles * tiles // 4), "-o", plan)
    jobs = json.loads(plan.read_text())["jobs"]
    times, excess, peak = [], [], 0.0
    for number, job in enumerate(jobs, 1):
        seconds, memory = run(edgeshade, "city", "run", plan, "--job", number)
        times.append(seconds)
        excess.append(memory / (job["memory"] / 2**20))
        peak = max(peak, memory)
    merging, merge_memory = run(edgeshade, "city", "merge", plan, "-o", folder / "map")
    cells = sum((j["cells"][2] - j["cells"][0]) * (j["cells"][3] - j["cells"][1]) for j in jobs)
    return {"format": kind, "square_kilometres": round((tiles * 0.512) ** 2, 2), "triangles": triangles,
            "cells": cells, "jobs": len(jobs), "plan_seconds": planning, "plan_mib": plan_memory,
            "job_seconds": sum(times), "microseconds_per_cell": 1e6 * sum(times) / cells, "job_mib": peak,
            "largest_share_of_bound": max(excess), "merge_seconds": merging, "merge_mib": merge_memory}


def write_table(rows):
    lines = [BEGIN, "",
             "| format | km² | triangles | cells | jobs | µs a cell | plan, s | merge, s | job, MiB | of its bound | merge, MiB |",
             "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"]
    for r in rows:
        lines.append(f"| {r['format']} | {r['square_kilometres']} | {r['triangles']:,} | {r['cells']:,} | {r['jobs']} | "
                     f"{r['microseconds_per_cell']:.2f} | {r['plan_seconds']:.1f} | {r['merge_seconds']:.1f} | "
                     f"{r['job_mib']:.0f} | {100 * r['largest_share_of_bound']:.0f} % | {r['merge_mib']:.0f} |")
    lines += ["", END]
    text = PAGE.read_text()
    PAGE.write_text(text[:text.index(BEGIN)] + "\n".join(lines) + text[text.index(END) + len(END):])


def main():
    if "--table" not in sys.argv:
        edgeshade, make_city = sys.argv[1:3]
        rows = []
        with tempfile.TemporaryDirectory() as folder:
            for kind, sides in SIDES.items():
                for tiles in sides:
                    rows.append(measure(edgeshade, make_city, pathlib.Path(folder), tiles, kind))
                    print(rows[-1], flush=True)
                    RESULTS.write_text(json.dumps(rows, indent=1) + "\n")
    write_table(json.loads(RESULTS.read_text()))


if __name__ == "__main__":
    main()
