"""Figures of what a shadow volume is made of: prisms, edges, caps, winding numbers."""

import math

from drawing import (CAP, CASTER, FAINT, INK, LIGHT, SHADE, SIDE, Drawing, along, beyond, crossing)


def middle(points):
    return (sum(x for x, _ in points) / len(points), sum(y for _, y in points) / len(points))


def ring(drawing, points, colour, width=2.0):
    """A polygon's edges, each with its direction."""
    for i, p in enumerate(points):
        drawing.arrow(p, points[(i + 1) % len(points)], colour, width, at=0.58)


def prism():
    """One triangle's prism, and what is left where two prisms share an edge."""
    d = Drawing(760, 330, "The prism of a triangle, and two prisms whose common sides cancel")
    light = (150, 30)
    a, b, c = (90, 110), (195, 98), (160, 145)
    low = [beyond(light, p, 2.15) for p in (a, b, c)]
    for p, q in ((a, low[0]), (b, low[1]), (c, low[2])):
        d.line([light, p], LIGHT, 1, "3 3")
        d.line([p, q], SIDE, 1.5)
    d.polygon([a, b, low[1], low[0]], SIDE, 0.10)
    d.polygon([b, c, low[2], low[1]], SIDE, 0.16)
    d.polygon([c, a, low[0], low[2]], SIDE, 0.16)
    d.polygon([a, b, c], CAP, 0.30)
    d.polygon(low, CAP, 0.18)
    # Seen from the light, which is above, the front cap runs counter-clockwise.
    ring(d, [a, c, b], CAP)
    ring(d, [low[0], low[1], low[2]], CAP)
    d.lamp(light)
    for p, name, at in ((a, "A", (-16, 0)), (b, "B", (8, -4)), (c, "C", (8, 12))):
        d.text((p[0] + at[0], p[1] + at[1]), name, bold=True)
    d.text((212, 108), "front cap", fill=CAP)
    d.text((228, 150), "three sides", fill=SIDE)
    d.text((214, 262), "back cap, at infinity", fill=CAP)

    # Two triangles of a surface that both face the light.
    light = (560, 30)
    p, q, r, s = (490, 112), (567, 150), (577, 92), (650, 120)
    d.polygon([p, q, r], CAP, 0.25)
    d.polygon([q, s, r], CAP, 0.25)
    outline = [p, q, s, r]
    for i, v in enumerate(outline):
        w = outline[(i + 1) % 4]
        d.polygon([v, w, beyond(light, w, 2.0), beyond(light, v, 2.0)], SIDE, 0.10)
        d.line([v, beyond(light, v, 2.0)], SIDE, 1.2)
        d.arrow(v, w, SIDE, 2.2, at=0.58)
    # The common edge, once for each triangle.
    d.arrow((q[0] - 4, q[1]), (r[0] - 4, r[1]), CASTER, 1.5, at=0.62)
    d.arrow((r[0] + 4, r[1]), (q[0] + 4, q[1]), CASTER, 1.5, at=0.62)
    d.text((538, 124), "+1", fill=CASTER, anchor="middle")
    d.text((607, 124), "−1", fill=CASTER, anchor="middle")
    d.lamp(light)
    d.text((560, 310), "the edge between them counts +1 − 1 = 0: no side", anchor="middle")
    return d


def multiplicity():
    """Edges seen along their own direction, with two and with three triangles."""
    d = Drawing(760, 270, "The multiplicity of an edge, seen along the edge")
    cases = (
        (130, "two triangles, both on one side", ((-62, 62), (-92, 12)), "m = −1 − 1 = −2"),
        (380, "one on each side", ((-72, 52), (76, 46)), "m = −1 + 1 = 0"),
        (630, "three triangles", ((-84, 34), (82, 26), (58, 74)), "m = −1 + 1 + 1 = +1"),
    )
    for x, title, opposites, result in cases:
        edge, light = (x, 125), (x + 18, 48)
        down = beyond(light, edge, 2.35)
        d.line([light, down], LIGHT, 1.5, "5 4")
        for dx, dy in opposites:
            o = (edge[0] + dx, edge[1] + dy)
            d.line([edge, o], CASTER, 3)
            d.dot(o, CASTER, 3.5)
            sign = "−1" if dx < 0 else "+1"
            d.text((o[0] + (-12 if dx < 0 else 12), o[1] + 5), sign,
                   anchor="end" if dx < 0 else "start", bold=True)
        d.lamp(light)
        d.dot(edge, SIDE, 5)
        d.text((x, 24), title, anchor="middle")
        d.text((x, 256), result, anchor="middle", bold=True)
    d.text((140, 236), "light plane", fill=LIGHT, anchor="end", size=12)
    return d


