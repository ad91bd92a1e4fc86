#!/usr/bin/env python3
"""Draws the figures of docs/method.md and docs/architecture.md beside this script.

    docs/figures/make_figures.py           writes them
    docs/figures/make_figures.py --check   says which of them are not what would be written
"""

import pathlib
import sys

import flow
import frames
import volumes

HERE = pathlib.Path(__file__).resolve().parent
FIGURES = {
    "prism": volumes.prism,
    "multiplicity": volumes.multiplicity,
    "fan-of-caps": volumes.fan_of_caps,
    "winding": volumes.winding,
    "ball": volumes.ball,
    "front-cap": frames.front_cap,
    "z-pass-start": frames.z_pass_start,
    "ends": frames.ends,
    "depth-slices": frames.depth_slices,
    "flow": flow.flow,
}


def main(words):
    stale = []
    for name, draw in FIGURES.items():
        path = HERE / f"{name}.svg"
        svg = draw().svg()
        if words[:1] != ["--check"]:
            path.write_text(svg)
        elif not path.exists() or path.read_text() != svg:
            stale.append(path.name)
    if stale:
        raise SystemExit(f"not what make_figures.py draws: {', '.join(stale)}")


if __name__ == "__main__":
    main(sys.argv[1:])
