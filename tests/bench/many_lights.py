#!/usr/bin/env python3
"""Frame times by number of scattered lights, with volumes, with shadows for only some lights, with
primitive maps and with shadow maps; and the cost of lights that reach nothing. The tables of
docs/measured/many-lights.md.

    tests/bench/many_lights.py           measures, then tables
    tests/bench/many_lights.py --table   tables from the stored results

EDGESHADE names the program. Takes some minutes.
"""

import math

from edgeshade_runs import figure, replace_between, report, results_of
from lit_models import MODELS, middle_and_diagonal

NAMES = ("pavilion", "garden", "city")
SIZE, FRAMES, COUNTS = "480x270", 4, (1, 4, 16, 64, 256)
ALL = "all with shadows"
SETTINGS = {"4 of them": "shadowed-lights=4", "none of them": "shadowed-lights=0",
            "primitive maps": "shadows=primitive-map", "maps 256": "shadows=map,map-size=256"}
AWAY = 500  # lights that reach nothing
SEEN = 8    # lights that reach something


def bench(path, *words):
    return report("bench", path, "--size", SIZE, "--frames", FRAMES, "--warm-up", 1, "--timing",
                  "processor", "--shading", "full", *words)


def row(told):
    return {"ms": told["frame_ms"]["median"], "runs": told["vertex_runs"], "bytes": told["bytes_gpu"],
            "reaching": told["lights_reaching"]}


def by_number(path):
    """Makes one call per number of lights, so that the GPU holds the scenes of one number at a time."""
    rows = {}
    for count in COUNTS:
        told = bench(path, "--lights", count,
                     *(word for of in SETTINGS.values() for word in ("--against", of)))["results"]
        rows[str(count)] = {name: row(of) for name, of in zip([ALL, *SETTINGS], told)}
    return told[0]["device"]["renderer"], rows


def away(path):
    """SEEN lights in a ring around the scene's middle, alone and with AWAY others far from it."""
    middle, size = middle_and_diagonal(path)

    def ring(count, radius):
        for i in range(count):
            turn = 2 * math.pi * i / count
            place = (middle[0] + radius * math.cos(turn), middle[1], middle[2] + radius * math.sin(turn))
            yield from ("--light", ",".join(f"{x:.9g}" for x in place))

    lights = [*ring(SEEN, 0.15 * size), "--light-range", f"{0.2 * size:.9g}"]
    return {"without": row(bench(path, *lights)),
            "with": row(bench(path, *lights, *ring(AWAY, 20 * size)))}


def measured():
    scenes = {}
    for name in NAMES:
        path = MODELS[name]
        renderer, rows = by_number(path)
        scenes[name] = {"renderer": renderer, "rows": rows, "away": away(path)}
    return scenes


def growth(rows, setting, of):
    """The exponent of a time's growth with the number of lights that reach something: a least-squares
    fit of logarithms, for 4 lights or more; 1 is linear."""
    points = [(math.log(rows[str(count)][ALL]["reaching"]), math.log(rows[str(count)][setting][of]))
              for count in COUNTS if count >= 4 and rows[str(count)][setting][of] > 0]
    x, y = (sum(values) / len(points) for values in zip(*points))
    return sum((a - x) * (b - y) for a, b in points) / sum((a - x) ** 2 for a, _ in points)


def table(name, scene):
    rows = scene["rows"]
    names = [ALL, *SETTINGS]
    lines = [f"**{name}**", "", "| lights | reaching | " + " | ".join(f"{of}: ms | MB" for of in names) +
             f" | {ALL}: ms a light | thousands of vertices |", "| --- | --- |" + " --- |" * (2 * len(names) + 2)]
    for count, row in rows.items():
        cells = [count, str(row[ALL]["reaching"])]
        for of in names:
            cells += [figure(row[of]["ms"]), figure(row[of]["bytes"] / 2 ** 20)]
        cells += [figure(row[ALL]["ms"] / row[ALL]["reaching"]), figure(row[ALL]["runs"] / 1e3)]
        lines.append("| " + " | ".join(cells) + " |")
    return [*lines, ""]


def tables(results):
    machine = results["machine"]
    scenes = results["scenes"]
    lines = [f"{machine['processor']}, {machine['cores']} cores, {machine['date']}; "
             f"{next(iter(scenes.values()))['renderer']}. Times are the processor's milliseconds for "
             f"a frame of {SIZE} pixels, medians of {FRAMES}. MB on the GPU are those of shadows and of the table of "
             "lights. Vertices are those that the volumes' shaders run for.", ""]
    for name, scene in scenes.items():
        lines += table(name, scene)
    lines += ["**Growth**: the exponent with which time and volumes' vertices grow with the number of lights that reach "
              "something, from 4 lights on. 1 is linear.", "",
              "| scene | " + " | ".join(f"{of}: time" for of in (ALL, *SETTINGS)) + f" | {ALL}: vertices |",
              "| --- |" + " --- |" * (len(SETTINGS) + 2)]
    for name, scene in scenes.items():
        powers = [growth(scene["rows"], of, "ms") for of in (ALL, *SETTINGS)]
        lines.append("| " + " | ".join([name, *(f"{power:.2f}" for power in powers),
                                        f"{growth(scene['rows'], ALL, 'runs'):.2f}"]) + " |")
    lines += ["", f"**Lights that reach nothing visible**: {SEEN} lights around the scene's middle, all with "
              f"shadows, and the same with {AWAY} more, 20 scenes' sizes away.", "",
              "| scene | lights | reaching | ms | thousands of vertices | MB |", "| --- |" + " --- |" * 5]
    for name, scene in scenes.items():
        for which, count in (("without", SEEN), ("with", SEEN + AWAY)):
            of = scene["away"][which]
            lines.append(f"| {name} | {count} | {of['reaching']} | {figure(of['ms'])} | {figure(of['runs'] / 1e3)} | "
                         f"{figure(of['bytes'] / 2 ** 20)} |")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    replace_between("docs/measured/many-lights.md", "lights", tables(results_of("many_lights", measured)))
