#!/usr/bin/env python3
"""Whether what saves filling changes pictures: wrong pixels of the mask without and with each measure, every
scene of ../shared/scenes, 16 views, a sun and a lamp. The table "masks" of docs/measured/fill.md.

    tests/bench/measures.py           measures, then the table
    tests/bench/measures.py --table   the table from the results that are there

EDGESHADE names the program.
"""

from edgeshade_runs import replace_between, report, results_of
from lit_models import lit_models

SIZE, VIEWS = "480x270", 16
MEASURES = ("volume-scissors=on", "volume-ends=cost", "volume-ends=infinity", "caster-culling=on",
            "cull-solids=on")
# Where the processor draws, scissors are on by themselves.
OFF = ("--volume-scissors", "off")
WITHOUT = "none"


def case(path, light):
    told = report("compare", path, *light, *OFF, "--size", SIZE, "--views", VIEWS,
                  *(word for measure in MEASURES for word in ("--against", measure)))["results"]
    rows = {}
    for name, of in zip((WITHOUT, *MEASURES), told):
        rows[name] = {"wrong": of["wrong_mask_pixels"], "not_tied": of["wrong_image_beyond_1px_not_tied"],
                      "visible": of["visible_pixels"]}
    return rows


def measured():
    return {name: case(path, light) for name, path, _, light in lit_models()}


def table(results):
    names = (WITHOUT, *MEASURES)
    machine = results["machine"]
    lines = [f"{SIZE}, {VIEWS} views, llvmpipe; {machine['processor']}, {machine['date']}. Wrong pixels of the mask beside "
             "the oracle's, in all views, and, after the comma, those beyond one pixel of a boundary that no tie explains.", "",
             "| scene, light | visible pixels | " + " | ".join(names) + " |", "| --- | --- |" + " --- |" * len(names)]
    for name, rows in results["scenes"].items():
        cells = [f"{rows[of]['wrong']}, {rows[of]['not_tied']}" for of in names]
        lines.append(f"| {name} | {rows[WITHOUT]['visible']:,} | " + " | ".join(cells) + " |")
    sums = [sum(rows[of]["wrong"] for rows in results["scenes"].values()) for of in names]
    lines.append("| all | | " + " | ".join(map(str, sums)) + " |")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    replace_between("docs/measured/fill.md", "masks", table(results_of("measures", measured)))
