#!/usr/bin/env python3
"""Savings and errors of coarser casters, on models in ../shared/scenes: a table of
docs/measured/casters.md.

    tests/bench/casters.py           measures, then the table
    tests/bench/casters.py --table   the table from the stored results

EDGESHADE names the program.
"""

from accuracy import NAMES
from edgeshade_runs import SCENES, figure, percent, replace_between, report, results_of

MEASURED = ("bunny.draco", "hospital-electrical", "city.draco")
SIZE, FRAMES, VIEWS = "480x270", 6, 3
ERRORS = (0.05, 0.2, 1.0)  # percent of the diagonal
ANGLES = (0.1, 1.0, 5.0)


def settings(scene):
    size = report("info", scene)["diagonal"]
    rows = {"exact": {}}
    rows |= {f"error {share:g} % of the diagonal": {"caster-error": f"{0.01 * share * size:.6g}"}
             for share in ERRORS}
    rows |= {f"flat within {angle:g}°": {"flat-tolerance": f"{angle:g}"} for angle in ANGLES}
    rows["welded within 0.01 % of the diagonal"] = {"weld-tolerance": f"{1e-4 * size:.6g}"}
    return rows


def measured(scene):
    path = SCENES / f"{scene}.glb"
    rows = settings(path)
    against = [word for options in list(rows.values())[1:]
               for word in ("--against", ",".join(f"{k}={v}" for k, v in options.items()))]
    wrong = report("compare", path, "--views", VIEWS, "--size", SIZE, *against)["results"]
    times = report("bench", path, "--size", SIZE, "--frames", FRAMES, "--timing", "processor",
                   *against)["results"]
    results = {}
    for (name, options), w, t in zip(rows.items(), wrong, times):
        words = [word for key, value in options.items() for word in (f"--{key}", value)]
        inside = report("info", path, *words)
        results[name] = {
            "settings": options,
            "casting_triangles": inside["casting_triangles"], "records": inside["records"],
            "flat_edges_dropped": inside["flat_edges_dropped"],
            "bytes_gpu": t["bytes_gpu"], "vertex_runs": t["vertex_runs"],
            "frame_ms": t["frame_ms"]["median"],
            "wrong": {key: w[key] for key in ("visible_pixels", "wrong_mask_pixels",
                                              "wrong_image_pixels", "wrong_image_beyond_1px")}}
    return results


def table(results):
    lines = ["| scene | casters | triangles | records | bytes on the GPU | vertex runs of a frame | "
             "frame, ms | mask wrong, % | image wrong, % | beyond 1 px, % |",
             "|" + " --- |" * 10]
    for scene, rows in results["scenes"].items():
        for name, of in rows.items():
            wrong = of["wrong"]
            share = {key: figure(percent(wrong[key], wrong["visible_pixels"])) for key in wrong}
            lines.append(f"| {NAMES[scene]} | {name} | {of['casting_triangles']:,} | "
                         f"{of['records']:,} | {of['bytes_gpu']:,} | {of['vertex_runs']:,} | "
                         f"{of['frame_ms']:.0f} | {share['wrong_mask_pixels']} | "
                         f"{share['wrong_image_pixels']} | {share['wrong_image_beyond_1px']} |")
    of = results["machine"]
    return (f"{SIZE}, {VIEWS} views against the oracle, {FRAMES} frames of a flight under a sun, "
            f"software renderer, {of['cores']} cores of {of['processor']}, {of['date']}; processor "
            f"time on all cores.\n\n" + "\n".join(lines))


def main():
    results = results_of("casters", lambda: {scene: measured(scene) for scene in MEASURED})
    replace_between("docs/measured/casters.md", "casters", table(results))


if __name__ == "__main__":
    main()
