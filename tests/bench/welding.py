#!/usr/bin/env python3
"""Tolerances that `--weld-tolerance auto` chooses, edges that it closes, and its errors, on every
model in ../shared/scenes: the table of docs/measured/welding.md.

    tests/bench/welding.py           measures, then the table
    tests/bench/welding.py --table   the table from the stored results

EDGESHADE names the program.
"""

from accuracy import NAMES
from edgeshade_runs import SCENES, figure, percent, replace_between, report, results_of

SIZE, VIEWS = "480x270", 3


def measured(scene):
    path = SCENES / f"{scene}.glb"
    inside = report("info", path, "--weld-tolerance", "auto")
    result = {"diagonal": inside["diagonal"], "choice": inside["weld_choice"],
              "seconds": inside["seconds"]}
    if result["choice"]["tolerance"] > 0:
        wrong = report("compare", path, "--views", VIEWS, "--size", SIZE, "--against",
                       "weld-tolerance=auto")["results"]
        result["wrong"] = [{key: of[key] for key in
                            ("visible_pixels", "wrong_mask_pixels", "wrong_image_pixels")}
                           for of in wrong]
    return result


def shares(wrong, key):
    return " → ".join(figure(percent(of[key], of["visible_pixels"])) for of in wrong)


def row(scene, of):
    before, after = of["choice"]["before"], of["choice"]["after"]
    name = f"| {NAMES[scene]} | "
    if of["choice"]["tolerance"] == 0:
        return name + f"none | {before['borders']:,} | {before['quads']:,} | | | |"
    share = figure(percent(of["choice"]["tolerance"], of["diagonal"]))
    made = [after[key] - before[key] for key in ("degenerate_triangles", "non_manifold_edges")]
    return (name + f"{share} | {before['borders']:,} → {after['borders']:,} | "
            f"{before['quads']:,} → {after['quads']:,} | {made[0]:,}, {made[1]:,} | "
            f"{shares(of.get('wrong', []), 'wrong_mask_pixels')} | "
            f"{shares(of.get('wrong', []), 'wrong_image_pixels')} |")


def table(results):
    of = results["machine"]
    lines = ["| scene | tolerance, % of the diagonal | open edges | quads | degenerate triangles, "
             "non-manifold edges made | mask wrong, % | image wrong, % |", "|" + " --- |" * 7]
    lines += [row(scene, one) for scene, one in results["scenes"].items()]
    return (f"{SIZE}, {VIEWS} views against the oracle of the unwelded surfaces, software "
            f"renderer, {of['date']}. Quads are those of all edges, flat ones too: two "
            f"for a pair of triangles, one in closed components.\n\n" + "\n".join(lines))


def main():
    results = results_of("welding", lambda: {scene: measured(scene) for scene in NAMES})
    replace_between("docs/measured/welding.md", "welding", table(results))


if __name__ == "__main__":
    main()
