#!/usr/bin/env python3
"""Compares what docs/versions.md calls stable with its records in tests/stable/records.

    tests/stable/check.py BUILD             fails with a sentence for each change that isn't recorded
    tests/stable/check.py BUILD --update    records the changes

Stable are the declarations of include/edgeshade and of the .d.ts files, the words of the command line, the keys of
reports, and the packed bytes of a scene drawn here. BUILD has the programs edgeshade and edgeshade_documents.
"""

import collections
import pathlib
import re
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from declarations import declarations  # noqa: E402
from record import Record  # noqa: E402
from report_keys import draw_scene, report_keys  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
RECORDS = HERE / "records"
ENCODINGS = ("none", "indexed", "expanded")
UPDATE = "tests/stable/check.py BUILD --update"
# These rise with every release, so they are no declarations.
OWN_NUMBER = re.compile(r"((?:VERSION_(?:MAJOR|MINOR|PATCH)|versionText ?=|packedFormatVersion ?=) ?).*")


def is_released():
    return re.search(r"^## \[\d", (ROOT / "CHANGELOG.md").read_text(), re.M) is not None


def all_declarations(paths):
    lines = []
    for path in sorted(paths):
        name = path.relative_to(ROOT).as_posix()
        lines += [name + " " + OWN_NUMBER.sub(r"\1", line) for line in declarations(path.read_text())]
    return lines


def lines_now(build):
    """(what, file of its record, its lines, verbs that can't run here) for each stable thing but packed bytes."""
    yield "The C++ API", "headers.txt", all_declarations((ROOT / "include/edgeshade").glob("*.hpp")), []
    types = [path for path in (ROOT / "web").glob("*/*.d.ts")]
    yield "The JavaScript API", "types.txt", all_declarations(types), []
    words = subprocess.run([build / "src/edgeshade_documents", "words"], check=True, capture_output=True, text=True)
    yield "The command line", "words.txt", words.stdout.splitlines(), []
    with tempfile.TemporaryDirectory() as folder:
        keys, missing = report_keys(build / "edgeshade", pathlib.Path(folder))
    yield "A report", "report_keys.txt", keys, missing


def first_words(line, names):
    return any(line.startswith(name + " ") for name in names)


def check_lines(build, update):
    faults = []
    for what, name, lines, missing in lines_now(build):
        record = Record(RECORDS / name)
        kept = [line for line in record.now() if first_words(line, missing)]
        if missing:
            print(f"{', '.join(missing)} can't run here, so the keys of its reports are not compared.")
        if update:
            if missing:
                sys.exit(f"{', '.join(missing)} can't run here, so no keys are recorded.")
            record.write(lines, is_released())
        elif (old := [line for line in record.now() if line not in kept]) != lines:
            came = list((collections.Counter(lines) - collections.Counter(old)).elements())
            went = list((collections.Counter(old) - collections.Counter(lines)).elements())
            for line in went:
                faults.append(f"{what} no longer has '{line}': take it back, or record a breaking change with {UPDATE} "
                              "and describe it in CHANGELOG.md.")
            for line in came:
                faults.append(f"{what} now has '{line}': record it with {UPDATE} and describe it in CHANGELOG.md.")
            if not came and not went:
                faults.append(f"{what} has its lines in another order: take that back, or record it with {UPDATE}.")
    return faults


def packed_format():
    text = (ROOT / "include/edgeshade/version.hpp").read_text()
    return int(re.search(r"packedFormatVersion = (\d+)", text).group(1))


def difference(old, new):
    at = next((i for i, (a, b) in enumerate(zip(old, new)) if a != b), min(len(old), len(new)))
    return f"from byte {at} on ({len(old)} bytes then, {len(new)} now)"


def check_packed(build, update):
    """Packed bytes may change only with the format's number, and stored files must still be read."""
    faults = []
    number = packed_format()
    stored = RECORDS / f"packed-{number}"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        draw_scene(folder)
        scene = folder / "scene.glb"
        (stored / "scene.glb").exists() or update or sys.exit(
            f"Packed files of format {number} are not recorded: {UPDATE} does that.")
        if (stored / "scene.glb").exists():
            scene = stored / "scene.glb"
        for encoding in ENCODINGS:
            subprocess.run([build / "edgeshade", "pack", scene, folder / f"{encoding}.glb", "--encoding", encoding],
                           check=True, capture_output=True)
            new, path = (folder / f"{encoding}.glb").read_bytes(), stored / f"{encoding}.glb"
            if not path.exists() and update:
                stored.mkdir(parents=True, exist_ok=True)
                path.write_bytes(new)
            elif path.read_bytes() != new:
                faults.append(f"Packed bytes ({encoding}) differ {difference(path.read_bytes(), new)} although "
                              f"packedFormatVersion is still {number}: take the change back, or raise that number in "
                              f"include/edgeshade/version.hpp and run {UPDATE}.")
            read = subprocess.run([build / "edgeshade", "info", path], capture_output=True, text=True)
            if read.returncode:
                faults.append(f"A stored file of format {number} is not read any more: {read.stderr.strip()}")
        if update and not (stored / "scene.glb").exists():
            (stored / "scene.glb").write_bytes(scene.read_bytes())
    return faults


def check_changelog():
    """Recorded breaking changes must be described."""
    went = [line for path in sorted(RECORDS.glob("*.txt")) for line in Record(path).changes()[1]]
    unreleased = (ROOT / "CHANGELOG.md").read_text().partition("## [Unreleased]")[2].partition("\n## [")[0]
    if went and not re.search(r"^### (Removed|Changed)$", unreleased, re.M):
        return [f"'{went[0]}' went since the last release, but the Unreleased section of CHANGELOG.md has neither "
                "'### Removed' nor '### Changed': say there what users must do."]
    return []


def main():
    words = sys.argv[1:]
    update = "--update" in words
    build = [pathlib.Path(word).resolve() for word in words if word != "--update"]
    if len(build) != 1:
        sys.exit(__doc__)
    faults = check_lines(build[0], update) + check_packed(build[0], update) + check_changelog()
    if faults:
        sys.exit("\n".join(faults))
    print("Recorded." if update else "Nothing stable has changed.")


if __name__ == "__main__":
    main()
