#!/usr/bin/env python3
"""What proposing silhouettes takes, on every model in ../shared/scenes: a table of docs/adapted.md.

    tests/bench/proposals.py           measures, then the table
    tests/bench/proposals.py --table   the table from the results that are there

PROPOSALS names the program proposal_times, built with the tests.
"""

from accuracy import NAMES
from edgeshade_runs import replace_between, results_of, told_of_models

def table(results):
    radii = [ball["radius"] for ball in results["scenes"][0]["balls"]]
    heads = ["at rest: ms", "listed, %"] + [
        f"radius {100 * radius:g} %: ms, listed, %" for radius in radii[1:]]
    lines = ["| scene | triangles | records of two | " + " | ".join(heads) + " |",
             "|" + " --- |" * (3 + len(heads))]
    for of in results["scenes"]:
        cells = []
        for index, ball in enumerate(of["balls"]):
            listed = f"{100 * ball['pairs'] / of['pairs']:.1f}"
            cells += [f"{ball['ms']:.2f}", listed] if index == 0 else [f"{ball['ms']:.2f}, {listed}"]
        lines.append(f"| {NAMES[of['scene']]} | {of['triangles']:,} | {of['pairs']:,} | "
                     + " | ".join(cells) + " |")
    of = results["machine"]
    return (f"Processor time of one thread, {of['processor']}, {of['date']}, the quickest of 20 runs; "
            "radii as shares of the scene's diagonal.\n\n" + "\n".join(lines))


def main():
    results = results_of("proposals", lambda: told_of_models("proposal_times", "PROPOSALS", NAMES))
    replace_between("docs/adapted.md", "proposals", table(results))


if __name__ == "__main__":
    main()
