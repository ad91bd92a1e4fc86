#!/usr/bin/env python3
"""Build the edgeshade sample scene, a small garden pavilion, as a binary glTF.

    python3 make_pavilion.py pavilion_raw.glb

Only the Python standard library is used, and the output is deterministic.
The scene was modelled for this project, in this file, and is covered by the
repository's MIT licence.  Nothing in it is taken from elsewhere; the two
textures are computed below.

What stands in it (metres, +Y up, lawn at y = 0, front towards +Z):

* a raised terrace paved with separate slabs, steps, stepping stones;
* eight turned columns carrying beams, rafters and a roof of battens;
* railings of thin balusters, two battened trellises, a hanging lantern;
* two stair flanks, the right one being the left one mirrored (scale -1);
* a round table, three spindle chairs, a bench, a bicycle with spoked wheels;
* potted plants and topiary, ivy on alpha-masked cards, boulders that are one
  mesh under different non-uniform scales;
* a sail canopy, mudguards, leaves and mill blades as open single sheets;
* a sundial whose gnomon has a T section, so one edge has three faces;
* a wind pump whose rotor turns once in eight seconds (animation "wind").

Closed parts are watertight with outward counter-clockwise faces.  Solids that
touch are sunk into each other a little, so no two faces lie in one plane.
Colours in MATERIALS are linear, as glTF asks for factors.
"""

import json
import math
import random
import struct
import sys
import zlib

TAU = 2.0 * math.pi

TERRACE_X = 4.20                    # half width
TERRACE_Z = (-3.55, 2.35)           # back, front
TERRACE_Y = 0.45                    # walking level
COLUMN_X = (-3.0, -1.25, 1.25, 3.0)
COLUMN_Z = (-2.4, 1.6)
COLUMN_H = 2.55
BEAM_Y = TERRACE_Y + COLUMN_H       # underside of the beams
LANTERN = (0.0, 2.20, -0.40)        # centre of the lantern cage


# --------------------------------------------------------------------------
# Vectors and rigid transforms
# --------------------------------------------------------------------------

def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def mul(a, s):
    return (a[0] * s, a[1] * s, a[2] * s)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1],
            a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0])


def unit(a):
    return mul(a, 1.0 / math.sqrt(dot(a, a)))


def perpendicular(a):
    """Some unit vector at right angles to the unit vector a."""
    axis = (0.0, 1.0, 0.0) if abs(a[1]) < 0.9 else (1.0, 0.0, 0.0)
    return unit(cross(axis, a))


def quat(axis, degrees):
    """Rotation quaternion (x, y, z, w)."""
    half = math.radians(degrees) / 2.0
    return mul(unit(axis), math.sin(half)) + (math.cos(half),)


def rotate(q, v):
    """Turn the vector v by the quaternion q."""
    axis = q[:3]
    t = mul(cross(axis, v), 2.0)
    return add(add(v, mul(t, q[3])), cross(axis, t))


# --------------------------------------------------------------------------
# Shapes: positions, normals, texture coordinates and triangles
# --------------------------------------------------------------------------

class Shape:
    """A list of vertices (position, normal, uv) and of index triples."""

    def __init__(self):
        self.vertices = []
        self.triangles = []

    def vertex(self, position, normal, uv=None):
        if uv is None:                       # planar mapping, for round wood
            uv = (position[0] / 1.2, position[2] / 0.3)
        self.vertices.append((position, normal, uv))
        return len(self.vertices) - 1

    def quad(self, a, b, c, d):
        self.triangles += [(a, b, c), (a, c, d)]

    def fan(self, points, normal, uvs=None):
        """A flat convex polygon, counter-clockwise about its normal."""
        uvs = uvs or [None] * len(points)
        ids = [self.vertex(p, normal, uv) for p, uv in zip(points, uvs)]
        self.triangles += [(ids[0], ids[i], ids[i + 1])
                           for i in range(1, len(ids) - 1)]

    def extend(self, other):
        base = len(self.vertices)
        self.vertices += other.vertices
        self.triangles += [tuple(base + i for i in t) for t in other.triangles]
        return self

    def moved(self, offset=(0.0, 0.0, 0.0), turn=(0.0, 0.0, 0.0, 1.0)):
        """A copy, turned by a quaternion and then shifted."""
        out = Shape()
        out.triangles = list(self.triangles)
        out.vertices = [(add(rotate(turn, p), offset), rotate(turn, n), uv)
                        for p, n, uv in self.vertices]
        return out


def flat(shape):
    """The same triangles with one normal per face."""
    out = Shape()
    for tri in shape.triangles:
        a, b, c = (shape.vertices[i][0] for i in tri)
        normal = unit(cross(sub(b, a), sub(c, a)))
        out.fan([a, b, c], normal, [shape.vertices[i][2] for i in tri])
    return out


def smooth(points, triangles, uvs=None):
    """A shape from shared points, normals averaged over the faces."""
    sums = [(0.0, 0.0, 0.0)] * len(points)
    for tri in triangles:
        a, b, c = (points[i] for i in tri)
        normal = cross(sub(b, a), sub(c, a))
        for i in tri:
            sums[i] = add(sums[i], normal)
    out = Shape()
    for i, point in enumerate(points):
        out.vertex(point, unit(sums[i]), uvs[i] if uvs else None)
    out.triangles = list(triangles)
    return out


def grid(rows):
    """An open smooth sheet through rows of points (equal lengths)."""
    width = len(rows[0])
    triangles = []
    for j in range(len(rows) - 1):
        for i in range(width - 1):
            a = j * width + i
            b, c, d = a + 1, a + width + 1, a + width
            triangles += [(a, b, c), (a, c, d)]
    return smooth([p for row in rows for p in row], triangles)


def box(low, high):
    """A closed box; the grain of a texture follows its longest side."""
    size = sub(high, low)
    longest = max(range(3), key=lambda i: size[i])
    out = Shape()
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        along, over = (v, u) if v == longest else (u, v)
        for side in (0, 1):
            corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
            if side == 0:
                corners.reverse()
            points = []
            for cu, cv in corners:
                p = [0.0, 0.0, 0.0]
                p[axis] = (low, high)[side][axis]
                p[u] = (low, high)[cu][u]
                p[v] = (low, high)[cv][v]
                points.append(tuple(p))
            normal = [0.0, 0.0, 0.0]
            normal[axis] = 1.0 if side else -1.0
            # a phase per box, so that neighbours do not look alike
            phase = 0.37 * low[0] + 0.61 * low[1] + 1.13 * low[2] + 0.19 * axis
            uvs = [(p[along] / 1.2 + phase, p[over] / 0.3 + phase)
                   for p in points]
            out.fan(points, tuple(normal), uvs)
    return out


def block(centre, size):
    """A box by its centre and size."""
    half = mul(size, 0.5)
    return box(sub(centre, half), add(centre, half))


def bar(start, end, width, height, up=(0.0, 1.0, 0.0)):
    """A closed box-section bar between two points."""
    along = sub(end, start)
    length = math.sqrt(dot(along, along))
    x = unit(along)
    z = unit(cross(x, up))
    y = cross(z, x)
    out = Shape()
    straight = box((0.0, -height / 2, -width / 2),
                   (length, height / 2, width / 2))

    def turn(v):
        return add(add(mul(x, v[0]), mul(y, v[1])), mul(z, v[2]))

    out.vertices = [(add(start, turn(p)), turn(n), uv)
                    for p, n, uv in straight.vertices]
    out.triangles = straight.triangles
    return out


def prism(outline, depth):
    """A convex outline in the XY plane (counter-clockwise), pushed along +Z."""
    out = Shape()
    front = [(x, y, depth) for x, y in outline]
    back = [(x, y, 0.0) for x, y in outline]

    def wood(points):
        return [(p[0] / 1.2, (p[1] + p[2]) / 0.3) for p in points]

    out.fan(front, (0.0, 0.0, 1.0), wood(front))
    out.fan(back[::-1], (0.0, 0.0, -1.0), wood(back[::-1]))
    for i in range(len(outline)):
        j = (i + 1) % len(outline)
        points = [back[i], back[j], front[j], front[i]]
        normal = unit((outline[j][1] - outline[i][1],
                       outline[i][0] - outline[j][0], 0.0))
        out.fan(points, normal, wood(points))
    return out


