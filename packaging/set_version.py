#!/usr/bin/env python3
"""Sets the version of the next release everywhere, or checks that every place agrees.

    packaging/set_version.py 1.2.3      on the day of the release: writes the version, closes the Unreleased section of
                                        CHANGELOG.md, and lets tests/stable compare with this release from now on
    packaging/set_version.py --check    fails with a sentence for each place that differs from CMakeLists.txt

The version that CMakeLists.txt gives to project() counts; places that CMake can't write are the others.
docs/versions.md says which number must rise. --root FOLDER works on a copy.
"""

import argparse
import datetime
import pathlib
import re
import sys

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "tests/stable"))
from record import Record  # noqa: E402

NUMBER = r"\d+\.\d+\.\d+"
# File, pattern whose group 1 is a number, and the number there: version, its parts, or "major.minor".
PLACES = (
    ("CMakeLists.txt", rf"project\(edgeshade VERSION ({NUMBER})", "version"),
    ("include/edgeshade/version.hpp", r"EDGESHADE_VERSION_MAJOR (\d+)", "major"),
    ("include/edgeshade/version.hpp", r"EDGESHADE_VERSION_MINOR (\d+)", "minor"),
    ("include/edgeshade/version.hpp", r"EDGESHADE_VERSION_PATCH (\d+)", "patch"),
    ("include/edgeshade/version.hpp", rf'versionText = "({NUMBER})"', "version"),
    ("web/element/version.js", rf"version = '({NUMBER})'", "version"),
    ("web/package.json", rf'"version": "({NUMBER})"', "version"),
    ("web/package-lock.json", rf'\A{{\n  "name": "edgeshade",\n  "version": "({NUMBER})"', "version"),
    ("web/package-lock.json", rf'"": {{\n      "name": "edgeshade",\n      "version": "({NUMBER})"', "version"),
    ("packaging/vcpkg/edgeshade/vcpkg.json", rf'"version": "({NUMBER})"', "version"),
    ("docs/engine.md", r"find_package\(edgeshade (\d+\.\d+) REQUIRED\)", "major.minor"),
    ("tests/install/consumer/CMakeLists.txt", r"find_package\(edgeshade (\d+\.\d+) REQUIRED C", "major.minor"),
    ("tests/install/consumer/CMakeLists.txt", r"find_package\(edgeshade (\d+\.\d+) REQUIRED\)", "major.minor"),
)


def parts(version):
    return tuple(map(int, version.split(".")))


def number(kind, version):
    major, minor, patch = version.split(".")
    return {"version": version, "major": major, "minor": minor, "patch": patch, "major.minor": f"{major}.{minor}"}[kind]


def found(root, name, pattern):
    """The match in a file. Ends with a sentence if it has none."""
    match = re.search(pattern, (root / name).read_text())
    if not match:
        sys.exit(f"{name} has no version where {pattern!r} looks for it.")
    return match


def current(root):
    return found(root, *PLACES[0][:2]).group(1)


def check(root):
    wanted = current(root)
    faults = []
    for name, pattern, kind in PLACES:
        there = found(root, name, pattern).group(1)
        if there != number(kind, wanted):
            faults.append(f"{name} says {there}, but CMakeLists.txt says version {wanted}: "
                          "packaging/set_version.py sets all places.")
    if faults:
        sys.exit("\n".join(faults))
    print(f"Every place says {wanted}.")


def records(root):
    return [Record(path) for path in sorted((root / "tests/stable/records").glob("*.txt"))]


def require_rise(root, version):
    """The version must be new, and rise as far as what changed since the last release demands."""
    old, new = parts(current(root)), parts(version)
    changelog = (root / "CHANGELOG.md").read_text()
    is_first = not re.search(r"^## \[\d", changelog, re.M)
    if new < old or (new == old and not is_first):
        sys.exit(f"Version {version} does not follow {current(root)}.")
    came = [line for record in records(root) for line in record.changes()[0]]
    went = [line for record in records(root) for line in record.changes()[1]]
    if went and not (new[0] > old[0] or (old[0] == 0 and new[1] > old[1])):
        sys.exit(f"Version {version} promises that what worked with {current(root)} still does, but '{went[0]}' went: "
                 f"raise the {'major' if old[0] else 'minor'} number.")
    if came and new[:2] == old[:2]:
        sys.exit(f"Version {version} promises no more than {current(root)}, but '{came[0]}' came: raise the minor number.")


def set_version(root, version):
    require_rise(root, version)
    changelog = root / "CHANGELOG.md"
    text = changelog.read_text()
    head = "## [Unreleased]\n"
    if not text.partition(head)[2].partition("\n## [")[0].strip():
        sys.exit("The Unreleased section of CHANGELOG.md is empty: say there what this release brings.")
    for name, pattern, kind in PLACES:
        match = found(root, name, pattern)
        whole = match.string
        start, end = match.span(1)
        (root / name).write_text(whole[:start] + number(kind, version) + whole[end:])
    today = datetime.date.today().isoformat()
    changelog.write_text(text.replace(head, f"{head}\n## [{version}] - {today}\n", 1))
    for record in records(root):
        record.release()
    print(f"Every place says {version}. Commit that, and tag it v{version}.")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("version", nargs="?", metavar="X.Y.Z")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--root", type=pathlib.Path, default=HERE.parent)
    words = parser.parse_args()
    if words.check == (words.version is not None):
        parser.error("give a version or --check")
    if words.check:
        check(words.root)
    elif not re.fullmatch(NUMBER, words.version):
        sys.exit(f"'{words.version}' is no version: three whole numbers, such as 1.2.3.")
    else:
        set_version(words.root, words.version)


if __name__ == "__main__":
    main()
