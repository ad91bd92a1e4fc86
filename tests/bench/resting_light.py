#!/usr/bin/env python3
"""Frames of a viewer whose light is dragged and released: volumes while it moves, a primitive map
once it rests, as a plot over time.

    tests/bench/resting_light.py           measures the garden, the temple and the city, and plots
    tests/bench/resting_light.py --table   docs/pictures/resting-light.svg from the results
"""

from edgeshade_runs import ROOT, replace_between, results_of, told_of_models

SCENES = ("garden.draco", "temple", "city.draco")
WIDTH, HEIGHT, LEFT, TOP, GAP = 640, 130, 56, 34, 46
COLORS = {"volumes": "#c8552b", "primitive-map": "#2b6cc8"}


def measured():
    return {scene: told_of_models("release/tests/bench/resting_light", "EDGESHADE_RESTING_LIGHT",
                                  [scene])["frames"] for scene in SCENES}


def panel(scene, frames, top):
    most = max(frame["ms"] for frame in frames)
    x = lambda at: LEFT + at / 6.0 * (WIDTH - LEFT - 16)
    y = lambda ms: top + HEIGHT * (1.0 - ms / most)
    lines = [f'<text x="{LEFT}" y="{top - 8}" font-weight="bold">{scene}</text>',
             f'<path d="M{LEFT} {top}V{top + HEIGHT}H{WIDTH - 16}" fill="none" stroke="#444"/>',
             f'<text x="{LEFT - 6}" y="{top + 10}" text-anchor="end">{most:.0f} ms</text>',
             f'<text x="{LEFT - 6}" y="{top + HEIGHT}" text-anchor="end">0</text>']
    for second in range(7):
        lines.append(f'<text x="{x(second):.1f}" y="{top + HEIGHT + 14}" text-anchor="middle">'
                     f'{second} s</text>')
    lines.append(f'<line x1="{x(1):.1f}" x2="{x(1):.1f}" y1="{top}" y2="{top + HEIGHT}" '
                 'stroke="#888" stroke-dasharray="3 3"/>')
    for frame in frames:
        lines.append(f'<circle cx="{x(frame["at"]):.1f}" cy="{y(frame["ms"]):.1f}" r="1.6" '
                     f'fill="{COLORS[frame["method"]]}"/>')
    return "\n".join(lines)


def plot(scenes):
    height = TOP + len(scenes) * (HEIGHT + GAP)
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" '
             f'width="{WIDTH}" height="{height}" font-family="sans-serif" font-size="11">',
             '<rect width="100%" height="100%" fill="#fff"/>']
    for i, (scene, frames) in enumerate(scenes.items()):
        parts.append(panel(scene, frames, TOP + i * (HEIGHT + GAP)))
    (ROOT / "docs/pictures/resting-light.svg").write_text("\n".join(parts + ["</svg>"]) + "\n")


def median(values):
    return sorted(values)[len(values) // 2]


def table(scenes):
    lines = ["| scene | dragged, median ms | at rest, counted: longest | the frame that takes over the "
             "map | looked up, median |", "|" + " --- |" * 5]
    for scene, frames in scenes.items():
        moved = [frame["ms"] for frame in frames if frame["at"] < 1.0][1:]
        counted = [frame["ms"] for frame in frames
                   if frame["at"] >= 1.0 and frame["method"] == "volumes"]
        looked = [frame["ms"] for frame in frames if frame["method"] == "primitive-map"]
        lines.append(f"| {scene} | {median(moved):.1f} | {max(counted):.1f} | {looked[0]:.1f} | "
                     f"{median(looked):.1f} |")
    return "\n".join(lines)


def main():
    results = results_of("resting_light", measured)
    plot(results["scenes"])
    replace_between("docs/measured/primitive-maps.md", "resting", table(results["scenes"]))


if __name__ == "__main__":
    main()
