"""Helpers of the tests of packages: they make the packages of a build, and what is needed to use them."""

import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT / "tests/bench"))
from culling import box, floor, glb  # noqa: E402

SKIPPED = 77  # CTest's status of a skipped test


def skip(sentence):
    print(f"Skipped: {sentence}")
    sys.exit(SKIPPED)


def told(*words, **options):
    """A command's output. Ends the test with all of it if it fails."""
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, **options)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, words))} failed:\n{done.stdout}{done.stderr}")
    return done.stdout


def require(holds, sentence):
    if not holds:
        sys.exit(sentence)


def packages_of(build, folder):
    """(Debian packages, archive) of a build, made in `folder`."""
    told("cpack", "-B", folder, "--config", build / "CPackConfig.cmake")
    debs, archives = sorted(folder.glob("*.deb")), sorted(folder.glob("*.tar.gz"))
    require(len(debs) == 2 and len(archives) == 1, f"cpack makes {[path.name for path in debs + archives]}.")
    return debs, archives[0]


def prepare_use(folder):
    """The scene and the foreign project that use_packages.sh needs."""
    folder.mkdir(parents=True)
    glb(folder / "scene.glb", [], floor(4, 0) + box([-0.5, 0.5, -0.5], [0.5, 1.5, 0.5]))
    shutil.copytree(HERE / "consumer", folder / "consumer")
    shutil.copy(HERE / "use_packages.sh", folder)
    return folder