def area(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def ears(polygon):
    """The polygon in triangles: cuts off one corner after the other."""
    left, triangles = list(polygon), []
    while len(left) > 3:
        for i in range(len(left)):
            a, b, c = left[i - 1], left[i], left[(i + 1) % len(left)]
            others = [p for p in left if p not in (a, b, c)]
            if area(a, b, c) > 0 and not any(
                    area(a, b, p) >= 0 and area(b, c, p) >= 0 and area(c, a, p) >= 0 for p in others):
                triangles.append((a, b, c))
                del left[i]
                break
    return triangles + [tuple(left)]


def fan_of_caps():
    """A cap of many triangles, and the fan with the same outline."""
    d = Drawing(760, 300, "A cap of all casting triangles and a fan of silhouette edges")
    shape = [(-112, 12), (-80, -58), (-18, -70), (40, -40), (108, -62), (92, 40), (-26, 4),
             (0, 72), (-74, 66)]
    for x, title in ((190, "all casting triangles"), (570, "silhouette edges, joined to the middle")):
        d.text((x, 24), title, anchor="middle")
        d.polygon([(x - 125, 60), (x + 125, 60), (x + 125, 230), (x - 125, 230)], "#ffffff", 0,
                  FAINT, 1)
        outline = [(x + px, 145 + py) for px, py in shape]
        apex = (x, 145)
        if x == 190:
            whole = ears(outline)
            drawn = [(p, q, middle(t)) for t in whole for p, q in ((t[0], t[1]), (t[1], t[2]),
                                                                   (t[2], t[0]))]
        else:
            drawn = [(p, outline[(i + 1) % len(outline)], apex) for i, p in enumerate(outline)]
        turned = 0
        for p, q, r in drawn:
            over = area(p, q, r) < 0
            turned += over
            d.polygon([p, q, r], "#cf222e" if over else CAP, 0.30 if over else 0.20,
                      "#cf222e" if over else CAP, 0.8)
        ring(d, outline, SIDE, 1.8)
        if x == 190:
            d.text((x, 262), f"{len(drawn)} triangles", anchor="middle")
        else:
            d.dot(apex, INK, 4)
            d.text((x, 262), f"{len(drawn)} triangles, {turned} of them turned over:",
                   anchor="middle")
            d.text((x, 280), "there it takes away what others add", anchor="middle")
    d.text((380, 80), "the cluster's box", fill=FAINT, size=12, anchor="middle")
    return d


def winding():
    """A closed curve that crosses itself: winding numbers, and what a way to the light crosses."""
    d = Drawing(760, 345, "Winding numbers of a closed component, and crossings on the way to the light")
    # A figure that overlaps itself; its inside is on the left of its direction, y down.
    curve = [(150, 80), (120, 200), (220, 290), (430, 270), (480, 160), (390, 90), (300, 130),
             (330, 230), (470, 300), (600, 250), (610, 120), (500, 50), (330, 60)]
    step = 4
    counts = {}
    for gx in range(90, 660, step):
        for gy in range(30, 320, step):
            counts[(gx, gy)] = winding_number((gx + step / 2, gy + step / 2), curve)
    for value, opacity in ((1, 0.16), (2, 0.36)):
        for (gx, gy), count in counts.items():
            if count == value and counts.get((gx - step, gy)) != value:
                end = gx
                while counts.get((end, gy)) == value:
                    end += step
                d.polygon([(gx, gy), (end, gy), (end, gy + step), (gx, gy + step)], SHADE, opacity)
    d.line(curve + [curve[0]], CASTER, 2.5)
    for p, count in (((200, 180), 1), ((550, 160), 1), ((440, 215), 2), ((345, 150), None),
                     ((110, 300), 0)):
        if count is not None:
            assert winding_number(p, curve) == count
            d.text(p, f"w = {count}", bold=True, anchor="middle")
    point, light = (60, 225), (700, 95)
    d.line([point, light], LIGHT, 1.5, "6 4")
    marks = []
    for i, a in enumerate(curve):
        b = curve[(i + 1) % len(curve)]
        share = crossing(point, light, a, b)
        if share is None:
            continue
        before = winding_number(along(point, light, share - 0.01), curve)
        after = winding_number(along(point, light, share + 0.01), curve)
        marks.append((share, before - after))
    facing = 0
    for share, change in sorted(marks):
        p = along(point, light, share)
        facing += change > 0
        d.dot(p, "#ffffff", 9, CAP if change > 0 else SIDE)
        d.text((p[0], p[1] + 5), "+" if change > 0 else "−", anchor="middle", bold=True,
               fill=CAP if change > 0 else SIDE)
    assert sum(change for _, change in marks) == 0
    d.dot(point, INK, 5)
    d.text((point[0] - 4, point[1] + 22), "X′", anchor="middle", bold=True)
    d.lamp(light)
    d.text((380, 330), f"{facing} light-facing (+), {len(marks) - facing} that face away (−): "
           "w(X′) − w(L) = 0", anchor="middle")
    return d


def winding_number(p, curve):
    """How often the curve runs around p, positive where its inside is on its left (y down)."""
    turns = 0.0
    for i, a in enumerate(curve):
        b = curve[(i + 1) % len(curve)]
        u, v = (a[0] - p[0], a[1] - p[1]), (b[0] - p[0], b[1] - p[1])
        turns += math.atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1])
    return round(-turns / (2 * math.pi))


def ball():
    """A ball of lights and three edges: which can be silhouettes for some light of it."""
    d = Drawing(760, 320, "A ball of light positions and the planes of edges")
    centre, radius = (380, 80), 42
    d.circle(centre, radius, LIGHT, 1.5, "#fff6dd")
    d.lamp(centre, None)
    d.text((centre[0] + 50, centre[1] - 28), "all lights of the ball", fill=LIGHT)
    cases = (
        (130, ((-60, 10), (60, 10)), "the same sign for all:", "never a silhouette, left out"),
        (380, ((-48, 52), (24, 66)), "a plane meets the ball:", "uncertain, listed"),
        (630, ((-66, 20), (-20, 62)), "opposite signs for all:", "certain, listed"),
    )
    for x, ends, first, second in cases:
        edge = (x, 190)
        for dx, dy in ends:
            o = (edge[0] + dx, edge[1] + dy)
            far = along(o, edge, 3.0 if x == 380 else 2.2)
            d.line([edge, far], FAINT, 1, "4 4")
            d.line([edge, o], CASTER, 3.5)
        d.dot(edge, SIDE, 5)
        d.text((x, 288), first, anchor="middle")
        d.text((x, 306), second, anchor="middle", bold=True)
    return d
