#!/usr/bin/env python3
"""Installs a build's Debian packages into a bare Debian of the same release, made by debootstrap, and uses them there
with no other tools than those that Debian has.

    tests/install/clean_root_test.py BUILD

Takes minutes and about 1.5 GB, and is skipped without root, debootstrap or a Debian mirror. The environment variable
EDGESHADE_MIRROR names another mirror than deb.debian.org.
"""

import os
import pathlib
import platform
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from packages import packages_of, prepare_use, skip, told  # noqa: E402

MIRROR = os.environ.get("EDGESHADE_MIRROR", "http://deb.debian.org/debian")
TOOLS = ("g++", "cmake", "make", "man-db", "bash-completion")
# Found by completion's own loader, as in a shell.
LOADED = "source /usr/share/bash-completion/bash_completion; _completion_loader edgeshade; complete -p edgeshade"


def codename():
    system = platform.freedesktop_os_release()
    if system.get("ID") != "debian" or "VERSION_CODENAME" not in system:
        skip("this system is not Debian, whose releases have the packages' libraries.")
    return system["VERSION_CODENAME"]


def bare_root(folder):
    done = subprocess.run(["debootstrap", "--variant=minbase", codename(), folder, MIRROR], capture_output=True, text=True)
    if done.returncode:
        reason = (done.stdout + done.stderr).strip().splitlines()
        skip(f"debootstrap makes no root here: {reason[-1] if reason else 'it says nothing'}")


def inside(root, *words):
    clean = {"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "LC_ALL": "C", "HOME": "/root", "DEBIAN_FRONTEND": "noninteractive"}
    return told("chroot", root, *words, env=clean)


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    if os.geteuid():
        skip("only root can make and enter a clean root.")
    if not shutil.which("debootstrap"):
        skip("debootstrap is not here; Debian's package of that name has it.")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        root = folder / "root"
        bare_root(root)
        debs, _ = packages_of(build, folder / "packages")
        for deb in debs:
            shutil.copy(deb, root / "tmp")
        prepare_use(root / "tmp/use")
        inside(root, "apt-get", "update", "-qq")
        inside(root, "apt-get", "install", "-y", "-qq", *TOOLS, *(f"/tmp/{deb.name}" for deb in debs))
        print(inside(root, "bash", "/tmp/use/use_packages.sh", "/usr", "/tmp/use").strip())
        if "_edgeshade" not in inside(root, "bash", "-c", LOADED):
            sys.exit("bash-completion does not load the program's completion.")
        inside(root, "apt-get", "purge", "-y", "-qq", "edgeshade", "libedgeshade-dev")
        left = [path for path in (root / "usr").rglob("*edgeshade*")]
        if left:
            sys.exit(f"Purging leaves {left[0].relative_to(root)}.")
    print("Installed in a bare Debian, used and purged.")


if __name__ == "__main__":
    main()
