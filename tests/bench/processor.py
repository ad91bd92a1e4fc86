#!/usr/bin/env python3
"""The processor's share of a frame whose light moves, beside a shadow map's: the table of
docs/measured/processor.md. A GL that draws nothing and names itself hardware stands for the card.

    tests/bench/processor.py           measures, then the table
    tests/bench/processor.py --table   the table from the stored results

EDGESHADE and NULL_GL name the program and build/release/tests/bench/libnull_gl.so.
"""

import os

from accuracy import NAMES
from edgeshade_runs import ROOT, SCENES, against, mean, replace_between, report, results_of

FRAMES = 60
NULL_GL = os.environ.get("NULL_GL", str(ROOT / "build/release/tests/bench/libnull_gl.so"))


def measured():
    os.environ["LD_PRELOAD"] = NULL_GL
    return [of_scene(name) for name in NAMES]


def of_scene(name):
    results = report("bench", SCENES / f"{name}.glb", "--light-moves", "--timing", "processor",
                     "--size", "1920x1080", "--frames", FRAMES, "--shadows", "volumes",
                     *against(["shadows=map,map-size=2048"]))["results"]
    ours, maps = ({"plan": of["plan_ms"], "submit": of["frame_ms"]["median"]} for of in results)
    return {"scene": name, "ours": ours, "map": maps}


def total(part):
    return part["plan"] + part["submit"]


def cell(part):
    return f"{part['plan']:.2f} + {part['submit']:.2f}"


def table(scenes):
    lines = ["| scene | volumes: plan + submit | map 2048: plan + submit | volumes / map |",
             "| --- | --- | --- | --- |"]
    for of in scenes:
        lines.append(f"| {NAMES[of['scene']]} | {cell(of['ours'])} | {cell(of['map'])} | "
                     f"{total(of['ours']) / total(of['map']):.1f} |")
    lines.append("| geometric mean | "
                 + " | ".join(f"{mean([total(of[side]) for of in scenes]):.2f}"
                              for side in ("ours", "map"))
                 + f" | **{mean([total(of['ours']) / total(of['map']) for of in scenes]):.1f}** |")
    return "\n".join(lines)


def main():
    results = results_of("processor", measured)
    of = results["machine"]
    replace_between("docs/measured/processor.md", "moving",
                    f"{of['cores']} cores of {of['processor']}, {of['date']}; milliseconds of "
                    f"processor time, the median of {FRAMES} frames in 1920x1080, base shading.\n\n"
                    + table(results["scenes"]))


if __name__ == "__main__":
    main()
