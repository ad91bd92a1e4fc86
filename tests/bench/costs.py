#!/usr/bin/env python3
"""Cost of drawing, on models in ../shared/scenes: results, plots, and the tables of
docs/measured/costs.md and claims.md.

    tests/bench/costs.py [PART...]      measures these parts (flight, repeat, sizes, synthetic, tradeoff), by default all
    tests/bench/costs.py --table        tables and plots from the stored results

EDGESHADE names the program, TIMING the timing method (query, finish, processor).
"""

import json
import os
import sys

from edgeshade_runs import (RESULTS, ROOT, SCENES, against, figure, machine, replace_between, report,
                            write_results)
from near_ratio import framing

TIMING = ["--timing", os.environ["TIMING"]] if "TIMING" in os.environ else []
FLIGHT_SCENES = {"city.draco": "city", "garden.draco": "garden"}
FLIGHT_SIZE, FLIGHT_FRAMES = "640x360", 10
REPEAT_SCENE = "city.draco"
SIZES_SCENE, SIZES_FRAMES = "garden.draco", 3
TRADEOFF_SCENES = {"garden.draco": "garden", "oaktree": "oak tree", "duck": "duck"}
TRADEOFF_SIZE, TRADEOFF_FRAMES, TRADEOFF_VIEWS = "320x180", 6, 3
TRADEOFF_LARGEST_MAP = 4096
MAPS = [f"shadows=map,map-size={1024 * n}" for n in (1, 2, 4, 8)]
PUBLISHED = ["layout=published", "multiplicity=three-edge", "multiplicity=single-edge"]

# Thesis, Tables 6.2 (without ANGLE), 6.3, 6.4, 6.6.
THESIS_SV_OVER_SM = {"Sponza": (14.7, 6.8, 8.0, 15.0, 41.7, 22.2, 5.6, 5.6, 8.4, 22.9),
                     "Conference Room": (8.0, 3.8, 5.3, 11.2, 34.2, 15.3, 2.9, 3.5, 6.0, 16.0),
                     "Sibenik": (7.6, 1.9, 3.6, 10.3, 36.0, 13.1, 1.8, 2.8, 6.0, 18.8)}
THESIS_STAGES = {"GTX 980": {"ambient": (3.6, 3.9, 4.6, 5.3), "silhouette": (5.3, 5.5, 5.2, 5.8),
                             "rasterise": (0.8, 6.7, 14.3, 28.8), "lit": (3.1, 3.1, 3.4, 3.8)},
                 "R9 290X": {"ambient": (3.5, 3.5, 3.9, 4.4), "silhouette": (3.1, 3.2, 3.1, 3.2),
                             "rasterise": (1.5, 6.1, 12.2, 24.0), "lit": (1.8, 1.9, 2.0, 2.3)}}
THESIS_FIT = {"GTX 980 (thesis)": (8.437815e-4, 1.7681964e-3, 4.4036999e-3, -1.19359553e-2,
                                   8.84234e-4, 4.30166459e-2),
              "R9 290X (thesis)": (4.229571e-4, 1.344101e-4, 1.7166787e-3, 1.7862163e-3,
                                   1.4015652e-3, 3.33773652e-2)}


def lamp(scene):
    """A point light above and beside the scene's middle, as in the thesis, which has one light per
    scene."""
    camera, distance = framing(scene)
    diagonal = distance / 1.2
    return ",".join(str(c + diagonal * d) for c, d in zip(camera["to"], (0.25, 0.5, 0.2)))


def condensed(full):
    """A report without the values that are the same in every row."""
    for result in full.get("results", [full]):
        result["device"].pop("extensions", None)
    full.get("device", {}).pop("extensions", None)
    return full


def with_device(data, full):
    first = full.get("results", [full])[0]
    device = first.get("device") or full["device"]
    return {"machine": machine() | {"renderer": device["renderer"], "driver": device["version"],
                                    "timing": first.get("timing") or full["timing"]}} | data


def measure_flight():
    scenes, last = {}, None
    for scene in FLIGHT_SCENES:
        path = SCENES / f"{scene}.glb"
        scenes[scene] = {}
        for light, words in (("rests", []), ("moves", ["--light-moves"])):
            last = condensed(report("bench", path, "--size", FLIGHT_SIZE, "--frames", FLIGHT_FRAMES,
                                    "--light", lamp(path), *TIMING, *words,
                                    *against(["shadows=none", *PUBLISHED, *MAPS])))
            scenes[scene][light] = last
    write_results("bench_flight", with_device({"size": FLIGHT_SIZE, "frames": FLIGHT_FRAMES,
                                               "scenes": scenes}, last))


def measure_repeat():
    """Whether ratios are the same when measured again."""
    path = SCENES / f"{REPEAT_SCENE}.glb"
    runs = [condensed(report("bench", path, *TIMING, *against(MAPS))) for _ in range(3)]
    rows = []
    for name in MAPS:
        medians = [ratio(run, name)["median"] for run in runs]
        rows.append({"name": name, "medians": medians,
                     "spread_percent": 100.0 * (max(medians) / min(medians) - 1.0)})
    write_results("bench_repeat", with_device({"scene": REPEAT_SCENE, "ratios": rows}, runs[0]))


