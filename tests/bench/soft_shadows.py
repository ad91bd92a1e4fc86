#!/usr/bin/env python3
"""Error against time of soft shadows: exact shadows of N points, maps with a constant filter, and
percentage-closer soft shadows, for the same lamp and sun. The tables of
docs/measured/soft-shadows.md, the pictures docs/pictures/soft-shadows-*.png and the plot
docs/pictures/soft-shadows.svg.

    tests/bench/soft_shadows.py             measures, then tables, pictures and plot
    tests/bench/soft_shadows.py --table     tables and plot from the stored results
    tests/bench/soft_shadows.py --pictures  only the pictures

EDGESHADE names the program.
"""

import math
import pathlib
import subprocess
import sys
import tempfile

from culling import box, floor, glb
from edgeshade_runs import PROGRAM, ROOT, SCENES, figure, replace_between, report, results_of
from lit_models import camera_of, lights_for
from png_bytes import read_png, side_by_side, write_png
from soft_shadows_plot import write_plot

MODELS = {"duck": "duck.glb", "garden": "garden.draco.glb", "temple": "temple.glb"}
FRAMES = {"duck": 3, "garden": 3, "temple": 1}
SIZE, REFERENCE = "480x270", 4096
PICTURES = ROOT / "docs" / "pictures"

CONTENDERS = {f"{count:,} point{'s' * (count > 1)}": {"light-samples": count} for count in (1, 4, 16, 64, 256, 1024)}
CONTENDERS |= {f"{count:,} points, looked up": {"light-samples": count, "shadows": "primitive-map"}
               for count in (16, 64, 256, 1024)}
CONTENDERS |= {f"map 2048, PCF {width} x {width}":
               {"shadows": "map", "map-size": 2048, "soft": "pcf", "pcf": width}
               for width in (1, 3, 7)}
CONTENDERS |= {f"map {size}, PCSS": {"shadows": "map", "map-size": size, "soft": "pcss"}
               for size in (1024, 2048, 4096)}


def words_of(setting):
    return [word for name, value in setting.items() for word in (f"--{name}", str(value))]


def against(setting):
    return ",".join(f"{name}={value}" for name, value in setting.items())


