#!/usr/bin/env python3
"""Lights scattered over scenes: frames by their number, of volumes, of some with shadows, of maps. The
tables of docs/measured/many-lights.md.

    tests/bench/many_lights.py           measures, then tables
    tests/bench/many_lights.py --table   tables from the results that are there

EDGESHADE names the program.
"""

from edgeshade_runs import ROOT, SCENES, figure, replace_between, report, results_of

MODELS = {"pavilion": ROOT / "assets" / "pavilion.glb", "garden": SCENES / "garden.draco.glb",
          "city": SCENES / "city.draco.glb"}
SIZE, FRAMES, COUNTS = "160x120", 2, (1, 4, 16, 64)
SETTINGS = {"4 of them": "shadowed-lights=4", "none of them": "shadowed-lights=0",
            "maps 256": "shadows=map,map-size=256"}


def measured():
    scenes = {}
    for name, path in MODELS.items():
        told = report("bench", path, "--lights", ",".join(map(str, COUNTS)), "--size", SIZE,
                      "--frames", FRAMES, "--warm-up", 1, "--timing", "processor", "--shading", "full",
                      *(word for of in SETTINGS.values() for word in ("--against", of)))["results"]
        rows = {}
        each = 1 + len(SETTINGS)
        for i, count in enumerate(COUNTS):
            group = told[i * each:(i + 1) * each]
            rows[str(count)] = {
                "reaching": group[0]["lights_reaching"],
                "settings": {setting: {"ms": of["frame_ms"]["median"], "runs": of["vertex_runs"],
                                       "bytes": of["bytes_gpu"]}
                             for setting, of in zip(["all with shadows", *SETTINGS], group)}}
        scenes[name] = {"renderer": told[0]["device"]["renderer"], "rows": rows}
    return scenes


def tables(results):
    machine = results["machine"]
    names = ["all with shadows", *SETTINGS]
    lines = [f"{machine['processor']}, {machine['cores']} cores, {machine['date']}; "
             f"{next(iter(results['scenes'].values()))['renderer']}. Processor's milliseconds a frame of "
             f"{SIZE} pixels, medians of {FRAMES}; thousands of vertices through shaders of volumes or maps; "
             "MB on the GPU.", ""]
    for name, scene in results["scenes"].items():
        lines += [f"**{name}**", "", "| lights | that reach | " +
                  " | ".join(f"{of}: ms | vertices | MB" for of in names) + " |",
                  "| --- | --- |" + " --- | --- | --- |" * len(names)]
        for count, row in scene["rows"].items():
            cells = [count, str(row["reaching"])]
            for of in names:
                value = row["settings"][of]
                cells += [figure(value["ms"]), figure(value["runs"] / 1e3), figure(value["bytes"] / 2 ** 20)]
            lines.append("| " + " | ".join(cells) + " |")
        lines.append("")
    return "\n".join(lines).rstrip() + "\n"


if __name__ == "__main__":
    replace_between(ROOT / "docs" / "measured" / "many-lights.md", "lights",
                    tables(results_of("many_lights", measured)))
