#!/usr/bin/env python3
"""Time to propose silhouettes, on every model in ../shared/scenes: docs/measured/proposals.md.

    tests/bench/proposals.py           measures, then the table
    tests/bench/proposals.py --table   the table from the stored results

PROPOSALS names the program proposal_times, built by the target `measurements`; PROPOSALS_WEB the same for node,
which `cmake --build --preset web --target proposal_times` builds.
"""

import sys

from accuracy import NAMES
from edgeshade_runs import replace_between, results_of, told_of_models


def measured():
    scenes = told_of_models("release/tests/bench/proposal_times", "PROPOSALS", NAMES)
    node = told_of_models("web-build/tests/platforms/proposal_times.cjs", "PROPOSALS_WEB", NAMES)
    for of, there in zip(scenes, node):
        lists = [[ball["pairs"] for ball in either["balls"]] for either in (of, there)]
        if lists[0] != lists[1]:
            sys.exit(f"{of['scene']}: WebAssembly lists other records, {lists}")
        of["webassembly_ms"] = [ball["ms"] for ball in there["balls"]]
    return scenes


def table(results):
    radii = [ball["radius"] for ball in results["scenes"][0]["balls"]]
    heads = ["at rest: ms", "WebAssembly: ms", "listed, %"] + [
        f"radius {100 * radius:g} %: ms, listed, %" for radius in radii[1:]]
    lines = ["| scene | triangles | records of two planes | " + " | ".join(heads) + " |",
             "|" + " --- |" * (3 + len(heads))]
    for of in results["scenes"]:
        cells = []
        for index, ball in enumerate(of["balls"]):
            listed = f"{100 * ball['pairs'] / of['pairs']:.1f}"
            time = f"{ball['ms']:.2f}"
            there = f"{of['webassembly_ms'][index]:.1f}"  # node's clock has a resolution of a millisecond
            cells += [f"{time}, {listed}"] if index else [time, there, listed]
        lines.append(f"| {NAMES[of['scene']]} | {of['triangles']:,} | {of['pairs']:,} | "
                     + " | ".join(cells) + " |")
    of = results["machine"]
    return (f"Processor time of one thread, {of['processor']}, {of['date']}, the quickest of 20 runs. "
            "Radii are shares of the scene's diagonal. WebAssembly runs in node, whose engine is "
            "Chromium's.\n\n" + "\n".join(lines))


def main():
    results = results_of("proposals", measured)
    replace_between("docs/measured/proposals.md", "proposals", table(results))


if __name__ == "__main__":
    main()
