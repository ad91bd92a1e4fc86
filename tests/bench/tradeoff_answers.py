#!/usr/bin/env python3
"""Tests whether the settings that `tradeoff` recommends keep their promise on frames and views that
it did not measure: 60 tries over scenes generated from a seed. The table of
docs/measured/tradeoff.md.

    tests/bench/tradeoff_answers.py            measures, then the table; some twenty minutes
    tests/bench/tradeoff_answers.py --table    the table from the stored results

EDGESHADE names the program.
"""

import json
import pathlib
import random
import struct
import subprocess
import tempfile

from edgeshade_runs import PROGRAM, figure, percent, replace_between, report, results_of

TRIES = 60
SIZE, FRAMES, VIEWS, LARGEST_MAP = "160x90", 12, 12, 1024
OTHER_VIEWS, OTHER_FRAMES = 24, 17   # only the first of a flight's 17 frames is among its 12
TIME_MARGIN = 1.1                    # factor of the budget, see below
REFERENCE = "no shadows"


def box(low, high, inwards=False):
    """The twelve triangles of a box, as lists of corners."""
    corners = [[(low, high)[i >> axis & 1][axis] for axis in range(3)] for i in range(8)]
    quads = ((0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6))
    faces = [face for a, b, c, d in quads for face in ((a, b, c), (a, c, d))]
    return [[corners[i] for i in (reversed(face) if inwards else face)] for face in faces]


def room(draw):
    """A room with furniture made of boxes, and some slats."""
    width, height, depth = draw.uniform(4, 9), draw.uniform(2.4, 4), draw.uniform(4, 9)
    triangles = box((0, 0, 0), (width, height, depth), inwards=True)
    for _ in range(draw.randrange(4, 30)):
        x, z = draw.uniform(0.2, width - 1), draw.uniform(0.2, depth - 1)
        y = draw.choice((0.01, draw.uniform(0, 0.6 * height)))
        triangles += box((x, y, z), (x + draw.uniform(0.05, 0.8), y + draw.uniform(0.05, 1.0),
                                     z + draw.uniform(0.05, 0.8)))
    return triangles


def street(draw):
    """Houses along streets on flat ground."""
    triangles = [[(-60, 0, -60), (-60, 0, 60), (60, 0, 60)], [(-60, 0, -60), (60, 0, 60), (60, 0, -60)]]
    pitch = draw.uniform(8, 16)
    for i in range(-4, 4):
        for j in range(-4, 4):
            if draw.random() < 0.2:
                continue
            x, z = i * pitch, j * pitch
            triangles += box((x, 0.01, z), (x + pitch * draw.uniform(0.3, 0.8), draw.uniform(3, 25),
                                            z + pitch * draw.uniform(0.3, 0.8)))
    return triangles


def soup(draw):
    """Loose triangles above the ground."""
    triangles = [[(-5, 0, -5), (-5, 0, 5), (5, 0, 5)], [(-5, 0, -5), (5, 0, 5), (5, 0, -5)]]
    size = draw.uniform(0.1, 0.6)
    for _ in range(draw.randrange(50, 1500)):
        middle = [draw.uniform(-4, 4), draw.uniform(0.7, 4), draw.uniform(-4, 4)]
        triangles.append([[m + draw.uniform(-size, size) for m in middle] for _ in range(3)])
    return triangles


KINDS = {"room": room, "street": street, "soup": soup}


def write_glb(path, triangles):
    points = [point for triangle in triangles for point in triangle]
    data = b"".join(struct.pack("<3f", *point) for point in points)
    bounds = [[function(struct.unpack("<f", struct.pack("<f", p[axis]))[0] for p in points)
               for axis in range(3)] for function in (min, max)]
    text = json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
        "materials": [{"doubleSided": True}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(points), "type": "VEC3",
                       "min": bounds[0], "max": bounds[1]}],
        "bufferViews": [{"buffer": 0, "byteLength": len(data)}],
        "buffers": [{"byteLength": len(data)}]}).encode()
    text += b" " * (-len(text) % 4)
    path.write_bytes(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(data)) +
                     struct.pack("<I4s", len(text), b"JSON") + text +
                     struct.pack("<I4s", len(data), b"BIN\0") + data)


