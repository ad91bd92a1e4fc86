"""Models, with lights, on which the scripts here compare methods."""

import sys
import tempfile

from edgeshade_runs import ROOT, SCENES, report

MODELS = {"pavilion": ROOT / "assets" / "pavilion.glb"}
MODELS |= {name: SCENES / file for name, file in {
    "bunny": "bunny.draco.glb", "car": "car.draco.glb", "city": "city.draco.glb", "duck": "duck.glb",
    "engine": "engine.glb", "garden": "garden.draco.glb", "hospital": "hospital-electrical.glb",
    "oaktree": "oaktree.glb", "temple": "temple.glb", "truck": "truck.draco.glb"}.items()}
LAMP_SHARE = 0.02  # the lamp's radius as a share of the scene's diagonal
SUN = ("--sun", "1,2,0.5", "--sun-angle", "2")


def camera_of(path):
    """The default camera of a scene."""
    with tempfile.TemporaryDirectory() as folder:
        return report("render", path, f"{folder}/x.png", "--size", "32x18")["camera"]


def middle_and_diagonal(path):
    return camera_of(path)["to"], report("info", path)["diagonal"]


def lights_for(path):
    """A lamp above the scene and to its side, and a sun; the last two arguments give each an
    extent."""
    middle, diagonal = middle_and_diagonal(path)
    at = [m + diagonal * share for m, share in zip(middle, (0.3, 0.6, 0.2))]
    return {"lamp": ("--light", ",".join(f"{x:.6g}" for x in at), "--light-radius",
                     f"{LAMP_SHARE * diagonal:.6g}"), "sun": SUN}


def lit_models(kept=()):
    """Each model under a sun and under a lamp, without extents: (name of the pair, path, light, its
    arguments). Skips pairs whose names are in `kept`."""
    for name, path in MODELS.items():
        kinds = [kind for kind in ("sun", "lamp") if f"{name}, {kind}" not in kept]
        lights = lights_for(path) if kinds else {}
        for kind in kinds:
            print(name, kind, file=sys.stderr)
            yield f"{name}, {kind}", path, kind, lights[kind][:2]
