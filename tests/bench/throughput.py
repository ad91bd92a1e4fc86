#!/usr/bin/env python3
"""Speed of turning casters into records, on every model in ../shared/scenes and on generated meshes
of 1, 5 and 10 million triangles: tables of docs/measured/encodings.md.

    tests/bench/throughput.py           measures, then the table
    tests/bench/throughput.py --table   the table from the stored results

THROUGHPUT names the program preprocess_throughput, built by the target `measurements`.
"""

import json

from accuracy import NAMES
from edgeshade_runs import RESULTS, mean, replace_between, results_of, told_of, told_of_models

KINDS = {"grid": "hills", "boxes": "boxes", "tangle": "random"}
SIZES = (1_000_000, 5_000_000, 10_000_000)


def table(results):
    lines = ["| scene | triangles | weld, ms | edges, ms | plane-pair records, ms | million triangles / s "
             "| meshoptimizer: weld, ms | adjacency, ms | million triangles / s | with published "
             "records, ms |",
             "|" + " --- |" * 10]
    rates = []
    for of in results["scenes"]:
        ours, theirs = of["seconds"], of["meshoptimizer_seconds"]
        whole = ours["weld"] + ours["edges"] + ours["adapted"]
        published = ours["weld"] + ours["edges"] + ours["published"]
        rate = [1e-6 * of["triangles"] / seconds for seconds in (whole, sum(theirs.values()))]
        rates.append([*rate, whole / published])
        lines.append(f"| {NAMES[of['scene']]} | {of['triangles']:,} | "
                     + " | ".join(f"{1e3 * ours[key]:.1f}" for key in ("weld", "edges", "adapted"))
                     + f" | {rate[0]:.2f} | {1e3 * theirs['weld']:.1f} | "
                     f"{1e3 * theirs['adjacency']:.1f} | {rate[1]:.2f} | {1e3 * published:.1f} |")
    means = [mean(column) for column in zip(*rates)]
    lines.append(f"| geometric mean | | | | | {means[0]:.2f} | | | {means[1]:.2f} | "
                 f"1 / {means[2]:.2f} of all |")
    of = results["machine"]
    return (f"Processor time of one thread, {of['processor']}, {of['date']}, the quickest of five runs.\n\n"
            + "\n".join(lines))


def large_table(results):
    """The table for generated meshes. A separate file keeps results of earlier code."""
    lines = ["| mesh | triangles | weld, ms | edges, ms | plane-pair records, ms | million triangles "
             "/ s | before | on all threads | meshoptimizer: weld and adjacency |",
             "|" + " --- |" * 9]
    kept = RESULTS / "throughput_before.json"
    before = {(of["scene"], of["triangles"]): of["seconds"]
              for of in (json.loads(kept.read_text())["scenes"] if kept.exists() else [])}
    for of in results["scenes"]:
        def rate(seconds):
            return f"{1e-6 * of['triangles'] / seconds:.2f}"
        stages = [of["seconds"][key] for key in ("weld", "edges", "adapted")]
        old = before.get((of["scene"], of["triangles"]))
        kind = of["scene"].split(":")[0]
        lines.append(f"| {KINDS[kind]} | {of['triangles']:,} | "
                     + " | ".join(f"{1e3 * one:.0f}" for one in stages)
                     + f" | {rate(sum(stages))} | "
                     + (rate(sum(old[key] for key in ("weld", "edges", "adapted"))) if old else "")
                     + f" | {rate(of['seconds_on_all_threads'])} | "
                     f"{rate(sum(of['meshoptimizer_seconds'].values()))} |")
    of = results["machine"]
    return (f"Processor time of one thread; on all threads the wall clock's; {of['processor']}, "
            f"{of['cores']} cores, {of['date']}. *Before* is the speed of the code that sorted by comparing, "
            "in processor time of one thread, measured once.\n\n" + "\n".join(lines))


def main():
    program = ("release/tests/bench/preprocess_throughput", "THROUGHPUT")
    results = results_of("throughput", lambda: told_of_models(*program, NAMES))
    replace_between("docs/measured/encodings.md", "throughput", table(results))
    large = results_of("throughput_large", lambda: told_of(
        *program, [f"{kind}:{size}" for size in SIZES for kind in KINDS]))
    replace_between("docs/measured/encodings.md", "large throughput", large_table(large))


if __name__ == "__main__":
    main()
