#!/usr/bin/env python3
"""What proposing silhouettes takes, on every model in ../shared/scenes: a table of docs/adapted.md.

    tests/bench/proposals.py           measures, then the table
    tests/bench/proposals.py --table   the table from the results that are there

PROPOSALS names the program proposal_times, built with the tests.
"""

import json
import os
import subprocess
import sys

from accuracy import NAMES
from edgeshade_runs import RESULTS, ROOT, SCENES, machine, replace_between, write_results

PROGRAM = os.environ.get("PROPOSALS", str(ROOT / "build/release/tests/bench/proposal_times"))


def measured():
    paths = [str(SCENES / f"{scene}.glb") for scene in NAMES]
    done = subprocess.run([PROGRAM, *paths], check=True, stdout=subprocess.PIPE)
    return {"machine": machine(), "scenes": json.loads(done.stdout)}


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


def main(words):
    stored = RESULTS / "proposals.json"
    results = json.loads(stored.read_text()) if words[:1] == ["--table"] else measured()
    if words[:1] != ["--table"]:
        write_results("proposals", results)
    replace_between("docs/adapted.md", "proposals", table(results))


if __name__ == "__main__":
    main(sys.argv[1:])
