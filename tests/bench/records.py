#!/usr/bin/env python3
"""What the plane-pair records leave of the published ones, and proposals of them, beside cube maps, on
every model in ../shared/scenes: the tables of docs/measured/records.md.

    tests/bench/records.py           measures, then the tables
    tests/bench/records.py --table   the tables from the results that are there

EDGESHADE names the program.
"""

from accuracy import NAMES
from edgeshade_runs import SCENES, against, mean, replace_between, report, results_of

KEPT = ("triangles", "edges", "flat_edges_dropped", "records", "closed_oriented_triangles",
        "largest_opposite_count", "bytes", "vertex_runs", "seconds")
FRAME_KEPT = ("frame_ms", "stage_ms", "vertex_runs", "bytes_gpu")
FRAME_SIZE, FRAMES = "960x540", 8
MAP_SIZES = (1024, 2048, 4096, 8192)

# What the proposed records are measured against, as bench is asked for it.
AGAINST = {"all": "silhouette=all", "published": "layout=published"} | {
    f"map {size}": f"shadows=map,map-size={size}" for size in MAP_SIZES}
WAYS = ("proposed", *AGAINST)


def frames_of(path, *more):
    """Frames by each of WAYS, in one run."""
    told = report("bench", path, "--size", FRAME_SIZE, "--frames", FRAMES, "--timing", "processor",
                  *against(AGAINST.values()), *more)
    frames = {way: {key: result[key] for key in FRAME_KEPT}
              for way, result in zip(WAYS, told["results"])}
    return frames | {"device": told["results"][0]["device"]["renderer"],
                     "ratios": dict(zip(WAYS[1:], told["ratios"]))}


def measured(scene):
    path = SCENES / f"{scene}.glb"
    whole = report("info", path)
    return {key: whole[key] for key in KEPT} | {
        "resting": frames_of(path), "moving": frames_of(path, "--light-moves")}


def table(results):
    lines = ["| scene | edges | flat, dropped | closed triangles, % | runs of published / adapted "
             "sides | with all caps | sides' bytes / published sum | with all caps |",
             "|" + " --- |" * 8]
    ratios = []
    for scene, of in results["scenes"].items():
        runs, sizes = of["vertex_runs"], of["bytes"]
        published_sides = runs["published"] - runs["caps"]
        row = (published_sides / runs["sides"], runs["published"] / (runs["sides"] + runs["caps"]),
               sizes["sides"] / sizes["published_equation"],
               (sizes["sides"] + sizes["caps"]) / sizes["published_equation"])
        ratios.append(row)
        lines.append(f"| {NAMES[scene]} | {of['edges']:,} | {of['flat_edges_dropped']:,} | "
                     f"{100 * of['closed_oriented_triangles'] / of['triangles']:.0f} | "
                     f"{row[0]:.2f} | {row[1]:.2f} | {row[2]:.2f} | {row[3]:.2f} |")
    means = [mean(column) for column in zip(*ratios)]
    lines.append("| geometric mean | | | | " + " | ".join(f"{value:.2f}" for value in means) + " |")
    return "\n".join(lines)


def frame_table(results, light):
    """Times, runs and bytes of opposite-vertex records over those of plane-pair ones, proposed; for whole
    frames of all plane-pair ones too. Above 1 proposed records are better."""
    lines = ["| scene | vertex runs | bytes on the GPU | silhouette stage | rasterise | whole frame "
             "| whole frame, all plane-pair records |",
             "|" + " --- |" * 7]
    ratios = []
    for scene, of in results["scenes"].items():
        frames = of[light]
        ours, theirs = frames["proposed"], frames["published"]
        row = (theirs["vertex_runs"] / ours["vertex_runs"], theirs["bytes_gpu"] / ours["bytes_gpu"],
               theirs["stage_ms"]["silhouette"] / ours["stage_ms"]["silhouette"],
               theirs["stage_ms"]["rasterise"] / ours["stage_ms"]["rasterise"],
               1 / frames["ratios"]["published"]["median"], 1 / frames["ratios"]["all"]["median"])
        ratios.append(row)
        lines.append(f"| {NAMES[scene]} | " + " | ".join(f"{value:.2f}" for value in row) + " |")
    means = [mean(column) for column in zip(*ratios)]
    lines.append("| geometric mean | " + " | ".join(f"{value:.2f}" for value in means) + " |")
    return "\n".join(lines)


def map_table(results):
    """Whole frames with cube maps over those with proposed records, a light at rest and a moving
    one."""
    lines = ["| scene | " + " | ".join(f"{size} x {size}" for size in MAP_SIZES) + " |",
             "|" + " --- |" * (1 + len(MAP_SIZES))]
    columns = [[] for _ in MAP_SIZES]
    for scene, of in results["scenes"].items():
        cells = []
        for column, size in zip(columns, MAP_SIZES):
            pair = [1 / of[light]["ratios"][f"map {size}"]["median"]
                    for light in ("resting", "moving")]
            column.append(pair)
            cells.append("{:.2f}, {:.2f}".format(*pair))
        lines.append(f"| {NAMES[scene]} | " + " | ".join(cells) + " |")
    means = [[mean(values) for values in zip(*column)] for column in columns]
    lines.append("| geometric mean | "
                 + " | ".join("{:.2f}, {:.2f}".format(*pair) for pair in means) + " |")
    return "\n".join(lines)


def stage_table(results):
    """Where a frame's time goes."""
    lines = ["| scene | frame, ms | ambient | silhouette | rasterise | lit | the same of published "
             "records |", "|" + " --- |" * 7]
    for scene, of in results["scenes"].items():
        cells = []
        for way in ("proposed", "published"):
            frame = of["resting"][way]
            stages = frame["stage_ms"]
            cells.append([frame["frame_ms"]["median"]] + [
                stages[stage] for stage in ("ambient", "silhouette", "rasterise", "lit")])
        lines.append(f"| {NAMES[scene]} | " + " | ".join(f"{value:.1f}" for value in cells[0])
                     + " | " + ", ".join(f"{value:.1f}" for value in cells[1]) + " |")
    return "\n".join(lines)


def conditions(results):
    machine_ = results["machine"]
    device = next(iter(results["scenes"].values()))["resting"]["device"]
    return (f"{FRAME_SIZE}, {FRAMES} frames of a flight, {device}, {machine_['cores']} cores of "
            f"{machine_['processor']}, {machine_['date']}; processor time on all cores.\n\n")


def main():
    results = results_of("records", lambda: {scene: measured(scene) for scene in NAMES})
    replace_between("docs/measured/records.md", "records", table(results))
    replace_between("docs/measured/records.md", "frames", conditions(results)
                    + "The light at rest:\n\n" + frame_table(results, "resting")
                    + "\n\nA light that moves in every frame:\n\n" + frame_table(results, "moving"))
    replace_between("docs/measured/records.md", "maps", map_table(results))
    replace_between("docs/measured/records.md", "stages", stage_table(results))


if __name__ == "__main__":
    main()