def measure_sizes():
    path = SCENES / f"{SIZES_SCENE}.glb"
    full = condensed(report("bench", path, "--sizes", "all", "--frames", SIZES_FRAMES, "--light",
                            lamp(path), *TIMING, *against(["layout=published"])))
    write_results("bench_sizes", with_device({"scene": SIZES_SCENE, **full}, full))


def by_edges(rows):
    """Merges rows that differ only in the number of edges: {number: ms}."""
    merged = {}
    for row in rows:
        key = (row["layout"], row["silhouette"], row["multiplicity"])
        merged.setdefault(key, {})[str(row["edges"])] = round(row["ms"], 4)
    return [{"layout": layout, "silhouette": silhouette, "multiplicity": m, "ms": ms}
            for (layout, silhouette, m), ms in merged.items()]


def measure_synthetic():
    full = condensed(report("bench", "--synthetic", "--frames", 7, *TIMING))
    full["rows"] = by_edges(full["rows"])
    write_results("bench_synthetic", with_device(full, full))


def measure_tradeoff():
    scenes, last = {}, None
    for scene, name in TRADEOFF_SCENES.items():
        path = SCENES / f"{scene}.glb"
        plot = ROOT / "docs" / "pictures" / f"tradeoff-{scene.split('.')[0]}.svg"
        last = condensed(report("tradeoff", path, "--size", TRADEOFF_SIZE, "--frames",
                                TRADEOFF_FRAMES, "--views", TRADEOFF_VIEWS, "--largest-map",
                                TRADEOFF_LARGEST_MAP, *TIMING,
                                "--light-moves", "--max-wrong-percent", 0.1, "--plot", plot))
        scenes[scene] = last
    write_results("tradeoff", with_device({"scenes": scenes}, last))


def stored(name):
    path = RESULTS / f"{name}.json"
    return json.loads(path.read_text()) if path.exists() else None


def note(data):
    """A line on the origin of the figures."""
    at = data["machine"]
    how = {"processor": "processor time on all cores", "finish": "waiting", "query": "the GPU's clock"}
    return (f"{at['renderer']}, {at['driver']}, {at['cores']} cores of {at['processor']}, "
            f"{at['date']}; times by {how[at['timing']]}.")


def ratio(result, name):
    return next(r for r in result["ratios"] if r["name"] == name)


def flight_table(data):
    heads = ["no shadows", "opposite-vertex layout", *(f"map {1024 * n}" for n in (1, 2, 4, 8))]
    names = ["shadows=none", "layout=published", *MAPS]
    lines = [f"{data['size']}, {data['frames']} frames. " + note(data), "", "| scene, light | volumes, ms | "
             + " | ".join(f"/ {head}" for head in heads) + " |", "|" + " --- |" * (2 + len(heads))]
    for scene, lights in data["scenes"].items():
        for light, full in lights.items():
            ms = full["results"][0]["frame_ms"]["median"]
            lines.append(f"| {FLIGHT_SCENES.get(scene, scene)}, {light} | {figure(ms)} | "
                         + " | ".join(f"{ratio(full, name)['median']:.2f}" for name in names)
                         + " |")
    return "\n".join(lines)


def thesis_maps_table(data):
    lines = ["| maps drawn for every frame | / SM1 | / SM2 | / SM4 | / SM8 |",
             "| --- | --- | --- | --- | --- |"]
    for scene, lights in data["scenes"].items():
        by = {r["name"]: r["frame_ms"]["median"] for r in lights["moves"]["results"]}
        for name, setting in (("opposite-vertex layout", "layout=published"), ("proposed", "volumes")):
            lines.append(f"| ours, {FLIGHT_SCENES.get(scene, scene)}, {name} | "
                         + " | ".join(f"{by[setting] / by[m]:.2f}" for m in MAPS) + " |")
    for scene, row in THESIS_SV_OVER_SM.items():
        for device, (volumes, *maps) in (("R9 290X", row[:5]), ("GTX 980", row[5:])):
            lines.append(f"| thesis, {scene}, {device} | "
                         + " | ".join(f"{volumes / m:.2f}" for m in maps) + " |")
    return "\n".join(lines)


def robust_table(data):
    lines = ["| scene | reference edge | three edges | single edge (plain) |",
             "| --- | --- | --- | --- |"]
    for scene, lights in data["scenes"].items():
        by = {r["name"]: r["frame_ms"]["median"] for r in lights["rests"]["results"]}
        plain = by["multiplicity=single-edge"]
        lines.append(f"| {FLIGHT_SCENES.get(scene, scene)} | {by['layout=published'] / plain:.2f} | "
                     f"{by['multiplicity=three-edge'] / plain:.2f} | 1 |")
    return "\n".join(lines)


