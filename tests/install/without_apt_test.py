#!/usr/bin/env python3
"""Calls ./run where there is neither apt-get nor CMake: it lists all packages that it takes, and ends with a sentence.

    tests/install/without_apt_test.py
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def main():
    wanted = re.search(r"build_packages=\(([^)]*)\)", (ROOT / "cmake/packages.sh").read_text()).group(1).split()
    with tempfile.TemporaryDirectory() as folder:
        for tool in ("bash", "dirname"):
            (pathlib.Path(folder) / tool).symlink_to(shutil.which(tool))
        done = subprocess.run([ROOT / "run", "view"], env={"PATH": folder}, capture_output=True, text=True)
    listed = re.findall(r"^ +(\S+)$", done.stderr, re.M)
    if listed != wanted:
        sys.exit(f"Not the packages that it takes: {done.stderr}")
    if done.returncode != 1 or "CMake is missing" not in done.stderr.splitlines()[-1]:
        sys.exit(f"It ends with status {done.returncode}: {done.stderr}")
    print(f"{len(listed)} packages are listed.")


if __name__ == "__main__":
    main()
