#!/usr/bin/env python3
"""Cost and accuracy of shadows on see-through surfaces and of shadows from leaves, on models in
../shared/scenes and on the shipped scene: the tables of docs/measured/see-through.md.

    tests/bench/see_through.py           measures, then the tables
    tests/bench/see_through.py --table   the tables from the stored results

EDGESHADE names the program.
"""

import json
import pathlib
import struct
import tempfile

from edgeshade_runs import ROOT, SCENES, figure, percent, replace_between, report, results_of

PAVILION = ROOT / "assets" / "pavilion.glb"
BLENDED = {"car": SCENES / "car.draco.glb", "city": SCENES / "city.draco.glb",
           "oak tree": SCENES / "oaktree.glb"}
LEAVES = {"banana tree": SCENES / "looks" / "bananatree.glb", "pavilion": PAVILION}
VIEWS, SIZE, FRAMES = 8, "960x540", 8
COUNTS = ("visible_pixels", "wrong_mask_pixels", "wrong_mask_beyond_1px", "wrong_image_beyond_1px_not_tied")


def changed(path, folder, change):
    """A copy of a GLB with change(material) applied to its materials."""
    data = path.read_bytes()
    length = struct.unpack("<I", data[12:16])[0]
    gltf = json.loads(data[20:20 + length])
    for material in gltf["materials"]:
        if material.get("alphaMode") == "BLEND":
            change(material)
    gltf["extensionsUsed"] = sorted({*gltf.get("extensionsUsed", []), "KHR_materials_unlit"})
    text = json.dumps(gltf).encode()
    text += b" " * (-len(text) % 4)
    rest = data[20 + length:]
    copy = pathlib.Path(folder) / path.name
    copy.write_bytes(data[:8] + struct.pack("<III", 20 + len(text) + len(rest), len(text), 0x4E4F534A)
                     + text + rest)
    return copy


def receivers_alone(material):
    """Turns a see-through material into one that the oracle sees: it receives shadows, and casts none."""
    material.update(alphaMode="MASK", alphaCutoff=0.0)


def unlit(material):
    material["extensions"] = {"KHR_materials_unlit": {}}


def errors(path, *words):
    told = report("compare", path, "--views", VIEWS, "--size", SIZE, *words)
    return [{key: of[key] for key in COUNTS} | {"lights": of["lights"]}
            for of in told.get("results", [told])]


def frame(path, *words):
    told = report("bench", path, "--size", SIZE, "--frames", FRAMES, "--timing", "processor", *words)
    return {"median": told["frame_ms"]["median"], "lights": told["lights"]}


def blended(path):
    with tempfile.TemporaryDirectory() as folder:
        looked_up, counted = errors(changed(path, folder, receivers_alone), "--shadows", "primitive-map",
                                    "--against", "shadows=volumes")
        full = ("--shading", "full")
        return {"looked_up": looked_up, "counted": counted, "shaded": frame(path, *full),
                "mapped": frame(path, *full, "--shadows", "primitive-map"),
                "unlit": frame(changed(path, folder, unlit), *full)}


def leaves(path):
    ground = ("--ground", "catcher", "--cast-cutouts")
    looked_up, none, mapped = errors(path, *ground, "--shadows", "primitive-map", "--against",
                                     "shadows=volumes", "--against", "shadows=map,map-size=2048")
    frames = {way: frame(path, "--ground", "catcher", *words) for way, words in {
        "looked_up": ("--cast-cutouts", "--shadows", "primitive-map"),
        "none": ("--shadows", "primitive-map"), "whole": ("--cast-masked",),
        "map": ("--cast-cutouts", "--shadows", "map")}.items()}
    return {"looked_up": looked_up, "none": none, "map": mapped, "frames": frames}


def measured():
    return {"blended": {name: blended(path) for name, path in BLENDED.items()},
            "leaves": {name: leaves(path) for name, path in LEAVES.items()}}


def wrong(of):
    share = lambda key: figure(percent(of[key], of["visible_pixels"]))  # noqa: E731
    return f"{share('wrong_mask_pixels')} | {share('wrong_mask_beyond_1px')} | {of['wrong_image_beyond_1px_not_tied']}"


def head(*cells):
    return "| " + " | ".join(cells) + " |\n|" + " --- |" * len(cells)


def blended_table(scenes):
    lines = [head("scene", "looked up: wrong %", "beyond 1 px", "not tied", "counted: wrong %",
                  "beyond 1 px", "not tied", "frame, unlit", "lit / unlit", "map built in, ms", "MB")]
    for name, of in scenes.items():
        base = of["unlit"]["median"]
        light = of["mapped"]["lights"][0]
        lines.append(f"| {name} | {wrong(of['looked_up'])} | {wrong(of['counted'])} | {base:.0f} ms | "
                     f"{of['shaded']['median'] / base:.2f} | {light['build_ms']:.0f} | "
                     f"{light['bytes'] / 1e6:.1f} |")
    return "\n".join(lines)


def leaves_table(scenes):
    lines = [head("scene", "leaves cast", "wrong %", "beyond 1 px", "not tied", "frame, ms")]
    ways = {"looked_up": "cut out, primitive map", "map": "cut out, shadow map 2048",
            "none": "no, primitive map", "whole": "whole triangles, volumes"}
    for name, of in scenes.items():
        for way, words in ways.items():
            errors_of = wrong(of[way]) if way in of else ' |  | '
            lines.append(f"| {name} | {words} | {errors_of} | {of['frames'][way]['median']:.1f} |")
    return "\n".join(lines)


if __name__ == "__main__":
    results = results_of("see_through", measured)
    told = (f"{results['machine']['cores']} cores of {results['machine']['processor']}, "
            f"{results['machine']['date']}, software renderer, {SIZE}.\n\n")
    document = "docs/measured/see-through.md"
    replace_between(document, "blended", told + blended_table(results["scenes"]["blended"]))
    replace_between(document, "leaves", told + leaves_table(results["scenes"]["leaves"]))
