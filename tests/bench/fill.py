#!/usr/bin/env python3
"""What filling shadow volumes takes, and what each measure saves of it, on every model in
../shared/scenes: the tables of docs/measured/fill.md.

    tests/bench/fill.py           measures, then the tables
    tests/bench/fill.py --table   the tables from the results that are there

FILL_COSTS names the program, build/release/tests/bench/fill_costs.
"""

from accuracy import NAMES
from edgeshade_runs import mean, replace_between, results_of, told_of_models

LIGHTS = ("sun", "low sun", "lamp")


def ends_table(results):
    """Costs with ends by cost, and the share that is left of those at planes and at infinity."""
    lines = ["| scene | " + " | ".join(
        f"{light}: tile pairs | fragments, M | of planes', % | of infinity's, %"
        for light in LIGHTS) + " |", "|" + " --- |" * (1 + 4 * len(LIGHTS))]
    left = {(light, other): [] for light in LIGHTS for other in ("planes", "infinity")}
    for of in results["scenes"]:
        cells = []
        for light in LIGHTS:
            own = of[light]["cost"]
            cells += [f"{own['tile_pairs']:,}", f"{own['fragments'] / 1e6:.1f}"]
            for other in ("planes", "infinity"):
                share = own["llvmpipe_ms"] / of[light][other]["llvmpipe_ms"]
                left[light, other].append(share)
                cells.append(f"{100 * share:.0f}")
        lines.append(f"| {NAMES[of['scene']]} | " + " | ".join(cells) + " |")
    lines.append("| geometric mean | " + " | ".join(
        f" | | {100 * mean(left[light, 'planes']):.0f} | {100 * mean(left[light, 'infinity']):.0f}"
        for light in LIGHTS) + " |")
    plan = [mean([max(of[light][choice]["plan_ms"], 1e-3) for of in results["scenes"]
                  for light in ("sun", "low sun")]) for choice in ("cost", "planes")]
    return ("\n".join(lines) + f"\n\nPlanning a frame of a sun takes {plan[0]:.2f} ms by cost, "
            f"{plan[1]:.2f} ms without (processor time, geometric mean).")


def main():
    results = results_of("fill", lambda: told_of_models("release/tests/bench/fill_costs",
                                                        "FILL_COSTS", NAMES))
    of = results["machine"]
    replace_between("docs/measured/fill.md", "ends",
                    "960x540, 8 frames of bench's flight, all surfaces from both sides; "
                    f"{of['processor']}, {of['date']}.\n\n" + ends_table(results))


if __name__ == "__main__":
    main()
