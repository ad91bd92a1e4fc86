#!/usr/bin/env python3
"""Primitive maps, volumes and kept shadow maps with a resting light, on every model in
../shared/scenes: frame times, wrong pixels, memory, build time.

    tests/bench/primitive_maps.py           measures (a quarter of an hour on two cores), then the tables
    tests/bench/primitive_maps.py --table   docs/measured/primitive-maps.md from the results
"""

from accuracy import NAMES
from edgeshade_runs import SCENES, against, figure, mean, percent, replace_between, report, results_of

SIZE = "960x540"
AGAINST = {"map 1024": "shadows=map,map-size=1024", "volumes": "shadows=volumes"}


def measure(scene):
    path = SCENES / f"{scene}.glb"
    others = against(AGAINST.values())
    frames = report("bench", path, "--size", SIZE, "--frames", 24, "--shadows", "primitive-map",
                    *others)
    wrong = report("compare", path, "--size", SIZE, "--views", 16, "--against",
                   "shadows=primitive-map")
    for result in wrong["results"]:
        del result["by_view"]
    return {"bench": frames, "compare": wrong["results"]}


def times(results):
    lines = ["| scene | primitive map, ms | map 1024, kept | volumes | / map | / volumes | build, ms "
             "| MB |", "|" + " --- |" * 8]
    columns = []
    for scene, result in results.items():
        runs = result["bench"]["results"]
        ms = [run["frame_ms"]["median"] for run in runs]
        ratios = [ratio["median"] for ratio in result["bench"]["ratios"]]
        columns.append(ratios)
        light = runs[0]["lights"][0]
        lines.append(f"| {NAMES.get(scene, scene)} | " + " | ".join(f"{t:.1f}" for t in ms) +
                     f" | {ratios[0]:.2f} | {ratios[1]:.2f} | {light['build_ms']:.0f} | "
                     f"{light['bytes'] / 1e6:.1f} |")
    maps, volumes = (mean(column) for column in zip(*columns))
    lines.append(f"| geometric mean | | | | **{maps:.2f}** | **{volumes:.2f}** | | |")
    return "\n".join(lines)


def accuracy(results):
    lines = ["| scene | visible pixels | image wrong, % | volumes | mask wrong, % | volumes "
             "| beyond 1 px, not tied | volumes |", "|" + " --- |" * 8]
    for scene, result in results.items():
        volumes, looked = result["compare"]
        share = lambda run, key: figure(percent(run[key], run["visible_pixels"]))
        cells = [NAMES.get(scene, scene), f"{looked['visible_pixels']:,}"]
        for key in ("wrong_image_pixels", "wrong_mask_pixels"):
            cells += [share(looked, key), share(volumes, key)]
        cells += [str(run["wrong_image_beyond_1px_not_tied"]) for run in (looked, volumes)]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def main():
    results = results_of("primitive_maps", lambda: {
        path.name.removesuffix(".glb"): measure(path.name.removesuffix(".glb"))
        for path in sorted(SCENES.glob("*.glb"))})
    page = "docs/measured/primitive-maps.md"
    replace_between(page, "times", times(results["scenes"]))
    replace_between(page, "accuracy", accuracy(results["scenes"]))


if __name__ == "__main__":
    main()
