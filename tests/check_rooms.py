#!/usr/bin/env python3
"""Checks and draws the includes between folders.

    tests/check_rooms.py            fails where an include points up the list of rooms, where headers
                                    include each other in a circle, where a room sees GL, JSON or
                                    tinygltf although it must not, or where two headers define a type
                                    of the same name in the same namespace
    tests/check_rooms.py --draw     redraws docs/figures/rooms.svg
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
DRAWING = ROOT / "docs/figures/rooms.svg"

# In order: a room may include those before it.
ROOMS = (
    "preprocess/base", "src/sun", "preprocess/scene", "preprocess/mesh", "preprocess/section", "preprocess/volumes/published",
    "preprocess/volumes",
    "src/shadow/geometry", "src/shadow/lights", "src/shadow/silhouette", "src/shadow/layers", "src/shadow/view",
    "src/shadow/primitive_map", "src/shadow/plan", "src/shadow/irregular", "src/rays", "src/policy", "src/settings",
    "preprocess/gltf", "preprocess/reading", "preprocess/packing",
    "src/image", "src/hours", "src/hours/surfaces", "src/city", "src/environment", "src/gl", "src/scene", "src/render/drawing", "src/render/timing", "src/render/technique",
    "src/render/shadow_map", "src/render/lookup", "src/render/volumes", "src/render/irregular", "src/render/frame", "src/render/accumulation",
    "src/engine", "src/rivals/published", "src/rivals/brute_force", "src/rivals/planar", "src/rivals/maps", "src/rivals", "src/lab", "src/bench", "src/rivals/synthetic", "src/plot",
    "src/viewer", "src/desktop", "src/cli", "web")

# Libraries' headers, by the start of their names, and the rooms that may include them.
GL = ("GLES2/", "EGL/", "GLFW/", "emscripten")
JSON = ("nlohmann/", "tiny_gltf.h")
PURE = ROOMS[:ROOMS.index("preprocess/gltf")]                      # neither GL nor JSON
NO_GL = ROOMS[:ROOMS.index("src/environment")]
# Nor do these see JSON: drawing and judging never read files.
NO_FILES = PURE + ("src/gl",) + tuple(
    room for room in ROOMS if room.startswith(("src/render/", "src/rivals", "src/lab", "src/bench", "src/plot")))

# Only the sources of two rooms include tinygltf, and of headers only one.
TINYGLTF = "tiny_gltf.h"
SEES_TINYGLTF = ("preprocess/gltf", "preprocess/reading")
TINYGLTF_HEADER = "preprocess/gltf/tinygltf_model.hpp"

INCLUDE = re.compile(r'^\s*#include\s+(?:"([^"]+)"|<([^>]+)>)', re.M)

# Starts of lines, as clang-format sets them.
NAMESPACE = re.compile(r"namespace ([\w:]+) \{|(\} // namespace)")
TYPE = re.compile(r"(?:template <.*>\s*)?(?:struct|class|enum class|union) (\w+)(?: final)?(?: :[^;]*)? \{")


def sources():
    for top in ("preprocess", "src", "web"):
        for path in sorted((ROOT / top).rglob("*.[ch]pp")):
            if "node_modules" not in path.parts:
                yield path.relative_to(ROOT).as_posix()


def room_of(path):
    folder = path.rsplit("/", 1)[0]
    return folder if folder in ROOMS else None


def read(paths):
    """path -> (own headers, libraries' headers)."""
    read_of = {}
    for path in paths:
        found = INCLUDE.findall((ROOT / path).read_text())
        read_of[path] = ([own for own, _ in found if own], [lib for _, lib in found if lib])
    return read_of


def reach(path, includes, seen=None):
    """All of the project's headers that a file includes, itself included."""
    seen = set() if seen is None else seen
    if path in seen:
        return seen
    seen.add(path)
    for own in includes.get(path, ((), ()))[0]:
        reach(own, includes, seen)
    return seen


def circles(includes):
    """Finds headers, and modules (header and source), that include each other."""
    module = {path: path.rsplit(".", 1)[0] for path in includes}
    after = {}
    for path, (own, _) in includes.items():
        after.setdefault(module[path], set()).update(
            module[o] for o in own if o in module and module[o] != module[path])
    state, found = {}, []

    def visit(name, way):
        state[name] = 1
        for following in sorted(after.get(name, ())):
            if state.get(following) == 1:
                found.append(way[way.index(following):] + [following])
            elif following not in state:
                visit(following, way + [following])
        state[name] = 2

    sys.setrecursionlimit(10000)
    for name in sorted(after):
        if name not in state:
            visit(name, [name])
    return found


def types_of(path):
    """The types that a header defines in namespaces, by their whole names."""
    within, found = [], set()
    for line in (ROOT / path).read_text().splitlines():
        if space := NAMESPACE.match(line):
            within = within + [space[1]] if space[1] else within[:-1]
        elif defined := TYPE.match(line):
            found.add("::".join(within + [defined[1]]))
    return found


def types_twice(paths):
    """Two such types break the rule of one definition: linkers keep one of their functions."""
    where = {}
    for path in paths:
        if path.endswith(".hpp"):
            for name in types_of(path):
                where.setdefault(name, []).append(path)
    return [(name, paths) for name, paths in sorted(where.items()) if len(paths) > 1]


def faults(includes):
    for path in includes:
        if room_of(path) is None and path.startswith(("preprocess/", "src/")):
            yield f"{path} is in no room; tests/check_rooms.py lists them."
    for path, (own, _) in includes.items():
        here = room_of(path)
        for header in own:
            there = room_of(header)
            if here and there and ROOMS.index(there) > ROOMS.index(here):
                yield f"{path} includes {header}, which points up from {here} to {there}."
    for name, paths in types_twice(includes):
        yield f"{name} is defined in {' and in '.join(paths)}."
    for circle in circles(includes):
        yield "these modules include each other in a circle: " + " -> ".join(circle) + "."
    for path in includes:
        here = room_of(path)
        if here is None:
            continue
        for header in reach(path, includes):
            for library in includes.get(header, ((), ()))[1]:
                way = f"{path} sees <{library}>" + ("" if header == path else f" by {header}")
                if here in NO_GL and library.startswith(GL):
                    yield way + f"; {here} knows nothing of GL."
                if here in NO_FILES and library.startswith(JSON):
                    yield way + f"; {here} knows nothing of files."
                if library == TINYGLTF and here not in SEES_TINYGLTF:
                    yield way + f"; only {' and '.join(SEES_TINYGLTF)} do."
                elif library == TINYGLTF and path.endswith(".hpp") and path != TINYGLTF_HEADER:
                    yield way + f"; of headers only {TINYGLTF_HEADER} does."


def drawing(includes):
    arrows = {}
    for path, (own, _) in includes.items():
        for header in own:
            pair = (room_of(path), room_of(header))
            if None not in pair and pair[0] != pair[1]:
                arrows[pair] = arrows.get(pair, 0) + 1
    modules = {room: len({p.rsplit(".", 1)[0] for p in includes if room_of(p) == room})
               for room in ROOMS}
    step, left, width, height = 34, 235, 230, 24
    total = step * len(ROOMS) + 20
    place = {room: total - 20 - step * (i + 1) + 10 for i, room in enumerate(ROOMS)}
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 700 {total}" '
           'font-family="sans-serif" font-size="13">',
           '<rect width="700" height="100%" fill="#ffffff"/>']
    for (above, below), count in sorted(arrows.items()):
        y1, y2 = place[above] + height / 2, place[below] + height / 2
        right = ROOMS.index(above) % 2 == 0
        bulge = 14 + abs(y2 - y1) * 0.28
        x = left + width if right else left
        bend = x + bulge if right else x - bulge
        out.append(f'<path d="M{x},{y1:.0f} C{bend:.0f},{y1:.0f} {bend:.0f},{y2:.0f} {x},{y2:.0f}" '
                   f'fill="none" stroke="#4a6fa5" stroke-opacity="0.45" '
                   f'stroke-width="{min(1 + count / 8, 4):.1f}"/>')
        out.append(f'<circle cx="{x}" cy="{y2:.0f}" r="2.5" fill="#4a6fa5"/>')
    for room in ROOMS:
        pure = room in PURE
        out.append(f'<rect x="{left}" y="{place[room]}" width="{width}" height="{height}" rx="4" '
                   f'fill="{"#e8f3e8" if pure else "#f4f0e6" if room in NO_GL else "#e9eef7"}" '
                   'stroke="#555"/>')
        out.append(f'<text x="{left + 8}" y="{place[room] + 17}">{room}</text>')
        out.append(f'<text x="{left + width - 8}" y="{place[room] + 17}" text-anchor="end" '
                   f'fill="#777">{modules[room]}</text>')
    return "\n".join(out + ["</svg>", ""])


def main():
    includes = read(sources())
    if "--draw" in sys.argv[1:]:
        DRAWING.write_text(drawing(includes))
        return 0
    found = sorted(set(faults(includes)))
    if not DRAWING.exists() or DRAWING.read_text() != drawing(includes):
        found.append("docs/figures/rooms.svg is not what tests/check_rooms.py --draw makes.")
    print("\n".join(found) if found else f"{len(includes)} sources, {len(ROOMS)} rooms: in order")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
