#!/usr/bin/env python3
"""Wrongly counted points of lights with an extent, for volumes and primitive maps against the
oracle, by scene, shape and number of points, on models in ../shared/scenes: the table of
docs/measured/extended-lights.md.

    tests/bench/extended_lights.py           measures, then the table
    tests/bench/extended_lights.py --table   the table from the stored results

EDGESHADE names the program.
"""

from edgeshade_runs import SCENES, figure, replace_between, report, results_of

MODELS = {"temple": "temple.glb", "city": "city.draco.glb", "garden": "garden.draco.glb",
          "hospital, electrical": "hospital-electrical.glb"}
POINTS = (16, 64, 255)
MAP = "by map"
VIEWS, SIZE = 3, "320x180"  # the views cycle through six kinds
# Sizes as shares of the scene's diagonal, or in degrees.
SHAPES = {"sphere": ("--light-radius", 0.02), "rectangle": ("--light-size", 0.05),
          "sun's disc": ("--sun-angle", 0.53), "sun of 6 degrees": ("--sun-angle", 6.0)}


def extent(shape, diagonal):
    option, size = SHAPES[shape]
    if option == "--sun-angle":
        return (option, size)
    if option == "--light-size":
        return (option, f"{size * diagonal},{0.5 * size * diagonal}")
    return (option, size * diagonal)


def measured():
    found = {}
    for name, file in MODELS.items():
        path = SCENES / file
        diagonal = report("info", path)["diagonal"]
        for shape in SHAPES:
            against = [word for points in POINTS[:-1] for word in ("--against", f"light-samples={points}")]
            # Two of the three shapes are point lights, one is a sun.
            against += ["--against", f"light-samples={POINTS[-1]},shadows=primitive-map"]
            told = report("compare", path, "--views", VIEWS, "--size", SIZE,
                          *extent(shape, diagonal), "--light-samples", POINTS[-1], *against)["results"]
            *by_volumes, by_map = [{key: of[key] for key in (
                "views", "visible_pixels", "points", "wrong_points", "wrong_points_percent",
                "wrong_count_pixels", "wrong_count_beyond_1px", "wrong_count_beyond_1px_not_tied",
                "largest_wrong_count")} for of in told]
            counts = [of["settings"]["light-samples"] for of in told[:-1]]
            found.setdefault(name, {})[shape] = dict(zip(map(str, counts), by_volumes)) | {MAP: by_map}
    return found


def table(scenes):
    lines = ["| scene | light | " + " | ".join(f"{n} points, wrong %" for n in POINTS)
             + f" | {POINTS[-1]} points, looked up | beyond 1 px: volumes | looked up | not tied: volumes | looked up | worst pixel |",
             "|" + " --- |" * (8 + len(POINTS))]
    for name, shapes in scenes.items():
        for shape, by_points in shapes.items():
            of, looked_up = [by_points[str(n)] for n in POINTS], by_points[MAP]
            lines.append(f"| {name} | {shape} | "
                         + " | ".join(figure(one["wrong_points_percent"]) for one in of)
                         + f" | {figure(looked_up['wrong_points_percent'])}"
                         + "".join(f" | {one[key]}" for key in ("wrong_count_beyond_1px",
                                                               "wrong_count_beyond_1px_not_tied")
                                   for one in (of[-1], looked_up))
                         + f" | {of[-1]['largest_wrong_count']} |")
    return "\n".join(lines)


if __name__ == "__main__":
    results = results_of("extended_lights", measured)
    told = (f"{results['machine']['cores']} cores of {results['machine']['processor']}, "
            f"{results['machine']['date']}, software renderer, {SIZE}. The last five columns are for "
            f"{POINTS[-1]} points, by volumes and by lookup in primitive maps.")
    replace_between("docs/measured/extended-lights.md", "counts", told + "\n\n" + table(results["scenes"]))
