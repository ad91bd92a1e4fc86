"""Runs the program and stores its measurements; shared by the scripts in this folder."""

import datetime
import json
import math
import os
import pathlib
import platform
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = ROOT.parent / "shared" / "scenes"
RESULTS = pathlib.Path(__file__).resolve().parent / "results"
PROGRAM = os.environ.get("EDGESHADE", str(ROOT / "build" / "release" / "edgeshade"))


def report(*words):
    """The JSON report of one call. If it draws a scene, the defaults are base shading and no culling,
    the settings of nearly all tables."""
    if words[0] in ("bench", "compare") and not {"--synthetic", "--shading"} & set(words):
        words += ("--shading", "base")
    if words[0] in ("bench", "compare") and not {"--synthetic", "--cull"} & set(words):
        words += ("--cull", "off")
    done = subprocess.run([PROGRAM, *map(str, words), "--report", "-"], check=True,
                          stdout=subprocess.PIPE)
    return json.loads(done.stdout)


def against(settings):
    """The arguments of bench or compare for further settings."""
    return [word for setting in settings for word in ("--against", setting)]


def machine():
    """The machine on which the figures were measured."""
    model = next((line.split(":", 1)[1].strip()
                  for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines()
                  if line.startswith("model name")), platform.machine())
    return {"processor": model, "cores": os.cpu_count(), "date": str(datetime.date.today())}


def told_of_models(program, variable, names):
    """As told_of(), for models in ../shared/scenes."""
    return told_of(program, variable, [str(SCENES / f"{name}.glb") for name in names])


def told_of(program, variable, words):
    """The JSON that one of the tests' programs prints for these arguments. `program`: its path in
    build/; the environment variable `variable` may name another build. Programs for node end in
    .cjs."""
    path = os.environ.get(variable, str(ROOT / "build" / program))
    run = ["node", path] if path.endswith(".cjs") else [path]
    done = subprocess.run([*run, *words], check=True, stdout=subprocess.PIPE)
    return json.loads(done.stdout)


def results_of(name, measured):
    """The results of measured(), with the machine; stores them. With --table it returns the stored
    results instead."""
    if sys.argv[1:2] == ["--table"]:
        return json.loads((RESULTS / f"{name}.json").read_text())
    results = {"machine": machine(), "scenes": measured()}
    write_results(name, results)
    return results


def mean(values):
    """The geometric mean."""
    return math.exp(sum(map(math.log, values)) / len(values))


def percent(part, whole):
    return 100.0 * part / whole if whole else 0.0


def figure(value):
    """Three significant digits: 0.00061, 2.31."""
    return "0" if value == 0 else f"{value:.{max(0, 2 - exponent(value))}f}"


def exponent(value):
    return int(f"{value:e}".split("e")[1])


def replace_between(path, name, text):
    """Replaces the text between <!-- name: begin --> and <!-- name: end -->."""
    path = ROOT / path
    old = path.read_text()
    begin, end = f"<!-- {name}: begin -->\n", f"<!-- {name}: end -->"
    if begin not in old or end not in old:
        raise SystemExit(f"{path} has no place for '{name}'")
    head, rest = old.split(begin, 1)
    path.write_text(head + begin + text.rstrip() + "\n" + end + rest.split(end, 1)[1])


def write_results(name, data):
    RESULTS.mkdir(exist_ok=True)
    (RESULTS / f"{name}.json").write_text(json.dumps(data, indent=1) + "\n")
