#!/usr/bin/env python3
"""Runs the comparing step of docs/ci-recipe.md as it is written there, on the scene that ships.

    tests/docs/ci_recipe_test.py PROGRAM
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SKIPPED = 77  # CTest's status of a skipped test
SMALL = "--views 1 --size 160x120"


def step(text, name):
    """The shell lines of a step of the recipe."""
    lines = re.search(rf"^ +- name: {name}\n +run: \|\n((?: {{10}}.*\n)+)", text, re.M)
    if not lines:
        sys.exit(f"docs/ci-recipe.md has no step '{name}' with shell lines.")
    return re.sub(r"^ {10}", "", lines.group(1), flags=re.M)


def variables(text):
    block = re.search(r"^    env:\n((?: {6}\w+: .*\n)+)", text, re.M).group(1)
    return {key: value.split(" #")[0].strip() for key, value in re.findall(r"(\w+): (.*)", block)}


def run(script, folder, program, settings):
    environment = {**os.environ, **settings, "PATH": f"{program.parent}:{os.environ['PATH']}"}
    # The same words as GitHub's runner has for `shell: bash`.
    return subprocess.run(["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", script], cwd=folder,
                          env=environment, capture_output=True, text=True)


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    if not shutil.which("jq"):
        print("Skipped: jq is not here; Debian's package of that name has it.")
        sys.exit(SKIPPED)
    text = (ROOT / "docs/ci-recipe.md").read_text()
    compare, defaults = step(text, "Compare each model with rays"), variables(text)
    for name, script in (("install", step(text, "Install edgeshade")), ("compare", compare)):
        checked = subprocess.run(["bash", "-n", "-c", script], capture_output=True, text=True)
        if checked.returncode:
            sys.exit(f"The step to {name} is no shell script: {checked.stderr}")

    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "models").mkdir()
        shutil.copy(ROOT / "assets/pavilion.glb", folder / "models/pavilion.glb")
        small = {**defaults, "OPTIONS": defaults["OPTIONS"].split(" --views")[0] + " " + SMALL}
        right = run(compare, folder, program, small)
        if right.returncode or "1 models are judged" not in right.stdout:
            sys.exit(f"Exact shadows fail:\n{right.stdout}{right.stderr}")
        if not (folder / "wrong/pavilion.glb.json").exists():
            sys.exit("There is no report.")

        coarse = run(compare, folder, program, {**small, "OPTIONS": f"--shadows map --map-size 256 {SMALL}"})
        if not coarse.returncode or not re.search(r"::error file=models/pavilion.glb::\d+ pixels", coarse.stdout):
            sys.exit(f"A coarse shadow map passes:\n{coarse.stdout}{coarse.stderr}")

        (folder / "models/broken.glb").write_bytes(b"no scene")
        broken = run(compare, folder, program, small)
        if not broken.returncode or "broken.glb" not in broken.stderr or "2 models are judged" not in broken.stdout:
            sys.exit(f"A broken model passes:\n{broken.stdout}{broken.stderr}")
    print("The recipe passes exact shadows, and fails on a coarse map and a broken file.")


if __name__ == "__main__":
    main()
