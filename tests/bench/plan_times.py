#!/usr/bin/env python3
"""Processor time for a frame before anything is drawn, on every model in ../shared/scenes: a
table of docs/measured/gpu.md.

    tests/bench/plan_times.py           measures, then the table
    tests/bench/plan_times.py --table   the table from the stored results

PLAN_TIMES names the program, build/release/tests/bench/plan_times.
"""

from accuracy import NAMES
from edgeshade_runs import mean, replace_between, results_of, told_of_models


def table(scenes):
    lights = list(scenes[0]["layers"])
    lines = ["| scene | triangles | visible geometry | " + " | ".join(
        f"layers: {light}" for light in lights) + " |", "|" + " --- |" * (3 + len(lights))]
    rows = []
    for of in scenes:
        parts = [of["view"]] + [of["layers"][light] for light in lights]
        rows.append([part[key] for part in parts for key in ("ms", "processor_ms")])
        lines.append(f"| {NAMES[of['scene']]} | {of['triangles']:,} | " + pairs(rows[-1]) + " |")
    means = [mean(column) for column in zip(*rows)]
    return "\n".join(lines + ["| geometric mean | | " + pairs(means) + " |"])


def pairs(values):
    """Elapsed time, and the time of all cores."""
    return " | ".join(f"{wall:.1f}, {work:.1f}" for wall, work in zip(values[::2], values[1::2]))


def main():
    results = results_of("plan_times", lambda: told_of_models("release/tests/bench/plan_times",
                                                              "PLAN_TIMES", NAMES))
    of = results["machine"]
    replace_between("docs/measured/gpu.md", "planning",
                    f"{of['cores']} cores of {of['processor']}, {of['date']}; milliseconds of the "
                    "wall clock, then of both cores together.\n\n"
                    + table(results["scenes"]))


if __name__ == "__main__":
    main()
