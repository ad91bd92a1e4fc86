#!/usr/bin/env python3
"""Meshes of 1, 5 and 10 million triangles as files: time and memory for packing and drawing them.
The table of docs/measured/large-scenes.md.

    tests/bench/large_scenes.py           measures, then the table
    tests/bench/large_scenes.py --table   the table from the stored results

EDGESHADE names the program, GENERATED_MESH write_generated_mesh, built by the target `measurements`. Writes up to
1.5 GB to a temporary folder.
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

from edgeshade_runs import PROGRAM, ROOT, figure, replace_between, results_of

GENERATED_MESH = os.environ.get("GENERATED_MESH",
                                str(ROOT / "build" / "release" / "tests" / "bench" / "write_generated_mesh"))
KINDS = {"grid": "hills", "boxes": "boxes"}
SIZES = (1_000_000, 5_000_000, 10_000_000)
SIZE, SUN = "1920x1080", ("--sun", "0.4,1,0.3")


def run(*words):
    """Elapsed seconds, peak memory in bytes, and the output."""
    with tempfile.TemporaryFile() as told:
        start = time.monotonic()
        child = subprocess.Popen([*map(str, words)], stdout=told)
        _, status, used = os.wait4(child.pid, 0)
        seconds = time.monotonic() - start
        child.returncode = os.waitstatus_to_exitcode(status)
        if child.returncode:
            sys.exit(f"{' '.join(map(str, words))}: ended with {child.returncode}")
        told.seek(0)
        return {"seconds": seconds, "bytes": 1024 * used.ru_maxrss}, told.read()


def measured():
    rows = []
    for kind in KINDS:
        for size in SIZES:
            print(kind, size, file=sys.stderr)
            with tempfile.TemporaryDirectory() as folder:
                source, packed = (pathlib.Path(folder) / name for name in ("source.glb", "packed.glb"))
                run(GENERATED_MESH, kind, size, source)
                row = {"kind": kind, "source_bytes": source.stat().st_size}
                row["pack"], told = run(PROGRAM, "pack", source, packed, "--report", "-")
                row["triangles"] = json.loads(told)["triangles"]
                row["packed_bytes"] = packed.stat().st_size
                row["draw"], _ = run(PROGRAM, "render", packed, f"{folder}/x.png", "--size", SIZE, *SUN)
                row["bench"], told = run(PROGRAM, "bench", packed, "--size", SIZE, *SUN, "--frames", 2,
                                         "--warm-up", 1, "--report", "-")
                result = json.loads(told)
                row |= {"frame_ms": result["frame_ms"]["median"], "bytes_gpu": result["bytes_gpu"],
                        "renderer": result["device"]["renderer"]}
                rows.append(row)
    return rows


def table(results):
    def gb(count):
        return figure(count / 2**30)

    lines = ["| mesh | triangles | file, GB | pack, s | most memory, GB | packed file, GB | open and draw, s | most "
             "memory, GB | a frame more, s |", "|" + " --- |" * 9]
    for of in results["scenes"]:
        lines.append(f"| {KINDS[of['kind']]} | {of['triangles']:,} | {gb(of['source_bytes'])} | "
                     f"{figure(of['pack']['seconds'])} | {gb(of['pack']['bytes'])} | {gb(of['packed_bytes'])} | "
                     f"{figure(of['draw']['seconds'])} | {gb(of['draw']['bytes'])} | {figure(of['frame_ms'] / 1e3)} |")
    machine = results["machine"]
    return (f"{machine['processor']}, {machine['cores']} cores, {machine['date']}; "
            f"{results['scenes'][0]['renderer']}, {SIZE} pixels.\n\n" + "\n".join(lines) + "\n")


if __name__ == "__main__":
    replace_between("docs/measured/large-scenes.md", "large scenes", table(results_of("large_scenes", measured)))