def lathe(profile, sides):
    """Turn a profile about the Y axis.

    The profile is a list of runs of (radius, height) points, going from the
    bottom up along the outside; normals are smooth inside a run and sharp
    between runs.  It is closed when it starts and ends on the axis.
    """
    out = Shape()
    ring = [(math.cos(TAU * k / sides), math.sin(TAU * k / sides))
            for k in range(sides)]
    for run in profile:
        normals = run_normals(run)
        rows = []
        for (r, y), (nr, ny) in zip(run, normals):
            if r == 0.0:
                rows.append([out.vertex((0.0, y, 0.0),
                                        (0.0, math.copysign(1.0, ny), 0.0))])
            else:
                rows.append([out.vertex((r * c, y, r * s), (nr * c, ny, nr * s))
                             for c, s in ring])
        for low, high in zip(rows, rows[1:]):
            for k in range(sides):
                m = (k + 1) % sides
                if len(low) == 1:
                    out.triangles.append((low[0], high[k], high[m]))
                elif len(high) == 1:
                    out.triangles.append((low[k], high[0], low[m]))
                else:
                    out.quad(low[k], high[k], high[m], low[m])
    return out


def run_normals(run):
    """Averaged outward (radial, vertical) normals along one profile run."""
    edges = []
    for (r0, y0), (r1, y1) in zip(run, run[1:]):
        length = math.hypot(r1 - r0, y1 - y0)
        edges.append(((y1 - y0) / length, (r0 - r1) / length))
    normals = []
    for i in range(len(run)):
        near = edges[max(i - 1, 0):i + 1]
        nr, ny = sum(e[0] for e in near), sum(e[1] for e in near)
        length = math.hypot(nr, ny)
        normals.append((nr / length, ny / length))
    return normals


def bulge(radius, low, high, out, steps):
    """Profile points of a rounded ring standing `out` proud of a radius."""
    middle, half = (low + high) / 2, (high - low) / 2
    angles = [-math.pi / 2 + math.pi * k / steps for k in range(steps + 1)]
    points = [(radius + out * math.cos(a), middle + half * math.sin(a))
              for a in angles]
    points[0], points[-1] = (radius, low), (radius, high)
    return points


def turned(runs, sides):
    """A lathe of outside runs, with flat caps added at both ends."""
    bottom, top = runs[0][0], runs[-1][-1]
    return lathe([[(0.0, bottom[1]), bottom]] + runs + [[top, (0.0, top[1])]],
                 sides)


def drum(radius, low, high, sides):
    return turned([[(radius, low), (radius, high)]], sides)


def ellipsoid(rx, ry, rz, sides, rings):
    """A closed ellipsoid round the origin."""
    run = [(math.sin(math.pi * k / rings), -math.cos(math.pi * k / rings))
           for k in range(rings + 1)]
    run[0], run[-1] = (0.0, -1.0), (0.0, 1.0)
    ball = lathe([run], sides)
    ball.vertices = [((p[0] * rx, p[1] * ry, p[2] * rz),
                      unit((p[0] / rx, p[1] / ry, p[2] / rz)), uv)
                     for p, _, uv in ball.vertices]
    return ball


def tube(path, radius, sides=6, closed=False):
    """A round tube along a path, capped unless the path is closed.

    `radius` is one number or one per point.
    """
    count = len(path)
    radii = radius if isinstance(radius, (list, tuple)) else [radius] * count
    out = Shape()
    normal = None
    rings, tangents = [], []
    for i, point in enumerate(path):
        if closed:
            tangent = unit(sub(path[(i + 1) % count], path[i - 1]))
        else:
            tangent = unit(sub(path[min(i + 1, count - 1)],
                               path[max(i - 1, 0)]))
        if normal is None:
            normal = perpendicular(tangent)
        else:
            normal = unit(sub(normal, mul(tangent, dot(normal, tangent))))
        side = cross(tangent, normal)
        ring = []
        for k in range(sides):
            a = TAU * k / sides
            n = add(mul(normal, math.cos(a)), mul(side, math.sin(a)))
            ring.append(out.vertex(add(point, mul(n, radii[i])), n))
        rings.append(ring)
        tangents.append(tangent)
    for i in range(count if closed else count - 1):
        a, b = rings[i], rings[(i + 1) % count]
        for k in range(sides):
            m = (k + 1) % sides
            out.quad(a[k], a[m], b[m], b[k])
    if not closed:
        first = [out.vertices[i][0] for i in rings[0]]
        last = [out.vertices[i][0] for i in rings[-1]]
        out.fan(first[::-1], mul(tangents[0], -1.0))
        out.fan(last, tangents[-1])
    return out


def circle(radius, count, centre=(0.0, 0.0, 0.0)):
    """Points on a circle in the XY plane."""
    return [add(centre, (radius * math.cos(TAU * k / count),
                         radius * math.sin(TAU * k / count), 0.0))
            for k in range(count)]


