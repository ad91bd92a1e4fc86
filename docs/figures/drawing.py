"""A drawing as SVG: shapes of 2D points, drawn in order, written the same way every time."""

import math

INK = "#22272e"
FAINT = "#8b949e"
CASTER = "#57606a"
LIGHT = "#d99a00"
SIDE = "#d9730d"   # the viewer's tints: sides orange, counting twice green, caps blue
TWICE = "#2da44e"
CAP = "#2f6feb"
SHADE = "#5b7db1"
EYE = "#8250df"


def number(value):
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def along(p, q, share):
    return (p[0] + (q[0] - p[0]) * share, p[1] + (q[1] - p[1]) * share)


def beyond(light, p, factor):
    """p pushed away from the light, to `factor` times its distance."""
    return along(light, p, factor)


def crossing(p, q, a, b):
    """Where the segment p-q meets the segment a-b, as a share of p-q; None where it doesn't."""
    d, e = (q[0] - p[0], q[1] - p[1]), (b[0] - a[0], b[1] - a[1])
    determinant = d[0] * e[1] - d[1] * e[0]
    if determinant == 0:
        return None
    f = (a[0] - p[0], a[1] - p[1])
    t = (f[0] * e[1] - f[1] * e[0]) / determinant
    s = (f[0] * d[1] - f[1] * d[0]) / determinant
    return t if 0 < t < 1 and 0 < s < 1 else None


class Drawing:
    """y runs down, as in SVG."""

    def __init__(self, width, height, title):
        self.size = (width, height)
        self.title = title
        self.parts = []

    def _add(self, text):
        self.parts.append(text)

    def polygon(self, points, fill, opacity=1.0, stroke=None, width=1.0):
        edge = f' stroke="{stroke}" stroke-width="{number(width)}"' if stroke else ""
        listed = " ".join(f"{number(x)},{number(y)}" for x, y in points)
        self._add(f'<polygon points="{listed}" fill="{fill}" '
                  f'fill-opacity="{number(opacity)}"{edge}/>')

    def line(self, points, stroke=INK, width=1.5, dash=None):
        listed = " ".join(f"{number(x)},{number(y)}" for x, y in points)
        dashed = f' stroke-dasharray="{dash}"' if dash else ""
        self._add(f'<polyline points="{listed}" fill="none" stroke="{stroke}" '
                  f'stroke-width="{number(width)}"{dashed}/>')

    def arrow(self, p, q, stroke=INK, width=1.5, dash=None, at=1.0):
        """A line from p to q with its head at a share of the way."""
        self.line([p, q], stroke, width, dash)
        tip = along(p, q, at)
        angle = math.atan2(q[1] - p[1], q[0] - p[0])
        size = 5 + 1.5 * width
        wings = [(tip[0] - size * math.cos(angle + turn), tip[1] - size * math.sin(angle + turn))
                 for turn in (0.42, -0.42)]
        self.polygon([tip, *wings], stroke)

    def dot(self, p, fill=INK, radius=4.0, stroke=None):
        edge = f' stroke="{stroke}" stroke-width="1.5"' if stroke else ""
        self._add(f'<circle cx="{number(p[0])}" cy="{number(p[1])}" r="{number(radius)}" '
                  f'fill="{fill}"{edge}/>')

    def circle(self, p, radius, stroke=INK, width=1.5, fill="none", dash=None):
        dashed = f' stroke-dasharray="{dash}"' if dash else ""
        self._add(f'<circle cx="{number(p[0])}" cy="{number(p[1])}" r="{number(radius)}" '
                  f'fill="{fill}" stroke="{stroke}" stroke-width="{number(width)}"{dashed}/>')

    def text(self, p, words, size=13, fill=INK, anchor="start", bold=False):
        weight = ' font-weight="bold"' if bold else ""
        escaped = words.replace("&", "&amp;").replace("<", "&lt;")
        self._add(f'<text x="{number(p[0])}" y="{number(p[1])}" font-size="{number(size)}" '
                  f'fill="{fill}" text-anchor="{anchor}"{weight}>{escaped}</text>')

    def lamp(self, p, label="L"):
        for i in range(8):
            angle = math.pi * i / 4
            ray = (math.cos(angle), math.sin(angle))
            self.line([(p[0] + 8 * ray[0], p[1] + 8 * ray[1]),
                       (p[0] + 13 * ray[0], p[1] + 13 * ray[1])], LIGHT, 1.5)
        self.dot(p, LIGHT, 5.5)
        if label:
            self.text((p[0] + 16, p[1] + 5), label, fill=LIGHT, bold=True)

    def eye(self, p, label="eye"):
        self.dot(p, EYE, 5)
        self.text((p[0] - 2, p[1] + 20), label, fill=EYE, anchor="middle")

    def svg(self):
        width, height = self.size
        body = "\n".join(self.parts)
        return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
                f'viewBox="0 0 {width} {height}" font-family="sans-serif" role="img">\n'
                f"<title>{self.title}</title>\n"
                f'<rect width="{width}" height="{height}" fill="#ffffff"/>\n{body}\n</svg>\n')
