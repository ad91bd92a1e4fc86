"""The figure of docs/architecture.md: from a file to a frame."""

from drawing import CAP, CASTER, FAINT, INK, SIDE, Drawing

BOX = (142, 40)


def box(d, x, y, words, colour=INK):
    width, height = BOX
    d.polygon([(x, y), (x + width, y), (x + width, y + height), (x, y + height)], "#f6f8fa", 1,
              colour, 1.4)
    first = y + 24 - 7.5 * (len(words) - 1)
    for i, line in enumerate(words):
        d.text((x + width / 2, first + 15 * i), line, size=12, anchor="middle")


def row(d, y, boxes, colour):
    """Boxes in a row, each fed by the one before it."""
    for i, words in enumerate(boxes):
        x = 16 + 182 * i
        box(d, x, y, words, colour)
        if i:
            d.arrow((x - 182 + BOX[0], y + BOX[1] / 2), (x, y + BOX[1] / 2), INK, 1.4)


def flow():
    d = Drawing(724, 420, "From a file to a frame")
    rows = (
        (40, "preprocess/: triangles in, records out, no GL", CASTER,
         (("read", "glTF, Draco, meshopt"), ("flatten", "nodes to batches"),
          ("weld, edges", "equal positions"), ("records", "planes, clusters"))),
        (150, "src/scene/: once a scene", CASTER,
         (("LoadedScene", "on the CPU"), ("GpuScene", "surfaces, records"))),
        (260, "src/render/: once a frame, no GL: what to draw, and why", CAP,
         (("FrameView", "near plane, slices"), ("LayerBound", "groups of casters"),
          ("FramePlan", "every draw, in order"), ("Proposal", "can be silhouettes"))),
        (360, "src/render/ and shaders_es2/: once a slice, on the GPU", SIDE,
         (("depth, ambient", "and first light"), ("volumes", "into the stencil"),
          ("darken counted", "the first light"), ("lit", "further lights"))),
    )
    for y, title, colour, boxes in rows:
        d.text((16 if y == 40 else 98, y - 10), title, size=12, fill=colour, bold=True)
        row(d, y, boxes, colour)
    for x, y, down in ((633, 80, 115), (269, 190, 225), (633, 300, 325)):
        d.line([(x, y), (x, down), (87, down)], FAINT, 1.4)
        d.arrow((87, down), (87, down + 35), FAINT, 1.4)
    d.text((395, 165), "a packed file takes the same way:", size=12, fill=FAINT)
    d.text((395, 181), "what it stores is checked, not trusted", size=12, fill=FAINT)
    return d