def icosphere(levels):
    """Points and triangles of a unit geodesic sphere."""
    g = (1.0 + math.sqrt(5.0)) / 2.0
    points = [unit(p) for p in (
        (-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0),
        (0, -1, g), (0, 1, g), (0, -1, -g), (0, 1, -g),
        (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1))]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11),
             (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8),
             (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9),
             (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    for _ in range(levels):
        middles, finer = {}, []

        def middle(i, j):
            key = (min(i, j), max(i, j))
            if key not in middles:
                middles[key] = len(points)
                points.append(unit(add(points[i], points[j])))
            return middles[key]

        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = finer
    return points, faces


# --------------------------------------------------------------------------
# Textures
# --------------------------------------------------------------------------

def png(width, height, channels, pixel):
    """An 8-bit PNG; pixel(x, y) gives a tuple of `channels` values 0..255."""
    rows = b"".join(
        b"\0" + bytes(v for x in range(width) for v in pixel(x, y))
        for y in range(height))

    def chunk(kind, data):
        body = kind + data
        return (struct.pack(">I", len(data)) + body
                + struct.pack(">I", zlib.crc32(body)))

    kind = {3: 2, 4: 6}[channels]
    header = struct.pack(">IIBBBBB", width, height, 8, kind, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
            + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def wood_png(size=128):
    """Wood grain along u; it repeats in both directions."""
    def pixel(x, y):
        u, v = TAU * x / size, TAU * y / size
        bend = v + 0.30 * math.sin(u) + 0.12 * math.sin(2 * u + 1.3)
        grain = (0.45 * math.sin(3 * bend + 0.8 * math.sin(v))
                 + 0.30 * math.sin(8 * bend + 1.1 * math.sin(2 * v + u))
                 + 0.25 * math.sin(19 * v + 0.9 * math.sin(u + 3 * v)))
        tone = round((0.5 + 0.5 * grain) * 15) / 15.0
        dark, light = (138, 106, 76), (192, 159, 122)
        return tuple(round(d + (l - d) * tone) for d, l in zip(dark, light))
    return png(size, size, 3, pixel)


def ivy_png(size=64):
    """One three-lobed leaf, tip up, with alpha; it fits the ivy card."""
    lobes = [(0.50, 0.44, 0.155, 0.44), (0.29, 0.50, 0.225, 0.19),
             (0.71, 0.50, 0.225, 0.19), (0.50, 0.68, 0.205, 0.20)]

    def pixel(x, y):
        u, v = (x + 0.5) / size, (y + 0.5) / size
        inside = any(((u - cx) / rx) ** 2 + ((v - cy) / ry) ** 2 < 1.0
                     for cx, cy, rx, ry in lobes)
        inside = inside or (abs(u - 0.5) < 0.025 and 0.8 < v < 0.99)
        vein = abs(u - 0.5) < 0.016 or abs(
            abs(u - 0.5) - 0.9 * (0.72 - v)) < 0.016 and v < 0.72
        colour = (146, 164, 108) if vein else (94, 122, 72)
        return colour + (255 if inside else 0,)
    return png(size, size, 4, pixel)


# --------------------------------------------------------------------------
# Materials: linear colour, roughness, metallic, and the odd ones out
# --------------------------------------------------------------------------

MATERIALS = {
    "lawn": dict(color=(0.150, 0.205, 0.085), rough=1.0),
    "slab_pale": dict(color=(0.560, 0.520, 0.450), rough=0.9),
    "slab_warm": dict(color=(0.400, 0.300, 0.225), rough=0.9),
    "limestone": dict(color=(0.680, 0.635, 0.550), rough=0.8),
    "basalt": dict(color=(0.155, 0.155, 0.160), rough=0.95),
    "timber": dict(color=(0.900, 0.860, 0.820), rough=0.75, texture="wood"),
    "iron": dict(color=(0.045, 0.050, 0.055), rough=0.5, metal=0.3),
    "terracotta": dict(color=(0.470, 0.180, 0.095), rough=0.85),
    "leaf": dict(color=(0.120, 0.225, 0.090), rough=0.7, sheet=True),
    "canvas": dict(color=(0.760, 0.560, 0.300), rough=0.9, sheet=True),
    "enamel": dict(color=(0.075, 0.210, 0.240), rough=0.4, sheet=True,
                   coat=0.08),
    "brass": dict(color=(0.800, 0.580, 0.280), rough=0.3, metal=1.0,
                  sheet=True),
    "steel": dict(color=(0.620, 0.630, 0.650), rough=0.25, metal=1.0),
    "umber": dict(color=(0.060, 0.042, 0.032), rough=0.95, sheet=True),
    "ivy": dict(color=(0.900, 0.950, 0.850), rough=0.8, sheet=True,
                texture="ivy", cutoff=0.5),
    "glass": dict(color=(0.850, 0.930, 0.960), rough=0.05, alpha=0.15),
    "lamp_glass": dict(color=(1.000, 0.800, 0.450), rough=0.3, alpha=0.70,
                       glow=(1.0, 0.52, 0.14), strength=1.6),
}
TEXTURES = {"wood": wood_png, "ivy": ivy_png}


# --------------------------------------------------------------------------
# The scene: meshes and nodes
# --------------------------------------------------------------------------

class Scene:
    """Meshes ({material: Shape}) and a tree of nodes."""

    def __init__(self):
        self.meshes = []          # (name, {material: Shape})
        self.nodes = []           # glTF node dictionaries
        self.roots = []

    def mesh(self, name, *parts):
        """Register a mesh from (material, shape) parts; gives its index."""
        by_material = {}
        for material, shape in parts:
            by_material.setdefault(material, Shape()).extend(shape)
        self.meshes.append((name, by_material))
        return len(self.meshes) - 1

    def node(self, name, mesh=None, at=None, turn=None, scale=None,
             parent=None):
        """Place a node; gives its index."""
        node = {"name": name}
        if mesh is not None:
            node["mesh"] = mesh
        if at is not None:
            node["translation"] = list(at)
        if turn is not None:
            node["rotation"] = list(turn)
        if scale is not None:
            node["scale"] = list(scale)
        self.nodes.append(node)
        index = len(self.nodes) - 1
        if parent is None:
            self.roots.append(index)
        else:
            self.nodes[parent].setdefault("children", []).append(index)
        return index


def yaw(degrees):
    return quat((0.0, 1.0, 0.0), degrees)


# ---- ground, terrace, steps ----------------------------------------------

def build_ground(scene):
    lawn = box((-6.0, -0.20, -5.0), (6.0, 0.0, 5.0))
    scene.node("lawn", scene.mesh("lawn", ("lawn", lawn)))
    stone = flat(turned([[(0.30, -0.03), (0.30, 0.02), (0.28, 0.035)]], 8))
    stones = Shape()
    for x, z, turn in ((0.06, 3.62, 10), (-0.06, 4.34, 31),
                       (4.66, 1.15, 5), (4.85, 1.85, 29), (4.62, 2.52, 14)):
        stones.extend(stone.moved((x, 0.0, z), yaw(turn)))
    scene.node("stepping_stones",
               scene.mesh("stepping_stones", ("slab_pale", stones)))


def build_terrace(scene):
    z0, z1 = TERRACE_Z
    plinth = box((-TERRACE_X, -0.05, z0), (TERRACE_X, 0.41, z1))
    scene.node("terrace_plinth", scene.mesh("terrace_plinth",
                                            ("basalt", plinth)))
    scene.node("terrace_paving", scene.mesh("terrace_paving",
                                            *paving(z0 + 0.45, z1 - 0.45)))
    scene.node("terrace_coping", scene.mesh("terrace_coping",
                                            ("limestone", coping(z0, z1))))
    scene.node("front_steps", scene.mesh("front_steps",
                                         ("limestone", front_steps())))
    side = box((TERRACE_X - 0.02, -0.05, -1.20),
               (TERRACE_X + 0.42, 0.225, 0.80))
    scene.node("side_step", scene.mesh("side_step", ("limestone", side)))


def slab(x0, z0, x1, z1):
    gap = 0.009
    return box((x0 + gap, 0.39, z0 + gap), (x1 - gap, TERRACE_Y, z1 - gap))


def paving(z0, z1, cell=0.625):
    """A basket weave: whole slabs alternate with pairs of half slabs."""
    whole, halves = Shape(), Shape()
    columns = round(2 * (TERRACE_X - 0.45) / cell)
    rows = round((z1 - z0) / cell)
    for j in range(rows):
        for i in range(columns):
            x, z = -(TERRACE_X - 0.45) + i * cell, z0 + j * cell
            if (i + j) % 2 == 0:
                whole.extend(slab(x, z, x + cell, z + cell))
            elif j % 2 == 0:
                halves.extend(slab(x, z, x + cell / 2, z + cell))
                halves.extend(slab(x + cell / 2, z, x + cell, z + cell))
            else:
                halves.extend(slab(x, z, x + cell, z + cell / 2))
                halves.extend(slab(x, z + cell / 2, x + cell, z + cell))
    return ("slab_warm", whole), ("slab_pale", halves)


def coping(z0, z1):
    """The edge course, which stands a little proud of the plinth."""
    out = Shape()
    width, lip = 0.45, 0.035
    edge = TERRACE_X - width
    for k in range(10):
        x = -edge + k * 2 * edge / 10
        step = 2 * edge / 10
        out.extend(slab(x, z1 - width, x + step, z1 + lip))
        out.extend(slab(x, z0 - lip, x + step, z0 + width))
    for side in (-1, 1):
        x = sorted((side * edge, side * (TERRACE_X + lip)))
        for k in range(7):
            step = (z1 - z0 - 2 * width) / 7
            z = z0 + width + k * step
            out.extend(slab(x[0], z, x[1], z + step))
        out.extend(slab(x[0], z1 - width, x[1], z1 + lip))
        out.extend(slab(x[0], z0 - lip, x[1], z0 + width))
    return out


def front_steps():
    """Two treads with nosings on set-back risers."""
    out = Shape()
    z = TERRACE_Z[1] - 0.02
    for side, rise, run in ((1.35, 0.15, 0.72), (1.37, 0.30, 0.37)):
        out.extend(box((-side, -0.3 * rise, z),
                       (side, rise - 0.03, z + run - 0.03)))
        out.extend(box((-side - 0.01, rise - 0.04, z - 0.005),
                       (side + 0.01, rise, z + run)))
    return out


def build_stair_flanks(scene):
    """One cheek wall with a scrolled handrail, used twice (one mirrored)."""
    outline = [(2.30, -0.05), (3.36, -0.05), (3.36, 0.20), (2.42, 0.56),
               (2.30, 0.56)]
    # prism() works in XY: take X for z, then turn so that it looks along z
    cheek = prism(outline, 0.26).moved((-1.58, 0.0, 0.0), yaw(-90.0))
    cheek = cheek.moved((0.26, 0.0, 0.0))
    rail = [(-1.45, 1.36, 2.22), (-1.45, 1.36, 2.40)]
    rail += [(-1.45, 1.33 - 0.36 * t, 2.50 + 0.94 * t) for t in
             (0.0, 0.25, 0.5, 0.75, 1.0)]
    for k in range(1, 17):                      # the scroll, curling outwards
        a = TAU * 1.35 * k / 16
        r = 0.14 * (1.0 - 0.72 * k / 16)
        rail.append((-1.45 - 0.14 + r * math.cos(a), 0.945,
                     3.47 + r * math.sin(a)))
    iron = tube(rail, [0.024] * (len(rail) - 6)
                + [0.023, 0.022, 0.021, 0.019, 0.017, 0.015], 6)
    for k in range(7):
        z = 2.36 + k * 0.155
        foot = 0.56 if z < 2.42 else 0.56 - (z - 2.42) * 0.36 / 0.94
        head = 1.36 if z < 2.42 else 1.33 - (z - 2.50) * 0.36 / 0.94
        iron.extend(tube([(-1.45, foot - 0.02, z), (-1.45, head, z)],
                         0.010, 6))
    mesh = scene.mesh("stair_flank", ("limestone", cheek), ("iron", iron))
    scene.node("stair_flank_left", mesh)
    scene.node("stair_flank_right", mesh, scale=(-1.0, 1.0, 1.0))


# ---- pavilion ------------------------------------------------------------

def column_mesh(scene):
    shaft = turned([
        bulge(0.160, 0.09, 0.165, 0.034, 3),
        [(0.160, 0.165), (0.152, 0.200)],
        [(0.152, 0.200), (0.140, 0.245), (0.138, 0.90), (0.116, 2.24)],
        bulge(0.116, 2.24, 2.275, 0.016, 2),
        [(0.116, 2.275), (0.114, 2.335)],
        [(0.114, 2.335), (0.158, 2.375), (0.174, 2.46)],
    ], 24)
    plinth = block((0.0, 0.045, 0.0), (0.41, 0.11, 0.41))
    abacus = block((0.0, 2.50, 0.0), (0.40, 0.10, 0.40))
    return scene.mesh("column", ("limestone", shaft), ("limestone", plinth),
                      ("limestone", abacus))


def build_columns(scene):
    mesh = column_mesh(scene)
    for row, z in zip(("back", "front"), COLUMN_Z):
        for k, x in enumerate(COLUMN_X):
            scene.node(f"column_{row}_{k + 1}", mesh, at=(x, TERRACE_Y, z))


def build_roof(scene):
    beams = Shape()
    for z in COLUMN_Z:
        for side in (-0.10, 0.10):
            beams.extend(block((0.0, BEAM_Y + 0.09, z + side),
                               (7.1, 0.20, 0.08)))
    outline = [(-3.35, 0.09), (-3.28, 0.02), (-2.95, 0.0), (2.15, 0.0),
               (2.48, 0.02), (2.55, 0.09), (2.55, 0.18), (-3.35, 0.18)]
    # outline X becomes -z under this turn, hence the mirrored end points
    outline = [(-x, y) for x, y in outline][::-1]
    rafter = prism(outline, 0.09).moved((0.045, 0.0, 0.0), yaw(90.0))
    rafter = rafter.moved((-0.09, 0.0, 0.0))
    rafters = Shape()
    for k in range(9):
        rafters.extend(rafter.moved((-3.2 + 0.8 * k, BEAM_Y + 0.14, 0.0)))
    battens = Shape()
    for k in range(27):
        battens.extend(block((0.0, BEAM_Y + 0.345, -3.0 + 0.20 * k),
                             (7.3, 0.06, 0.05)))
    scene.node("roof_beams", scene.mesh("roof_beams", ("timber", beams)))
    scene.node("roof_rafters", scene.mesh("roof_rafters", ("timber", rafters)))
    scene.node("roof_battens", scene.mesh("roof_battens", ("timber", battens)))


def build_trellises(scene):
    """Diagonal battens in two layers between the outer back columns."""
    x0, x1, y0, y1 = -2.78, -1.47, TERRACE_Y + 0.20, TERRACE_Y + 2.20
    z = COLUMN_Z[0]
    wood = Shape()
    for y in (y0, y1):
        wood.extend(bar((x0 - 0.12, y, z), (x1 + 0.12, y, z), 0.05, 0.06))
    for layer, slope in ((0.013, 1.0), (-0.013, -1.0)):
        c = -(y1 - y0)
        while c < x1 - x0:
            c += 0.235
            # the batten x = x0 + c + t, y = y0 + t, clipped to the frame
            t0, t1 = max(0.0, -c), min(y1 - y0, x1 - x0 - c)
            if t1 - t0 < 0.12:
                continue
            ends = [(x0 + c + t, y0 + t, z + layer) for t in (t0, t1)]
            if slope < 0:
                ends = [(x0 + x1 - p[0], p[1], p[2]) for p in ends]
            wood.extend(bar(ends[0], ends[1], 0.020, 0.028))
    mesh = scene.mesh("trellis", ("timber", wood))
    scene.node("trellis_left", mesh)
    scene.node("trellis_right", mesh, at=(-(x0 + x1), 0.0, 0.0))


def railing_parts(length):
    """Posts with ball finials, two rails and thin balusters, along +X."""
    iron, brass = Shape(), Shape()
    count = max(1, round(length / 2.7))
    for k in range(count + 1):
        x = length * k / count
        iron.extend(block((x, 0.50, 0.0), (0.045, 1.02, 0.045)))
        brass.extend(ellipsoid(0.036, 0.036, 0.036, 8, 5).moved(
            (x, 1.035, 0.0)))
    iron.extend(block((length / 2, 0.95, 0.0), (length, 0.030, 0.055)))
    iron.extend(block((length / 2, 0.12, 0.0), (length, 0.022, 0.030)))
    bars = round(length / 0.155)
    for k in range(1, bars):
        x = length * k / bars
        if min(abs(x - length * m / count) for m in range(count + 1)) < 0.04:
            continue
        iron.extend(tube([(x, 0.115, 0.0), (x, 0.945, 0.0)], 0.009, 5))
    return ("iron", iron), ("brass", brass)


def build_railings(scene):
    x, back, front = TERRACE_X - 0.15, TERRACE_Z[0] + 0.15, TERRACE_Z[1] - 0.15
    y = TERRACE_Y
    short = scene.mesh("railing_front", *railing_parts(x - 1.62))
    scene.node("railing_front_left", short, at=(-x, y, front))
    scene.node("railing_front_right", short, at=(1.62, y, front))
    left = scene.mesh("railing_left", *railing_parts(front - back - 0.1))
    scene.node("railing_left", left, at=(-x, y, front - 0.05), turn=yaw(90.0))
    rear = scene.mesh("railing_back", *railing_parts(2 * x - 0.1))
    scene.node("railing_back", rear, at=(-x + 0.05, y, back))


def build_lantern(scene):
    """An open cage: a point light at LANTERN shines out between the bars."""
    brass, iron = Shape(), Shape()
    for k in range(6):
        a = TAU * k / 6
        c, s = math.cos(a), math.sin(a)
        iron.extend(tube([(0.10 * c, -0.17, 0.10 * s),
                          (0.145 * c, 0.0, 0.145 * s),
                          (0.13 * c, 0.17, 0.13 * s)], 0.006, 5))
    brass.extend(turned([[(0.05, -0.20), (0.108, -0.185), (0.108, -0.165)]],
                        12))
    brass.extend(turned([[(0.155, 0.165), (0.155, 0.180)],
                         [(0.155, 0.180), (0.060, 0.25), (0.015, 0.29)]], 12))
    ring = [(p[0], 0.09, p[1]) for p in circle(0.137, 18)]
    iron.extend(tube(ring, 0.005, 4, closed=True))
    iron.extend(tube([(0.0, 0.28, 0.0), (0.0, BEAM_Y + 0.16 - LANTERN[1],
                                         0.0)], 0.008, 6))
    scene.node("lantern", scene.mesh("lantern", ("brass", brass),
                                     ("iron", iron)), at=LANTERN)
    # See-through surfaces cast no shadow, so the light at LANTERN shines through.
    chimney = lathe([[(0.055, -0.16), (0.085, -0.06), (0.085, 0.04),
                      (0.055, 0.15)]], 20)
    scene.node("lantern_glass", scene.mesh(
        "lantern_glass", ("lamp_glass", chimney)), at=LANTERN)


def build_canopy(scene):
    """A four-cornered sail, two corners up and two down, with hollow edges."""
    corners = {(-1, -1): (3.50, 3.02, -2.45), (1, -1): (5.55, 2.45, -2.90),
               (-1, 1): (3.50, 2.60, 1.70), (1, 1): (5.60, 3.55, 1.60)}
    steps = 14
    rows = []
    for j in range(steps + 1):
        row = []
        for i in range(steps + 1):
            u, v = 2.0 * i / steps - 1.0, 2.0 * j / steps - 1.0
            s = u * (1.0 - 0.16 * (1.0 - v * v))
            t = v * (1.0 - 0.10 * (1.0 - u * u))
            point = (0.0, -0.10 * (1 - u * u) * (1 - v * v), 0.0)
            for (a, b), corner in corners.items():
                weight = (1.0 + a * s) * (1.0 + b * t) / 4.0
                point = add(point, mul(corner, weight))
            row.append(point)
        rows.append(row[::-1])               # so that the front looks up
    sail = grid(rows)
    posts = Shape()
    for corner, foot in ((corners[1, -1], (5.72, -0.05, -3.10)),
                         (corners[1, 1], (5.80, -0.05, 1.72))):
        lean = sub(corner, foot)
        top = add(foot, mul(lean, 1.05))
        posts.extend(tube([foot, top], [0.045, 0.032], 10))
    ropes = Shape()
    for corner, hook in ((corners[-1, -1], (3.02, 3.09, -2.40)),
                         (corners[-1, 1], (3.02, 3.05, 1.60))):
        ropes.extend(tube([corner, hook], 0.008, 5))
    scene.node("canopy", scene.mesh("canopy", ("canvas", sail),
                                    ("timber", posts), ("iron", ropes)))


# ---- furniture -----------------------------------------------------------

def build_table(scene):
    top = turned([[(0.53, 0.70), (0.56, 0.712), (0.56, 0.735),
                   (0.55, 0.742)]], 36)
    stem = turned([
        [(0.24, -0.005), (0.24, 0.015)],
        [(0.24, 0.015), (0.16, 0.04), (0.06, 0.075), (0.035, 0.14),
         (0.035, 0.40)],
        bulge(0.035, 0.40, 0.46, 0.022, 4),
        [(0.035, 0.46), (0.035, 0.60), (0.09, 0.66), (0.16, 0.705)]], 18)
    mesh = scene.mesh("table", ("timber", top), ("iron", stem))
    scene.node("table", mesh, at=(LANTERN[0], TERRACE_Y, LANTERN[2]))
    carafe = lathe([[(0.050, 0.745), (0.062, 0.78), (0.055, 0.86),
                     (0.026, 0.93), (0.026, 0.98), (0.036, 1.01)]], 20)
    scene.node("carafe", scene.mesh("carafe", ("glass", carafe)),
               at=(LANTERN[0] + 0.14, TERRACE_Y, LANTERN[2] + 0.12))
    tumbler = lathe([[(0.028, 0.745), (0.036, 0.85)]], 18)
    glasses = scene.mesh("tumbler", ("glass", tumbler))
    for k, (x, z) in enumerate(((-0.16, 0.20), (0.02, 0.30))):
        scene.node(f"tumbler_{k + 1}", glasses,
                   at=(LANTERN[0] + x, TERRACE_Y, LANTERN[2] + z))


def chair_mesh(scene):
    """A spindle-back chair that faces +Z."""
    seat = turned([[(0.19, 0.425), (0.215, 0.440), (0.215, 0.455),
                    (0.200, 0.465)]], 18)
    iron = Shape()
    for sx in (-1, 1):
        for sz in (-1, 1):
            iron.extend(tube([(0.13 * sx, 0.435, 0.13 * sz),
                              (0.19 * sx, -0.005, 0.19 * sz)], 0.012, 5))
    ring = [(p[0], 0.17, p[1]) for p in circle(0.235, 16)]
    iron.extend(tube(ring, 0.007, 3, closed=True))

    def hoop(t):
        """A point of the back hoop, t from -1 to 1."""
        a = t * 0.62 * math.pi
        height = 0.455 + 0.44 * math.cos(t * math.pi / 2) ** 0.6
        if abs(t) == 1.0:
            height = 0.445
        lean = -0.10 - 0.07 * (height - 0.445) / 0.44
        return (0.20 * math.sin(a) / math.sin(0.62 * math.pi) * (
            1.0 if abs(t) > 0.8 else math.sin(0.62 * math.pi) * 1.06),
            height, lean)

    path = [hoop(-1.0 + k / 8.0) for k in range(17)]
    iron.extend(tube(path, 0.011, 5))
    for k in range(-2, 3):
        x = 0.062 * k
        high = min(path, key=lambda p: abs(p[0] - x) - p[1])
        iron.extend(tube([(0.75 * x, 0.45, -0.115),
                          (x, high[1] - 0.004 - 0.035 * abs(k) ** 1.5 / 2.83,
                           high[2])], 0.006, 4))
    return scene.mesh("chair", ("timber", seat), ("iron", iron))


def build_chairs(scene):
    mesh = chair_mesh(scene)
    for k, (angle, away) in enumerate(((15, 0.74), (128, 0.80), (246, 0.70))):
        a = math.radians(angle)
        at = (LANTERN[0] + away * math.sin(a), TERRACE_Y,
              LANTERN[2] + away * math.cos(a))
        scene.node(f"chair_{k + 1}", mesh, at=at, turn=yaw(angle + 180.0))


def build_bench(scene):
    """Slats on two bent iron frames; it faces +Z."""
    profile = [(0.44, 0.22), (0.455, 0.13), (0.445, 0.04), (0.435, -0.05),
               (0.455, -0.13), (0.58, -0.20), (0.67, -0.225), (0.76, -0.25),
               (0.85, -0.28)]
    slats = Shape()
    for k, (y, z) in enumerate(profile):
        y0, z0 = profile[max(k - 1, 0)]
        y1, z1 = profile[min(k + 1, len(profile) - 1)]
        up = unit((0.0, z0 - z1, y1 - y0))
        if up[1] < 0:
            up = mul(up, -1.0)
        slats.extend(bar((-0.85, y, z), (0.85, y, z), 0.070, 0.022, up))
    iron = Shape()
    for x in (-0.66, 0.66):
        iron.extend(tube([(x, y - 0.022, z - 0.012) for y, z in profile],
                         0.015, 6))
        iron.extend(tube([(x, -0.005, 0.24), (x, 0.20, 0.19),
                          (x, 0.435, 0.20)], 0.015, 6))
        iron.extend(tube([(x, -0.005, -0.26), (x, 0.22, -0.17),
                          (x, 0.43, -0.10)], 0.015, 6))
        arm = [(x, 0.43, 0.20), (x, 0.60, 0.24), (x, 0.665, 0.19),
               (x, 0.67, 0.05), (x, 0.665, -0.10), (x, 0.64, -0.225)]
        iron.extend(tube(arm, 0.013, 6))
    mesh = scene.mesh("bench", ("timber", slats), ("iron", iron))
    scene.node("bench", mesh, at=(-2.60, TERRACE_Y, -0.40), turn=yaw(90.0))


# ---- bicycle -------------------------------------------------------------

WHEEL = 0.34                                    # radius over the tyre
REAR, FRONT = (0.0, WHEEL, 0.0), (1.04, WHEEL, 0.0)


def wheel_mesh(scene):
    tyre = tube(circle(WHEEL - 0.020, 32), 0.020, 5, closed=True)
    rim = tube(circle(WHEEL - 0.044, 32), 0.012, 3, closed=True)
    quarter = quat((1.0, 0.0, 0.0), 90.0)
    hub = turned([[(0.028, -0.045), (0.028, -0.038), (0.014, -0.030),
                   (0.014, 0.030), (0.028, 0.038), (0.028, 0.045)]], 8)
    metal = Shape().extend(rim).extend(hub.moved(turn=quarter))
    for k in range(24):
        a = TAU * k / 24
        lead = a + (0.55 if k % 4 < 2 else -0.55)      # crossed lacing
        z = 0.036 if k % 2 else -0.036
        metal.extend(tube([(0.024 * math.cos(lead), 0.024 * math.sin(lead), z),
                           ((WHEEL - 0.045) * math.cos(a),
                            (WHEEL - 0.045) * math.sin(a), 0.0)], 0.0022, 3))
    return scene.mesh("wheel", ("umber", tyre), ("steel", metal))


def mudguard(centre, start, end):
    """A curved strip over a wheel: an open sheet."""
    rows = []
    for k in range(15):
        a = math.radians(start + (end - start) * k / 14)
        rows.append([(centre[0] + r * math.cos(a), centre[1] + r * math.sin(a),
                      z)
                     for z, r in ((-0.032, 0.357), (-0.018, 0.368),
                                  (0.018, 0.368), (0.032, 0.357))])
    return grid(rows)


def build_bicycle(scene):
    bottom, seat = (0.43, 0.285, 0.0), (0.295, 0.74, 0.0)
    head_low, head_top = (0.905, 0.655, 0.0), (0.865, 0.800, 0.0)
    frame, iron, umber = Shape(), Shape(), Shape()
    for a, b, r in ((bottom, seat, 0.017), (bottom, head_low, 0.019),
                    ((0.315, 0.67, 0.0), (0.882, 0.74, 0.0), 0.016),
                    (head_low, head_top, 0.021)):
        frame.extend(tube([a, b], r, 8))
    for z in (-0.055, 0.055):
        rear = add(REAR, (0.0, 0.0, z))
        frame.extend(tube([(0.43, 0.285, z * 0.4), (0.20, 0.31, z), rear],
                          0.009, 6))
        frame.extend(tube([(0.30, 0.70, z * 0.2), (0.20, 0.58, z), rear],
                          0.008, 6))
        front = add(FRONT, (0.0, 0.0, z))
        frame.extend(tube([(0.908, 0.648, z * 0.4), (0.925, 0.60, z),
                           (0.985, 0.42, z), front], 0.010, 6))
    frame.extend(mudguard(REAR, 20.0, 190.0))
    frame.extend(mudguard(FRONT, -5.0, 120.0))
    # saddle, seat post, stem, handlebar with swept-back grips
    umber.extend(ellipsoid(0.135, 0.032, 0.075, 14, 8).moved(
        (0.255, 0.865, 0.0), quat((0, 0, 1), 3)))
    iron.extend(tube([(0.295, 0.72, 0.0), (0.268, 0.85, 0.0)], 0.012, 8))
    iron.extend(tube([(0.868, 0.78, 0.0), (0.848, 0.88, 0.0),
                      (0.905, 0.915, 0.0)], 0.012, 8))
    for side in (-1, 1):
        path = [(0.905, 0.915, 0.0), (0.915, 0.93, 0.10), (0.90, 0.955, 0.20),
                (0.82, 0.965, 0.265), (0.70, 0.955, 0.275)]
        path = [(x, y, z * side) for x, y, z in path]
        iron.extend(tube(path, 0.010, 6))
        umber.extend(tube([path[3], path[4]], 0.015, 7))
    # chain wheel, cranks, pedals, stand
    iron.extend(tube([add(p, (0.43, 0.285, 0.06)) for p in circle(0.085, 20)],
                     0.006, 4, closed=True))
    iron.extend(tube([(0.43, 0.285, -0.08), (0.43, 0.285, 0.08)], 0.016, 8))
    for side in (-1, 1):
        z, dx, dy = 0.075 * side, 0.15 * side, -0.075 * side
        iron.extend(tube([(0.43, 0.285, z), (0.43 + dx, 0.285 + dy, z)],
                         0.009, 6))
        umber.extend(block((0.43 + dx, 0.285 + dy, z + 0.05 * side),
                           (0.085, 0.022, 0.085)))
    iron.extend(tube([(0.36, 0.30, 0.03), (0.30, 0.035, 0.19)], 0.008, 6))
    mesh = scene.mesh("bicycle", ("enamel", frame), ("steel", iron),
                      ("umber", umber))
    lean = quat((1.0, 0.0, 0.0), 9.0)
    bike = scene.node("bicycle", at=(-3.55, 0.002, 3.55), turn=yaw(16.0))
    leaning = scene.node("bicycle_frame", mesh, turn=lean, parent=bike)
    wheel = wheel_mesh(scene)
    scene.node("bicycle_wheel_rear", wheel, at=REAR, parent=leaning)
    scene.node("bicycle_wheel_front", wheel, at=FRONT, parent=leaning,
               turn=quat((0.0, 0.0, 1.0), 6.0))


# ---- plants and stones ---------------------------------------------------

def pot_parts(radius, height):
    """A tapered pot with a rolled rim (closed) and a disc of soil (open)."""
    r, h = radius, height
    pot = lathe([
        [(0.0, -0.005), (0.68 * r, -0.005)],
        [(0.68 * r, -0.005), (0.93 * r, 0.84 * h)],
        bulge(0.93 * r, 0.84 * h, h, 0.08 * r, 3),
        [(0.93 * r, h), (0.84 * r, h)],
        [(0.84 * r, h), (0.81 * r, 0.86 * h)],
        [(0.81 * r, 0.86 * h), (0.0, 0.86 * h)]], 16)
    soil = lathe([[(0.822 * r, 0.90 * h), (0.0, 0.93 * h)]], 16)
    return ("terracotta", pot), ("umber", soil)


def strap_leaf(length, width, rise, droop, fold, steps=4):
    """A pointed, folded, arching leaf: a single open sheet along +X."""
    points, triangles = [], []
    for k in range(steps):
        t = k / steps
        x = length * t * (1.0 - 0.18 * droop * t)
        y = length * (rise * t - droop * t * t)
        w = width * (0.35 + 1.3 * t - 1.5 * t * t) * (1.0 - 0.1 * t)
        points += [(x, y + fold * w, -w), (x, y, 0.0), (x, y + fold * w, w)]
        if k:
            a = 3 * k
            for i in (0, 1):
                triangles += [(a - 3 + i, a - 2 + i, a + 1 + i),
                              (a - 3 + i, a + 1 + i, a + i)]
    tip = len(points)
    points.append((length * (1.0 - 0.18 * droop), length * (rise - droop),
                   0.0))
    triangles += [(tip - 3, tip - 2, tip), (tip - 2, tip - 1, tip)]
    return smooth(points, triangles)


def rosette(count, seed, length, width, rise, droop, fold, y):
    """Leaves in a golden-angle spiral, the later ones steeper."""
    rng = random.Random(seed)
    out = Shape()
    for k in range(count):
        t = k / (count - 1)
        size = rng.uniform(0.85, 1.05)
        leaf = strap_leaf(length * size * (1.0 - 0.25 * t), width * size,
                          rise * (0.45 + 1.1 * t), droop * (1.1 - 0.5 * t),
                          fold)
        leaf = leaf.moved((0.02, 0.0, 0.0))
        out.extend(leaf.moved((0.0, y, 0.0), yaw(k * 137.508
                                                 + rng.uniform(-8, 8))))
    return out


def build_plants(scene):
    agave = scene.mesh("agave", *pot_parts(0.22, 0.34), (
        "leaf", rosette(16, 1, 0.50, 0.058, 1.05, 0.55, 0.35, 0.30)))
    fern = scene.mesh("fern", *pot_parts(0.20, 0.42), (
        "leaf", rosette(21, 2, 0.85, 0.026, 1.65, 1.25, 0.5, 0.37)))
    topiary = scene.mesh(
        "topiary", *pot_parts(0.21, 0.36),
        ("umber", tube([(0.0, 0.30, 0.0), (0.012, 0.55, 0.008),
                        (0.0, 0.85, 0.0)], 0.020, 7)),
        ("leaf", ellipsoid(0.25, 0.25, 0.25, 18, 9).moved((0.0, 1.02, 0.0))),
        ("leaf", ellipsoid(0.15, 0.15, 0.15, 14, 8).moved((0.0, 1.40, 0.0))))
    y = TERRACE_Y
    for name, mesh, at, turn, size in (
            ("agave_1", agave, (3.55, y, -0.85), 0, 1.0),
            ("agave_2", agave, (-3.52, y, 1.55), 70, 0.95),
            ("agave_3", agave, (2.25, 0.0, 2.98), 200, 0.85),
            ("fern_1", fern, (3.45, y, -2.80), 20, 1.05),
            ("fern_2", fern, (-2.55, y, -1.62), 150, 0.9),
            ("fern_3", fern, (-3.50, y, -2.85), 250, 1.0),
            ("topiary_1", topiary, (-2.12, y, 1.80), 0, 1.0),
            ("topiary_2", topiary, (2.12, y, 1.80), 40, 1.0)):
        scene.node(name, mesh, at=at, turn=yaw(turn),
                   scale=(size, size, size))


def ivy_card(size):
    """A kite round the leaf of ivy_png: one open sheet of two triangles."""
    s = size
    points = [(0.0, 0.0, 0.0), (0.5 * s, 0.5 * s, 0.10 * s),
              (0.0, s, 0.0), (-0.5 * s, 0.5 * s, 0.10 * s)]
    return smooth(points, [(0, 1, 2), (0, 2, 3)],
                  [(0.5, 1.0), (1.0, 0.5), (0.5, 0.0), (0.0, 0.5)])


def build_ivy(scene):
    """Ivy over the left trellis, thickest at the foot and the outer side."""
    rng = random.Random(7)
    leaves = Shape()
    placed = 0
    while placed < 230:
        a, b = rng.random(), rng.random()
        if rng.random() > (1.0 - a) ** 0.8 * (1.15 - b) ** 0.7:
            continue
        placed += 1
        at = (-2.86 + 1.25 * a, TERRACE_Y + 0.10 + 2.15 * b,
              COLUMN_Z[0] + rng.uniform(0.03, 0.10))
        card = ivy_card(rng.uniform(0.10, 0.17))
        card = card.moved(turn=quat((0, 0, 1), rng.uniform(-75, 75)))
        card = card.moved(turn=quat((1, 0, 0), rng.uniform(-40, 15)))
        leaves.extend(card.moved(at, yaw(rng.uniform(-35, 35))))
    scene.node("ivy", scene.mesh("ivy", ("ivy", leaves)))


def build_boulders(scene):
    """One faceted boulder under three non-uniform scales."""
    rng = random.Random(5)
    points, faces = icosphere(2)
    dents = [(unit((rng.gauss(0, 1), rng.gauss(0, 1), rng.gauss(0, 1))),
              rng.uniform(0.78, 0.95)) for _ in range(14)]
    shaped = []
    for p in points:
        r = min([1.0] + [cut / dot(p, d) for d, cut in dents
                         if dot(p, d) > cut])
        shaped.append(mul(p, r))
    mesh = scene.mesh("boulder", ("basalt", flat(smooth(shaped, faces))))
    scene.node("boulder_1", mesh, at=(5.00, 0.12, 3.85), turn=yaw(25.0),
               scale=(0.62, 0.34, 0.45))
    scene.node("boulder_2", mesh, at=(5.45, 0.06, 3.28), turn=yaw(110.0),
               scale=(0.33, 0.22, 0.26))
    scene.node("boulder_3", mesh, at=(-5.15, 0.10, 0.90), turn=yaw(70.0),
               scale=(0.55, 0.30, 0.38))


# ---- sundial and wind pump -----------------------------------------------

def build_sundial(scene):
    pedestal = flat(turned([
        [(0.30, -0.04), (0.30, 0.09), (0.21, 0.13), (0.16, 0.20),
         (0.13, 0.78), (0.17, 0.86), (0.24, 0.90), (0.24, 0.96)]], 8))
    plate = drum(0.205, 0.955, 0.972, 32)
    scene.node("sundial", scene.mesh(
        "sundial", ("limestone", pedestal), ("brass", plate),
        ("brass", gnomon(0.972))), at=(3.05, 0.0, 3.75), turn=yaw(-20.0))


def gnomon(y):
    """A triangular web with two flanges along its sloping edge.

    Web and flanges are sheets that share that edge, which so has three faces.
    """
    low, high = (0.0, y - 0.003, 0.13), (0.0, y + 0.20, -0.12)
    foot = (0.0, y - 0.003, -0.12)
    out = Shape()
    out.fan([low, foot, high], (1.0, 0.0, 0.0))
    for side in (-1, 1):
        drop = (0.026 * side, -0.008, 0.0)
        points = [low, high, add(high, drop), add(low, drop)]
        normal = unit(cross(sub(points[1], points[0]),
                            sub(points[2], points[0])))
        if normal[1] < 0:
            points.reverse()
            normal = mul(normal, -1.0)
        out.fan(points, normal)
    return out


HUB_Y = 4.12


def build_wind_pump(scene):
    """A braced mast, a tail on a turned head, and an animated rotor."""
    root = scene.node("wind_pump", mast_mesh(scene), at=(-4.95, 0.0, -4.05))
    head = scene.node("wind_pump_head", head_mesh(scene),
                      at=(0.0, HUB_Y, 0.0), turn=yaw(38.0), parent=root)
    return scene.node("wind_pump_rotor", rotor_mesh(scene),
                      at=(0.0, 0.0, 0.26), turn=(0.0, 0.0, 0.0, 1.0),
                      parent=head)


def mast_mesh(scene):
    iron = Shape()

    def leg(k, y):
        a = TAU * (k + 0.5) / 4
        r = 0.42 + (0.05 - 0.42) * y / HUB_Y
        return (r * math.cos(a), y, r * math.sin(a))

    levels = (0.15, 1.05, 1.85, 2.55, 3.15)
    for k in range(4):
        iron.extend(tube([leg(k, -0.05), leg(k, HUB_Y - 0.05)], 0.018, 6))
        for low, high in zip(levels, levels[1:]):
            iron.extend(tube([leg(k, low), leg(k + 1, high)], 0.008, 4))
            iron.extend(tube([leg(k + 1, low), leg(k, high)], 0.008, 4))
        for y in levels[1:]:
            iron.extend(tube([leg(k, y), leg(k + 1, y)], 0.010, 4))
    return scene.mesh("wind_pump_mast", ("iron", iron))


def head_mesh(scene):
    quarter = quat((1.0, 0.0, 0.0), 90.0)
    iron = turned([[(0.05, -0.20), (0.08, -0.14), (0.08, 0.08),
                    (0.04, 0.16), (0.04, 0.20)]], 12).moved(turn=quarter)
    iron.extend(tube([(0.0, 0.0, -0.15), (0.0, 0.03, -1.0)], 0.014, 6))
    vane = Shape()
    vane.fan([(0.0, -0.25, -1.12), (0.0, 0.33, -1.12), (0.0, 0.12, -0.66),
              (0.0, -0.06, -0.66)], (1.0, 0.0, 0.0))
    return scene.mesh("wind_pump_head", ("iron", iron), ("canvas", vane))


def rotor_mesh(scene):
    """Twelve twisted blades (open sheets) on two rings, turning about Z."""
    blades, iron = Shape(), Shape()
    for k in range(12):
        spin = quat((0.0, 0.0, 1.0), 30.0 * k)
        rows = []
        for j in range(4):
            t = j / 3.0
            r, w = 0.27 + 0.48 * t, 0.060 + 0.085 * t
            pitch = math.radians(40.0 - 16.0 * t)
            row = []
            for s in (-1.0, 0.0, 1.0):
                camber = 0.16 * w * (1.0 - s * s)
                row.append((r, s * w * math.cos(pitch),
                            s * w * math.sin(pitch) + camber))
            rows.append(row[::-1])
        blades.extend(grid(rows).moved(turn=spin))
        iron.extend(tube([(0.03, 0.0, -0.012), (0.72, 0.0, -0.012)],
                         0.007, 4).moved(turn=spin))
    for radius in (0.33, 0.64):
        ring = circle(radius, 24, (0.0, 0.0, -0.012))
        iron.extend(tube(ring, 0.008, 3, closed=True))
    quarter = quat((1.0, 0.0, 0.0), 90.0)
    iron.extend(turned([[(0.05, -0.07), (0.06, -0.05), (0.06, 0.04),
                         (0.03, 0.10)]], 12).moved(turn=quarter))
    return scene.mesh("wind_pump_rotor", ("canvas", blades), ("iron", iron))


def build_scene():
    """The whole scene, and the node that the animation turns."""
    scene = Scene()
    for build in (build_ground, build_terrace, build_stair_flanks,
                  build_columns, build_roof, build_trellises, build_railings,
                  build_lantern, build_canopy, build_table, build_chairs,
                  build_bench, build_bicycle, build_plants, build_ivy,
                  build_boulders, build_sundial):
        build(scene)
    return scene, build_wind_pump(scene)


# --------------------------------------------------------------------------
# Binary glTF
# --------------------------------------------------------------------------

class Buffer:
    """The binary chunk, with its views and accessors."""

    def __init__(self):
        self.data = bytearray()
        self.views = []
        self.accessors = []

    def view(self, data, target=None):
        view = {"buffer": 0, "byteOffset": len(self.data),
                "byteLength": len(data)}
        if target:
            view["target"] = target
        self.views.append(view)
        self.data += data
        self.data += b"\0" * (-len(self.data) % 4)
        return len(self.views) - 1

    def floats(self, kind, rows, bounds=False, target=None):
        flat_list = [v + 0.0 for row in rows for v in row]
        packed = struct.pack(f"<{len(flat_list)}f", *flat_list)
        accessor = {"bufferView": self.view(packed, target),
                    "componentType": 5126, "count": len(rows), "type": kind}
        if bounds:
            width = len(rows[0])
            stored = struct.unpack(f"<{len(flat_list)}f", packed)
            accessor["min"] = [min(stored[i::width]) for i in range(width)]
            accessor["max"] = [max(stored[i::width]) for i in range(width)]
        self.accessors.append(accessor)
        return len(self.accessors) - 1

    def indices(self, values):
        wide = max(values) > 65534
        packed = struct.pack(f"<{len(values)}{'I' if wide else 'H'}", *values)
        self.accessors.append({"bufferView": self.view(packed, 34963),
                               "componentType": 5125 if wide else 5123,
                               "count": len(values), "type": "SCALAR"})
        return len(self.accessors) - 1


def primitive(buffer, shape, material, textured):
    """One glTF primitive, equal vertices merged."""
    index, rows, order = {}, [], []
    for tri in shape.triangles:
        for i in tri:
            p, n, uv = shape.vertices[i]
            row = tuple(round(v, 6) + 0.0 for v in p + n)
            row += tuple(round(v, 6) + 0.0 for v in uv) if textured else ()
            if row not in index:
                index[row] = len(rows)
                rows.append(row)
            order.append(index[row])
    attributes = {
        "POSITION": buffer.floats("VEC3", [r[:3] for r in rows], True, 34962),
        "NORMAL": buffer.floats("VEC3", [r[3:6] for r in rows], False, 34962)}
    if textured:
        attributes["TEXCOORD_0"] = buffer.floats(
            "VEC2", [r[6:] for r in rows], False, 34962)
    return {"attributes": attributes, "indices": buffer.indices(order),
            "material": material}


def gltf_materials(texture_index):
    out = []
    for name, m in MATERIALS.items():
        pbr = {"baseColorFactor": list(m["color"]) + [m.get("alpha", 1.0)],
               "metallicFactor": m.get("metal", 0.0),
               "roughnessFactor": m["rough"]}
        if "texture" in m:
            pbr["baseColorTexture"] = {"index": texture_index[m["texture"]]}
        material = {"name": name, "pbrMetallicRoughness": pbr}
        if m.get("sheet"):
            material["doubleSided"] = True
        if "cutoff" in m:
            material["alphaMode"] = "MASK"
            material["alphaCutoff"] = m["cutoff"]
        if "alpha" in m:
            material["alphaMode"] = "BLEND"
        extensions = {}
        if "coat" in m:
            extensions["KHR_materials_clearcoat"] = {
                "clearcoatFactor": 1.0, "clearcoatRoughnessFactor": m["coat"]}
        if "glow" in m:
            material["emissiveFactor"] = list(m["glow"])
            extensions["KHR_materials_emissive_strength"] = {
                "emissiveStrength": m["strength"]}
        if extensions:
            material["extensions"] = extensions
        out.append(material)
    return out


def rotation_animation(buffer, node, seconds=8.0):
    """One turn about Z in five keys; the last equals the first."""
    times = [(seconds * k / 4,) for k in range(5)]
    turns = [quat((0.0, 0.0, 1.0), 90.0 * k) for k in range(5)]
    sampler = {"input": buffer.floats("SCALAR", times, True),
               "output": buffer.floats("VEC4", turns),
               "interpolation": "LINEAR"}
    target = {"node": node, "path": "rotation"}
    return {"name": "wind", "samplers": [sampler],
            "channels": [{"sampler": 0, "target": target}]}


def glb(scene, rotor):
    """The scene as the bytes of a GLB file."""
    buffer = Buffer()
    names = list(MATERIALS)
    meshes = []
    for name, parts in scene.meshes:
        meshes.append({"name": name, "primitives": [
            primitive(buffer, shape, names.index(material),
                      "texture" in MATERIALS[material])
            for material, shape in parts.items()]})
    animation = rotation_animation(buffer, rotor)
    images = [{"name": name, "mimeType": "image/png",
               "bufferView": buffer.view(make())}
              for name, make in TEXTURES.items()]
    texture_index = {name: i for i, name in enumerate(TEXTURES)}
    document = {
        "asset": {"version": "2.0", "generator": "make_pavilion.py",
                  "copyright": "edgeshade contributors, MIT licence"},
        "extensionsUsed": ["KHR_materials_clearcoat",
                           "KHR_materials_emissive_strength"],
        "scene": 0,
        "scenes": [{"name": "pavilion", "nodes": scene.roots}],
        "nodes": scene.nodes,
        "meshes": meshes,
        "materials": gltf_materials(texture_index),
        "textures": [{"sampler": 0, "source": i, "name": name}
                     for name, i in texture_index.items()],
        "images": images,
        "samplers": [{"magFilter": 9729, "minFilter": 9987,
                      "wrapS": 10497, "wrapT": 10497}],
        "animations": [animation],
        "accessors": buffer.accessors,
        "bufferViews": buffer.views,
        "buffers": [{"byteLength": len(buffer.data)}],
    }
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    body = (struct.pack("<II", len(text), 0x4E4F534A) + text
            + struct.pack("<II", len(buffer.data), 0x004E4942)
            + bytes(buffer.data))
    return struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body


def main(arguments):
    if len(arguments) != 2:
        sys.exit("usage: make_pavilion.py OUTPUT.glb")
    scene, rotor = build_scene()
    data = glb(scene, rotor)
    with open(arguments[1], "wb") as file:
        file.write(data)
    counts = [sum(len(s.triangles) for s in parts.values())
              for _, parts in scene.meshes]
    placed = [counts[n["mesh"]] for n in scene.nodes if "mesh" in n]
    print(f"{len(scene.meshes)} meshes, {len(scene.nodes)} nodes, "
          f"{len(MATERIALS)} materials, {len(data)} bytes")
    print(f"{sum(placed)} triangles in the scene, "
          f"{sum(counts)} before instancing")


if __name__ == "__main__":
    main(sys.argv)