def sizes_table(data):
    lines = [note(data), "", "| | stage | 800×600 | 1920×1080 | 2560×1600 | 3840×2160 | growth |",
             "|" + " --- |" * 7]

    def add(who, stage, values):
        growth = values[-1] / values[0] if values[0] else float("inf")
        lines.append(f"| {who} | {stage} | " + " | ".join(figure(v) for v in values)
                     + f" | {growth:.1f} |")
    for name in dict.fromkeys(r["name"] for r in data["results"]):
        rows = [r["stage_ms"] for r in data["results"] if r["name"] == name]
        for stage in ("ambient", "silhouette", "rasterise", "lit"):
            add("proposed" if name == "volumes" else "published", stage, [r[stage] for r in rows])
    for device, stages in THESIS_STAGES.items():
        for stage, values in stages.items():
            add(f"thesis, {device}", stage, values)
    return "\n".join(lines)


def fit_table(data):
    lines = [note(data), "", "| layout | silhouette | k0 | k1 | k2 | k3 | k4 | k5 | mean error, % "
             "| time linear in edges, R² ≥ |", "|" + " --- |" * 10]
    for fit in data["fits"]:
        lines.append(f"| {fit['layout']} | {fit['silhouette']} | "
                     + " | ".join(f"{fit[f'k{i}']:.2e}" for i in range(6))
                     + f" | {fit['mwse_percent']:.1f} | {fit['linear_r_squared']:.4f} |")
    for device, k in THESIS_FIT.items():
        lines.append(f"| {device} | all | " + " | ".join(f"{v:.2e}" for v in k) + " | | |")
    return "\n".join(lines)


def equation(k, e, m):
    return (k[0] * m * m + k[2] * m + k[4]) * e + k[1] * m * m + k[3] * m + k[5]


def synthetic_plot(data, path):
    import matplotlib
    matplotlib.use("agg")
    from matplotlib import pyplot
    figure_, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4.4))
    colors = dict(zip(dict.fromkeys(r["layout"] for r in data["rows"]),
                      ("#1e8449", "#2471a3", "#7d3c98", "#58d68d", "#5dade2")))
    most = max(int(edges) for row in data["rows"] for edges in row["ms"])
    for layout, color in colors.items():
        rows = {r["multiplicity"]: r["ms"][str(most)] for r in data["rows"]
                if r["layout"] == layout and r["silhouette"] == "all"}
        x = sorted(rows)
        left.semilogy(x, [rows[m] for m in x], "o-", color=color, markersize=4, label=layout)
        right.plot(x, [rows[m] / rows[1] for m in x], "o-", color=color, markersize=4, label=layout)
    for (device, k), style in zip(THESIS_FIT.items(), ("--", ":")):
        x = range(1, 10)
        t = [equation(k, most / 1000, m) for m in x]
        left.semilogy(x, t, style, color="#c0392b", label=device)
        right.plot(x, [v / t[0] for v in t], style, color="#c0392b", label=device)
    left.set_ylabel(f"ms for {most:,} edges, all of them silhouette edges")
    right.set_ylabel("times as long as with one triangle an edge")
    for axes in (left, right):
        axes.set_xlabel("triangles an edge (multiplicity)")
        axes.grid(True, alpha=0.3)
    right.legend(fontsize=8)
    figure_.tight_layout()
    pyplot.rcParams["svg.hashsalt"] = "edgeshade"
    figure_.savefig(path, metadata={"Date": None})


def tradeoff_table(data):
    lines = [note(data), "", "| scene | on the front, from fast to exact | fastest with ≤ 0.1 % wrong |",
             "| --- | --- | --- |"]
    for scene, full in data["scenes"].items():
        front = sorted((r for r in full["rows"] if r["pareto"]), key=lambda r: r["frame_ms"])
        names = ", ".join(f"{r['name']} ({figure(r['frame_ms'])} ms, "
                          f"{figure(r['wrong_image_percent'])} %)" for r in front)
        take = full.get("take")
        lines.append(f"| {TRADEOFF_SCENES.get(scene, scene)} | {names} | "
                     + (f"`{take['options']}`" if take else "none") + " |")
    return "\n".join(lines)


def tables():
    if flight := stored("bench_flight"):
        replace_between("docs/measured/costs.md", "costs", flight_table(flight))
        replace_between("docs/measured/claims.md", "maps",
                        flight_table(flight) + "\n\n" + thesis_maps_table(flight))
        replace_between("docs/measured/claims.md", "robust", robust_table(flight))
    if sizes := stored("bench_sizes"):
        replace_between("docs/measured/claims.md", "sizes", sizes_table(sizes))
    if synthetic := stored("bench_synthetic"):
        replace_between("docs/measured/claims.md", "fit", fit_table(synthetic))
        synthetic_plot(synthetic, ROOT / "docs" / "pictures" / "synthetic.svg")
    if tradeoff := stored("tradeoff"):
        replace_between("docs/measured/claims.md", "tradeoff", tradeoff_table(tradeoff))


def main(words):
    parts = {"flight": measure_flight, "repeat": measure_repeat, "sizes": measure_sizes,
             "synthetic": measure_synthetic, "tradeoff": measure_tradeoff}
    if words[:1] != ["--table"]:
        for word in words or parts:
            parts[word]()
    tables()


if __name__ == "__main__":
    main(sys.argv[1:])
