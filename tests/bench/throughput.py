#!/usr/bin/env python3
"""How quickly casters become records, on every model in ../shared/scenes: a table of
docs/measured/encodings.md.

    tests/bench/throughput.py           measures, then the table
    tests/bench/throughput.py --table   the table from the results that are there

THROUGHPUT names the program preprocess_throughput, built with the tests.
"""

from accuracy import NAMES
from edgeshade_runs import mean, replace_between, results_of, told_of_models

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


def main():
    results = results_of("throughput", lambda: told_of_models(
        "release/tests/bench/preprocess_throughput", "THROUGHPUT", NAMES))
    replace_between("docs/measured/encodings.md", "throughput", table(results))


if __name__ == "__main__":
    main()
