#!/usr/bin/env python3
"""Casters wholly in the shadow of others, of lights that rest or may be anywhere around, on every
model in ../shared/scenes: a table of docs/measured/fill.md.

    tests/bench/culling_times.py           measures, then the table
    tests/bench/culling_times.py --table   the table from the results that are there

CULLING_TIMES names the program, build/release/tests/bench/culling_times.
"""

from accuracy import NAMES
from edgeshade_runs import percent, replace_between, results_of, told_of_models


def table(scenes):
    lights = list(scenes[0]["lights"])
    lines = ["| scene | casters | " + " | ".join(lights) + " |", "|" + " --- |" * (2 + len(lights))]
    for of in scenes:
        cells = ["; ".join(f"{percent(found['gone'], of['casters']):.1f}, {found['ms']:.0f}"
                           for found in of["lights"][light]) for light in lights]
        lines.append(f"| {NAMES[of['scene']]} | {of['casters']:,} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def main():
    results = results_of("culling_times", lambda: told_of_models(
        "release/tests/bench/culling_times", "CULLING_TIMES", NAMES))
    of = results["machine"]
    reaches = [found["reach"] for found in results["scenes"][0]["lights"]["sun"]]
    replace_between("docs/measured/fill.md", "casters",
                    f"{of['cores']} cores of {of['processor']}, {of['date']}. Percent of casters left out "
                    "and milliseconds that it takes, for lights anywhere within "
                    f"{', '.join(f'{reach:g}' for reach in reaches)} degrees, or 150ths of the scene's "
                    "diagonal of a lamp.\n\n" + table(results["scenes"]))


if __name__ == "__main__":
    main()