def taken(rows, budget, wrong, suffix="_below"):
    """The row that docs/tradeoff.md recommends; with suffix "" it goes by measured values instead of
    their bounds."""
    def known(row):
        return row["frame_ms" + suffix], row["wrong_image_percent" + suffix]

    within = [row for row in rows if not row["dominated_early"] and
              (budget is None or known(row)[0] <= budget) and (wrong is None or known(row)[1] <= wrong)]
    by = (lambda row: known(row)[0]) if wrong is not None else (lambda row: (known(row)[1], known(row)[0]))
    return min(within, key=by, default=None)


def told_by_tradeoff(path, wrong):
    """The report of tradeoff, even if no setting is acceptable (status 3)."""
    words = ["tradeoff", path, "--size", SIZE, "--frames", FRAMES, "--views", VIEWS, "--largest-map", LARGEST_MAP,
             "--timing", "processor", "--max-wrong-percent", wrong, "--report", "-"]
    done = subprocess.run([PROGRAM, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    if done.returncode not in (0, 3):
        raise SystemExit(f"tradeoff {path} ended with {done.returncode}")
    return json.loads(done.stdout)


def pasted(options):
    """Converts "--shadows map --map-size 512" to the form of --against."""
    words = options.split()
    return ",".join(f"{name[2:]}={value}" for name, value in zip(words[::2], words[1::2]))


def demands(draw, rows, wrong):
    """Three demands: on errors, on time, on both. Times are between that of the fastest setting and
    that of the slowest exact one."""
    times = sorted(row["frame_ms"] for row in rows if row["pareto"])
    span = [times[0] * (times[-1] / times[0] * 1.4) ** draw.uniform(0.1, 1.0) for _ in range(2)]
    return [(None, wrong), (span[0], None), (span[1], 10 ** draw.uniform(-1.0, 1.0))]


def checked(path, picks):
    """For each pick the percentage of wrong pixels in views that tradeoff did not see, and its time
    relative to the reference's, measured in one process."""
    against = [word for text in ["shadows=none", *picks] for word in ("--against", text)]
    judged = report("compare", path, "--shading", "full", "--size", SIZE, "--views", VIEWS + OTHER_VIEWS,
                    *against)["results"][2:]
    timed = report("bench", path, "--shading", "full", "--size", SIZE, "--frames", OTHER_FRAMES, "--timing",
                   "processor", *against)["results"][1:]
    others = [result["by_view"][VIEWS:] for result in judged]
    wrong = [percent(sum(view["wrong_image_pixels"] for view in views),
                     sum(view["visible_pixels"] for view in views)) for views in others]
    reference = timed[0]["frame_ms"]["median"]
    return [{"wrong": w, "time_ratio": result["frame_ms"]["median"] / reference}
            for w, result in zip(wrong, timed[1:])]


def measured_scene(seed, folder):
    draw = random.Random(seed)
    kind = list(KINDS)[seed % len(KINDS)]
    path = folder / f"{kind}-{seed}.glb"
    write_glb(path, KINDS[kind](draw))
    first = 10 ** draw.uniform(-1.0, 1.0)
    told = told_by_tradeoff(path, first)
    rows = told["rows"]
    ours = taken(rows, None, first)
    assert (ours and ours["name"]) == (told["take"] and told["take"]["name"]), "the rule is another"
    reference = next(row["frame_ms"] for row in rows if row["name"] == REFERENCE)
    asked = demands(draw, rows, first)
    picks = [taken(rows, *demand) for demand in asked]
    answered = [(demand, pick) for demand, pick in zip(asked, picks) if pick]
    found = checked(path, [pasted(pick["options"]) for _, pick in answered]) if answered else []
    tries = []
    for (budget, wrong), pick in answered:
        of = found.pop(0)
        spent = of["time_ratio"] * reference
        tries.append({"budget_ms": budget, "most_wrong": wrong, "take": pick["name"],
                      "frame_ms_below": pick["frame_ms_below"], "wrong_below": pick["wrong_image_percent_below"],
                      "frame_ms": spent, "wrong": of["wrong"],
                      "in_time": budget is None or spent <= TIME_MARGIN * budget,
                      "right_enough": wrong is None or of["wrong"] <= wrong})
    possible = sum(taken(rows, *demand, suffix="") is not None
                   for demand in asked) if all("frame_ms" in row for row in rows) else None
    return {"kind": kind, "seed": seed, "asked": len(asked), "possible": possible, "seconds": told["seconds"],
            "rows": len(rows), "left": sum(not row["dominated_early"] for row in rows), "tries": tries}


def measured():
    """Draws scenes until there are enough tries."""
    scenes, tries, seed = [], 0, 1
    with tempfile.TemporaryDirectory() as folder:
        while tries < TRIES:
            scene = measured_scene(seed, pathlib.Path(folder))
            scene["tries"] = scene["tries"][:TRIES - tries]
            scenes.append(scene)
            tries += len(scene["tries"])
            seed += 1
            print(f"{scene['kind']} {scene['seed']}: {len(scene['tries'])} answers, "
                  f"{sum(t['in_time'] and t['right_enough'] for t in scene['tries'])} kept", flush=True)
    return scenes


def share(part, whole):
    return f"{part} of {whole}"


def table(results):
    machine, scenes = results["machine"], results["scenes"]
    lines = [f"{machine['cores']} cores of {machine['processor']}, {machine['date']}, {SIZE}, {FRAMES} frames, "
             f"{VIEWS} views; checked in {OTHER_FRAMES} other frames and {OTHER_VIEWS} other views.", "",
             "| scenes | demands | answers | time kept | errors kept | both | time taken over budget, median | "
             "errors over the limit, median |", "|" + " --- |" * 8]

    def row(name, asked, tries):
        def middle(values):
            values = sorted(values)
            return figure(values[len(values) // 2]) if values else ""

        kept = [t for t in tries if t["in_time"] and t["right_enough"]]
        timed = [t for t in tries if t["budget_ms"]]
        judged = [t for t in tries if t["most_wrong"]]
        return (f"| {name} | {asked} | {len(tries)} | {share(sum(t['in_time'] for t in timed), len(timed))} | "
                f"{share(sum(t['right_enough'] for t in judged), len(judged))} | {share(len(kept), len(tries))} | "
                f"{middle(t['frame_ms'] / t['budget_ms'] for t in timed)} | "
                f"{middle(t['wrong'] / t['most_wrong'] for t in judged)} |")

    for kind in KINDS:
        of = [scene for scene in scenes if scene["kind"] == kind]
        lines.append(row(f"{len(of)} {kind}s", sum(s["asked"] for s in of), [t for s in of for t in s["tries"]]))
    every = [t for scene in scenes for t in scene["tries"]]
    lines.append(row("all", sum(s["asked"] for s in scenes), every))
    left = sum(s["left"] for s in scenes) / len(scenes)
    lines += ["", f"On average {left:.0f} of {scenes[0]['rows']} settings were not dropped. Without bounds, as measured, some "
              f"setting meets {sum(s['possible'] for s in scenes)} of {sum(s['asked'] for s in scenes)} demands."]
    failed = [(s, t) for s in scenes for t in s["tries"] if not (t["in_time"] and t["right_enough"])]
    if failed:
        lines += ["", "| broken | taken | budget, ms | took | limit, % | wrong |", "|" + " --- |" * 6]
        lines += [f"| {s['kind']} {s['seed']} | {t['take']} | {figure(t['budget_ms']) if t['budget_ms'] else ''} | "
                  f"{figure(t['frame_ms'])} | {figure(t['most_wrong']) if t['most_wrong'] else ''} | "
                  f"{figure(t['wrong'])} |" for s, t in failed]
    return "\n".join(lines)


def main():
    replace_between("docs/measured/tradeoff.md", "answers", table(results_of("tradeoff_answers", measured)))


if __name__ == "__main__":
    main()
