#!/usr/bin/env python3
"""Wrong pixels against the near plane's distance, for one depth range and for depth slices
(docs/method.md, C26 and C27). Writes the table of docs/measured/near-plane.md and
docs/pictures/near-ratio.svg.

    tests/bench/near_ratio.py [SCENE]    the name of a model in ../shared/scenes, bunny.draco
"""

import pathlib
import sys
import tempfile

from edgeshade_runs import (ROOT, SCENES, figure, machine, percent, replace_between, report,
                            write_results)

RATIOS = (1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 5e-2, 0.2)
SIZE = "1920x1080"


def lights_around(center, diagonal):
    """Two lamps and a low sun."""
    def lamp(x, y, z):
        return ",".join(str(c + diagonal * d) for c, d in zip(center, (x, y, z)))
    return [("--light", lamp(0.4, 0.8, 0.3)), ("--light", lamp(-0.6, 0.3, 0.5)),
            ("--sun", "0.8,0.15,0.5")]


def framing(scene):
    """The camera that frames the scene, its target, and the size of its subject."""
    with tempfile.TemporaryDirectory() as folder:
        camera = report("render", scene, pathlib.Path(folder) / "a.png", "--size",
                        "64x36")["camera"]
    distance = sum((a - b) ** 2 for a, b in zip(camera["from"], camera["to"])) ** 0.5
    return camera, distance


def measure(scene):
    camera, distance = framing(scene)
    diagonal = distance / 1.2
    view = ["--camera-from", ",".join(map(str, camera["from"])),
            "--camera-to", ",".join(map(str, camera["to"])), "--size", SIZE]
    rows = []
    for ratio in (*RATIOS, "auto"):
        near = ratio if ratio == "auto" else ratio * diagonal
        visible = one = sliced = 0
        for light in lights_around(camera["to"], diagonal):
            runs = report("compare", scene, *view, "--near", near, *light, "--against",
                          "depth-slices=1")["results"]
            visible += runs[0]["visible_pixels"]
            sliced += runs[0]["wrong_mask_pixels"]
            one += runs[1]["wrong_mask_pixels"]
        rows.append({"near_ratio": ratio, "visible_pixels": visible,
                     "one_range_wrong_percent": percent(one, visible),
                     "sliced_wrong_percent": percent(sliced, visible)})
        print(rows[-1], file=sys.stderr)
    return rows


def table(rows):
    lines = ["| near plane / scene | one depth range, % wrong | depth slices, % wrong |",
             "| --- | --- | --- |"]
    for row in rows:
        ratio = row["near_ratio"]
        lines.append(f"| {'fitted' if ratio == 'auto' else f'{ratio:g}'} | "
                     f"{figure(row['one_range_wrong_percent'])} | "
                     f"{figure(row['sliced_wrong_percent'])} |")
    return "\n".join(lines)


def plot(rows, path):
    import matplotlib
    matplotlib.use("agg")
    from matplotlib import pyplot
    fixed = [row for row in rows if row["near_ratio"] != "auto"]
    fitted = next(row for row in rows if row["near_ratio"] == "auto")
    figure_, axes = pyplot.subplots(figsize=(7, 4.2))
    x = [row["near_ratio"] for row in fixed]
    axes.loglog(x, [row["one_range_wrong_percent"] for row in fixed], "o-", color="#c0392b",
                label="one depth range")
    axes.loglog(x, [row["sliced_wrong_percent"] for row in fixed], "s-", color="#2471a3",
                label="depth slices, as many as pay")
    axes.axhline(fitted["sliced_wrong_percent"], color="#555", linestyle="--", linewidth=1,
                 label="near plane fitted to the view")
    axes.set_xlabel("near plane's distance / size of the scene")
    axes.set_ylabel("wrong pixels, percent of visible ones")
    axes.grid(True, which="major", alpha=0.3)
    axes.legend()
    figure_.tight_layout()
    figure_.savefig(path, metadata={"Date": None})


def main(words):
    name = words[0] if words else "bunny.draco"
    rows = measure(SCENES / f"{name}.glb")
    write_results("near_ratio", {"machine": machine(), "scene": name, "rows": rows})
    replace_between("docs/measured/near-plane.md", "near-ratio", table(rows))
    plot(rows, ROOT / "docs" / "pictures" / "near-ratio.svg")


if __name__ == "__main__":
    main(sys.argv[1:])
