"""Figures of a frame, all seen from the side: caps, where counting starts, ends, slices."""

from drawing import (CAP, CASTER, EYE, FAINT, INK, LIGHT, SHADE, SIDE, Drawing, along, beyond)


def shadow_of(drawing, light, a, b, floor):
    """The shadow volume of the segment a-b, down to the height `floor`."""
    low = [beyond(light, p, (floor - light[1]) / (p[1] - light[1])) for p in (a, b)]
    drawing.polygon([a, b, low[1], low[0]], SHADE, 0.22)
    for p, q in ((a, low[0]), (b, low[1])):
        drawing.line([p, q], SIDE, 1.8)
    return low


def picture_pyramid(drawing, eye, near, far, half):
    """Near rectangle and the sides of the picture's pyramid, for an eye that looks to the right."""
    def at(x):
        reach = half * (x - eye[0])
        return (x, eye[1] - reach), (x, eye[1] + reach)
    for side in range(2):
        drawing.line([eye, at(far)[side]], EYE, 1, "2 3")
    drawing.line(at(near), EYE, 2.5)
    return at


def front_cap():
    """Why the front cap is moved to infinity, and where it must be cut."""
    d = Drawing(760, 300, "The front cap at infinity, and a caster that the near plane cuts")
    for x0, cut in ((0, False), (390, True)):
        eye, light = (x0 + 40, 150), (x0 + (60 if cut else 150), 30)
        near = x0 + 90
        at = picture_pyramid(d, eye, near, x0 + 340, 0.36)
        d.line([(x0 + 20, 260), (x0 + 350, 260)], CASTER, 2)
        a, b = ((x0 + 62, 148), (x0 + 190, 168)) if cut else ((x0 + 150, 120), (x0 + 225, 135))
        shadow_of(d, light, a, b, 260)
        d.line([a, b], CASTER, 4)
        for p in (a, b):
            d.line([along(eye, p, 1), along(eye, p, (x0 + 330 - eye[0]) / (p[0] - eye[0]))
                    if p[0] > near else p], FAINT, 1, "3 3")
        if cut:
            cut_at = along(a, b, (near - a[0]) / (b[0] - a[0]))
            d.line([a, cut_at], "#cf222e", 4)
            d.dot(cut_at, INK, 4)
            d.text((x0 + 100, 232), "cut off here: its cap", size=12, fill="#cf222e")
            d.text((x0 + 100, 247), "must not count", size=12, fill="#cf222e")
        else:
            ends = [along(eye, p, (x0 + 330 - eye[0]) / (p[0] - eye[0])) for p in (a, b)]
            d.line(ends, CAP, 4)
            d.text((x0 + 316, ends[1][1] + 18), "front cap, moved", size=12, fill=CAP, anchor="middle")
            d.text((x0 + 316, ends[1][1] + 33), "along the eye's rays", size=12, fill=CAP,
                   anchor="middle")
        d.eye(eye)
        d.text((near - 4, at(near)[0][1] - 8), "near", size=12, fill=EYE, anchor="middle")
        d.lamp(light)
    d.text((190, 290), "covers the same pixels, behind every surface", anchor="middle")
    d.text((580, 290), "a caster that crosses the near plane", anchor="middle")
    return d


def z_pass_start():
    """Hulls of near rectangle and light: nothing, a whole layer, an outline in it."""
    d = Drawing(760, 310, "Where counting before surfaces starts")
    cases = ((0, (175, 120), (220, 160), "nothing in the hull:", "z-pass, start 0"),
             (250, (105, 106), (180, 112), "a layer through all of it:", "z-pass, start 1"),
             (500, (124, 106), (190, 112), "a silhouette in it:", "z-fail, with caps"))
    for x0, a, b, first, second in cases:
        eye, light = (x0 + 62, 185), (x0 + 150, 36)
        near = x0 + 100
        rectangle = picture_pyramid(d, eye, near, x0 + 235, 0.6)(near)
        d.polygon([rectangle[0], rectangle[1], light], LIGHT, 0.25)
        a, b = (x0 + a[0], a[1]), (x0 + b[0], b[1])
        shadow_of(d, light, a, b, 245)
        d.line([a, b], CASTER, 4)
        d.line(rectangle, EYE, 3)
        d.eye(eye)
        d.lamp(light)
        d.text((x0 + 125, 284), first, anchor="middle")
        d.text((x0 + 125, 302), second, anchor="middle", bold=True)
    return d


def ends():
    """Volumes without caps end at a plane beyond everything visible."""
    d = Drawing(760, 290, "Volumes end at a plane beyond everything that is visible")
    eye, light, near = (60, 130), (250, 26), 105
    at = picture_pyramid(d, eye, near, 520, 0.2)
    floor = 222
    d.polygon([(60, 92), (520, 92), (520, 232), (60, 232)], "#ffffff", 0, FAINT, 1.2)
    d.line([(150, floor), (510, floor)], CASTER, 3)
    a, b = (300, 118), (350, 130)
    low = shadow_of(d, light, a, b, 248)
    d.line([a, b], CASTER, 4)
    for p, q in zip((a, b), low):
        d.line([q, along(p, q, 1.3)], SIDE, 1.2, "3 4")
    d.line([(40, 248), (620, 248)], SIDE, 2.5)
    d.text((628, 252), "the end: a plane", fill=SIDE, size=12)
    d.text((526, 104), "box around near rectangles,", fill=FAINT, size=12)
    d.text((526, 119), "eye and all that is visible", fill=FAINT, size=12)
    d.eye(eye)
    d.lamp(light)
    d.line(at(near), EYE, 3)
    d.text((380, 280), "no way from the near rectangle to a visible point passes the end", anchor="middle")
    return d


def depth_slices():
    """The far part is drawn first; the near part draws over it."""
    d = Drawing(760, 300, "Depth slices, each with a depth range of its own")
    eye, light = (40, 150), (350, 30)
    nearest, border, far = 70, 270, 700
    at = picture_pyramid(d, eye, nearest, far, 0.17)
    d.polygon([*at(nearest), *reversed(at(border))], EYE, 0.10)
    d.polygon([*at(border), *reversed(at(far))], SHADE, 0.12)
    d.line(at(border), EYE, 2.5)
    a, b = (228, 118), (330, 140)
    shadow_of(d, light, a, b, 250)
    d.line([a, b], CASTER, 4)
    cut_at = along(a, b, (border - a[0]) / (b[0] - a[0]))
    d.line([a, cut_at], "#cf222e", 4)
    d.dot(cut_at, INK, 4)
    d.eye(eye)
    d.lamp(light)
    d.text((180, 215), "drawn second:", anchor="middle", size=12)
    d.text((180, 231), "surfaces nearer than", anchor="middle", size=12)
    d.text((180, 247), "the border, all volumes", anchor="middle", size=12)
    d.text((560, 150), "drawn first, with its near plane at the border", anchor="middle", size=12)
    d.text((border - 40, 84), "caps are cut here", size=12, fill="#cf222e")
    d.text((380, 284), "what the far part cuts off lies before everything that it shows", anchor="middle")
    return d
