#!/usr/bin/env python3
"""File size and load time of each encoding, on every model in ../shared/scenes: a table of
docs/measured/encodings.md.

    tests/bench/encodings.py           measures, then the table
    tests/bench/encodings.py --table   the table from the stored results

EDGESHADE names the program.
"""

import pathlib
import resource
import tempfile

from accuracy import NAMES
from edgeshade_runs import SCENES, mean, replace_between, report, results_of

ENCODINGS = ("expanded", "indexed", "none")
REPEATS = 3


def call_seconds(path, layout):
    """Least processor time, over several calls, of a call that reads, flattens, finds shadow data,
    uploads, and draws almost nothing."""
    def one():
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        report("render", path, path.with_suffix(".png"), "--size", "8x8", "--layout", layout)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return min(one() for _ in range(REPEATS))


def measured(scene, folder):
    results = {}
    for encoding in ENCODINGS:
        path = pathlib.Path(folder) / f"{scene}.{encoding}.glb"
        packed = report("pack", SCENES / f"{scene}.glb", path, "--encoding", encoding)
        results[encoding] = {
            "bytes": {key: packed["bytes"][key] for key in ("stored", "file", "published_equation")},
            "load_seconds": {layout: call_seconds(path, layout)
                             for layout in ("adapted", "published")}}
        path.unlink()
    return results


def table(results):
    lines = ["| scene | encoding | shadow data, bytes | share of the published sum | file, bytes | load, "
             "plane-pair records, s | load, published records, s |",
             "|" + " --- |" * 7]
    shares = {encoding: [] for encoding in ENCODINGS}
    loads = {encoding: [] for encoding in ENCODINGS}
    for scene, of in results["scenes"].items():
        for encoding in ENCODINGS:
            sizes, load = of[encoding]["bytes"], of[encoding]["load_seconds"]
            share = sizes["stored"] / sizes["published_equation"]
            shares[encoding].append(share)
            loads[encoding].append((load["adapted"], load["published"]))
            lines.append(f"| {NAMES[scene]} | `{encoding}` | {sizes['stored']:,} | {share:.3f} | "
                         f"{sizes['file']:,} | {load['adapted']:.2f} | {load['published']:.2f} |")
    for encoding in ENCODINGS:
        adapted, published = (mean(column) for column in zip(*loads[encoding]))
        lines.append(f"| geometric mean, largest share | `{encoding}` | | "
                     f"at most {max(shares[encoding]):.3f} | | {adapted:.2f} | {published:.2f} |")
    of = results["machine"]
    return (f"{of['cores']} cores of {of['processor']}, {of['date']}, software renderer. Times are processor "
            f"time on all cores to load and to draw one picture of 8x8, the least of {REPEATS}.\n\n" + "\n".join(lines))


def measured_all():
    with tempfile.TemporaryDirectory() as folder:
        return {scene: measured(scene, folder) for scene in NAMES}


def main():
    results = results_of("encodings", measured_all)
    replace_between("docs/measured/encodings.md", "encodings", table(results))


if __name__ == "__main__":
    main()
