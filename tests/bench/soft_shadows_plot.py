"""Error against time as an SVG: one panel per case, both axes logarithmic."""

import math

PANEL, LEFT, TOP, COLUMNS = (300, 200), 56, 34, 2
SERIES = {"looked up": ("#009e73", "N points, looked up"), "points": ("#0072b2", "N points, volumes"),
          "PCF": ("#999999", "map, PCF"),
          "PCSS": ("#d55e00", "map, PCSS")}  # colours by Okabe and Ito


def series_of(name):
    return next(key for key in SERIES if key in name.replace("point", "points"))


def decades(values):
    return math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))


def panel(title, rows, x0, y0):
    """One case: frame time against RMS error."""
    width, height = PANEL
    (x_low, x_high), (y_low, y_high) = (decades([row["ms"] for row in rows.values()]),
                                        decades([row["error"]["rms"] for row in rows.values()]))

    def place(row):
        return (x0 + width * (math.log10(row["ms"]) - x_low) / (x_high - x_low),
                y0 + height * (y_high - math.log10(row["error"]["rms"])) / (y_high - y_low))

    parts = [f'<text x="{x0}" y="{y0 - 8}" font-weight="bold">{title}</text>',
             f'<rect x="{x0}" y="{y0}" width="{width}" height="{height}" fill="none" stroke="#888"/>']
    for power in range(x_low, x_high + 1):
        x = x0 + width * (power - x_low) / (x_high - x_low)
        parts.append(f'<path d="M{x:.1f} {y0}v{height}" stroke="#ddd"/><text x="{x:.1f}" '
                     f'y="{y0 + height + 14}" text-anchor="middle">{10.0 ** power:g} ms</text>')
    for power in range(y_low, y_high + 1):
        y = y0 + height * (y_high - power) / (y_high - y_low)
        parts.append(f'<path d="M{x0} {y:.1f}h{width}" stroke="#ddd"/><text x="{x0 - 5}" '
                     f'y="{y + 4:.1f}" text-anchor="end">{10.0 ** power:g} %</text>')
    for key, (colour, _) in SERIES.items():
        points = [place(row) for name, row in rows.items() if series_of(name) == key]
        line = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        parts.append(f'<polyline points="{line}" fill="none" stroke="{colour}"/>')
        parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{colour}"/>' for x, y in points]
    return parts


def write_plot(path, cases):
    width, height = PANEL
    rows = math.ceil(len(cases) / COLUMNS)
    total = (COLUMNS * (width + LEFT + 24), rows * (height + TOP + 30) + 30)
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {total[0]} {total[1]}" '
             'font-family="sans-serif" font-size="11">',
             f'<rect width="{total[0]}" height="{total[1]}" fill="#fff"/>']
    for index, (title, of) in enumerate(cases.items()):
        parts += panel(title, of["rows"], LEFT + index % COLUMNS * (width + LEFT + 24),
                       TOP + index // COLUMNS * (height + TOP + 30))
    for index, (colour, label) in enumerate(SERIES.values()):
        x, y = LEFT + 150 * index, total[1] - 14
        parts.append(f'<circle cx="{x}" cy="{y - 4}" r="4" fill="{colour}"/>'
                     f'<text x="{x + 9}" y="{y}">{label}</text>')
    path.write_text("\n".join(parts) + "\n</svg>\n")
