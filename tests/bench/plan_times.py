#!/usr/bin/env python3
"""Processor time for a frame before anything is drawn, on every model in ../shared/scenes: a
table of docs/measured/processor.md.

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
        rows.append(times([of["view"]] + [of["layers"][light] for light in lights]))
        lines.append(f"| {NAMES[of['scene']]} | {of['triangles']:,} | " + pairs(rows[-1]) + " |")
    lines.append("| geometric mean | | " + pairs(means(rows)) + " |")
    for name, key in (("a light's first search", "first"), ("by triangles", "by_triangles")):
        rows = [times(of[key][light] for light in lights) for of in scenes]
        lines.append(f"| geometric mean, {name} | | | " + pairs(means(rows)) + " |")
    return "\n".join(lines)


def times(parts):
    return [part[key] for part in parts for key in ("ms", "processor_ms")]


def means(rows):
    return [mean(column) for column in zip(*rows)]


def pairs(values):
    """Elapsed time, and the time of all cores."""
    return " | ".join(f"{wall:.1f}, {work:.1f}" for wall, work in zip(values[::2], values[1::2]))


def main():
    results = results_of("plan_times", lambda: told_of_models("release/tests/bench/plan_times",
                                                              "PLAN_TIMES", NAMES))
    of = results["machine"]
    replace_between("docs/measured/processor.md", "planning",
                    f"{of['cores']} cores of {of['processor']}, {of['date']}; milliseconds of the "
                    "wall clock, then of both cores together.\n\n"
                    + table(results["scenes"]))


if __name__ == "__main__":
    main()
