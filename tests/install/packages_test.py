#!/usr/bin/env python3
"""Makes a build's packages, checks them, unpacks them into a folder and uses them there.

    tests/install/packages_test.py BUILD

clean_root_test.py beside it installs them into a bare Debian.
"""

import os
import pathlib
import re
import shutil
import socket
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from packages import ROOT, packages_of, prepare_use, require, skip, told  # noqa: E402

# Lintian's findings that stay, and why.
EXCEPTIONS = {
    "initial-upload-closes-no-bugs": "nobody has asked Debian for these packages",
    "pkg-config-unavailable-for-cross-compilation": "libraries lie in /usr/lib, as in the archive, which runs "
                                                    "from any folder",
}


def check_lintian(debs):
    if not shutil.which("lintian"):
        print("lintian is not here, so it does not check the packages.")
        return
    done = subprocess.run(["lintian", "--tag-display-limit", "0", "--suppress-tags", ",".join(EXCEPTIONS), *debs],
                          capture_output=True, text=True)
    found = re.findall(r"^[EW]: .*", done.stdout, re.M)
    require(not found, "lintian finds:\n" + "\n".join(found))
    require(done.returncode == 0, f"lintian fails:\n{done.stdout}{done.stderr}")


def check_no_traces(folder):
    """No file may name this machine, or where the packages were built."""
    traces = [word.encode() for word in (str(ROOT) + "/", socket.gethostname()) if len(word) > 6]
    for path in folder.rglob("*"):
        if path.is_file():
            held = [word.decode() for word in traces if word in path.read_bytes()]
            require(not held, f"{path.relative_to(folder)} names {held}.")


def check_archive(archive, folder):
    """The archive runs from any folder."""
    told("tar", "-xf", archive, "-C", folder)
    prefix = next(folder.glob("edgeshade-*"))
    require(told(prefix / "bin/edgeshade", "--version").startswith("edgeshade "), "The archive's program says no version.")
    check_no_traces(prefix)
    told("bash", prepare_use(folder / "use archive") / "use_packages.sh", prefix, folder / "use archive")


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    for tool in ("dpkg-shlibdeps", "dpkg", "man"):
        if not shutil.which(tool):
            skip(f"{tool} is not here; Debian's packages dpkg-dev and man-db have it.")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        debs, archive = packages_of(build, folder / "packages")
        check_lintian(debs)
        root = folder / "root"
        for deb in debs:
            told("dpkg", "-x", deb, root)
        check_no_traces(root)
        told("bash", prepare_use(folder / "use") / "use_packages.sh", root / "usr", folder / "use", env=os.environ)
        (folder / "moved").mkdir()
        check_archive(archive, folder / "moved")
    print("Packed, checked, unpacked and used.")


if __name__ == "__main__":
    main()