def mask(path, out, setting, view):
    subprocess.run([PROGRAM, "render", path, out, "--mask", *words_of(setting), *view], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return read_png(pathlib.Path(out))


def difference(one, other):
    """Root mean square and mean absolute difference of grey masks over visible pixels, in %."""
    count, squares, sizes = 0, 0.0, 0.0
    for row, wanted in zip(one.rows, other.rows):
        for i in range(0, len(row), 4):
            if wanted[i + 3] == 0:
                continue
            apart = abs(row[i] - wanted[i]) / 255
            count += 1
            squares += apart * apart
            sizes += apart
    return {"rms": 100 * math.sqrt(squares / count), "mean": 100 * sizes / count}


def case(path, light, frame_count, folder):
    view = ("--size", SIZE, *light)
    wanted = mask(path, f"{folder}/wanted.png", {"light-samples": REFERENCE}, view)
    rows = {name: {"error": difference(mask(path, f"{folder}/mask.png", setting, view), wanted)}
            for name, setting in CONTENDERS.items()}
    own, *others = CONTENDERS.items()
    camera = camera_of(path)
    still = [word for end in ("from", "to")
             for word in (f"--camera-{end}", ",".join(map(str, camera[end])))]
    told = report("bench", path, *view, *still, *words_of(own[1]), "--frames", frame_count, "--warm-up", 1,
                  *(word for _, of in others for word in ("--against", against(of))))
    for (name, _), result in zip(CONTENDERS.items(), told["results"]):
        rows[name]["ms"] = result["frame_ms"]["median"]
        built = [of["build_ms"] for of in result.get("lights", []) if of["method"] == "primitive-map"]
        if built:
            rows[name]["build_ms"] = sum(built)
    for (name, _), ratio in zip(others, told["ratios"]):
        rows[name]["ratio"] = 1 / ratio["median"]
    rows[own[0]]["ratio"] = 1.0
    return {"renderer": told["results"][0]["device"]["renderer"], "rows": rows}


def measured():
    results = {}
    with tempfile.TemporaryDirectory() as folder:
        for name, file in MODELS.items():
            for kind, light in lights_for(SCENES / file).items():
                print(name, kind, file=sys.stderr)
                results[f"{name}, {kind}"] = case(SCENES / file, light, FRAMES[name], folder)
    return results


def table(results):
    machine = results["machine"]
    renderer = next(iter(results["scenes"].values()))["renderer"]
    lines = [f"{machine['cores']} cores of {machine['processor']}, {machine['date']}, {renderer}, "
             f"{SIZE}.", "",
             "| scene, light | shadows | RMS error, % | mean error, % | frame, ms | / 1 point's "
             "| map built in, ms |",
             "|" + " --- |" * 7]
    for name, of in results["scenes"].items():
        for shadows, row in of["rows"].items():
            lines.append(f"| {name} | {shadows} | {figure(row['error']['rms'])} | "
                         f"{figure(row['error']['mean'])} | {figure(row['ms'])} | "
                         f"{figure(row['ratio'])} | "
                         f"{figure(row['build_ms']) if 'build_ms' in row else ''} |")
    return "\n".join(lines)


def contact():
    """A box on the ground, and another just above the ground."""
    return floor(4, 0) + box([-1.2, 0, -0.5], [-0.2, 1.4, 0.5]) + box([0.5, 0.05, -0.5], [1.7, 0.35, 0.6])


def chain():
    """Stacked occluders: a wide board over a narrow one, over a block."""
    return (floor(4, 0) + box([-1.1, 2, -1.1], [0.2, 2.05, 1.1]) + box([-0.5, 1, -0.5], [1, 1.05, 0.5])
            + box([0.3, 0, -0.3], [0.7, 0.3, 0.3]))


def draw_pictures():
    view = ("--size", "320x240", "--camera-from", "-1.9,4,5.6", "--camera-to", "-0.5,0.4,0", "--fov", "36",
            "--light", "1.8,4.4,1.2", "--light-radius", "0.35", "--cull", "off")
    contenders = ({"light-samples": 1024}, CONTENDERS["map 2048, PCSS"],
                  CONTENDERS["map 2048, PCF 7 x 7"])
    with tempfile.TemporaryDirectory() as folder:
        for name, triangles in (("contact", contact()), ("chain", chain())):
            path = glb(pathlib.Path(folder) / "scene.glb", [], triangles)
            pictures = []
            for setting in contenders:
                out = pathlib.Path(folder) / "out.png"
                subprocess.run([PROGRAM, "render", path, out, *view, *words_of(setting)], check=True,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                pictures.append(read_png(out))
            write_png(PICTURES / f"soft-shadows-{name}.png", side_by_side(pictures))
        write_png(PICTURES / "soft-shadows-pavilion.png", side_by_side(list(pavilion(folder))))


def pavilion(folder):
    """A point-like sun, and a disc of 2 degrees."""
    view = ("--size", "480x360", "--camera-from", "2.6,1.7,5.2", "--camera-to", "0.7,0.35,1.2", "--fov", "40",
            "--sun", "0.6,0.7,0.5", "--smooth", "8")
    for light in ((), ("--sun-angle", "2", "--light-samples", "256")):
        out = pathlib.Path(folder) / "out.png"
        subprocess.run([PROGRAM, "render", ROOT / "assets" / "pavilion.glb", out, *view, *light], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        yield read_png(out)


def main():
    if sys.argv[1:2] != ["--pictures"]:
        results = results_of("soft_shadows", measured)
        replace_between(ROOT / "docs" / "measured" / "soft-shadows.md", "soft shadows", table(results))
        write_plot(PICTURES / "soft-shadows.svg", results["scenes"])
    if sys.argv[1:2] != ["--table"]:
        draw_pictures()


if __name__ == "__main__":
    main()
