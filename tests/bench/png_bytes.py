"""Reads pictures that the program has written and joins them, with Python's own library only."""

import dataclasses
import struct
import zlib

CHANNELS = {0: 1, 2: 3, 6: 4}


@dataclasses.dataclass
class Picture:
    width: int
    height: int
    channels: int
    rows: list  # of bytes, top to bottom


def paeth(left, up, corner):
    guess = left + up - corner
    away = (abs(guess - left), abs(guess - up), abs(guess - corner))
    return (left, up, corner)[away.index(min(away))]


def unfiltered(kind, row, previous, step):
    """Removes the filter from a row of the PNG's bytes (PNG 9.2)."""
    for i in range(len(row)):
        left = row[i - step] if i >= step else 0
        corner = previous[i - step] if i >= step else 0
        add = (0, left, previous[i], (left + previous[i]) // 2, 0)[kind]
        if kind == 4:
            add = paeth(left, previous[i], corner)
        row[i] = (row[i] + add) & 255
    return row


def read_png(path):
    """Reads a picture of 8 bits a channel that isn't interlaced."""
    data = path.read_bytes()
    place, packed = 8, b""
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        body = data[place + 8:place + 8 + length]
        place += 12 + length
        if kind == b"IHDR":
            width, height, _, colours = struct.unpack(">IIBB", body[:10])
        elif kind == b"IDAT":
            packed += body
    step = CHANNELS[colours]
    raw, size = zlib.decompress(packed), width * step
    rows, previous = [], bytearray(size)
    for y in range(height):
        start = y * (size + 1)
        previous = unfiltered(raw[start], bytearray(raw[start + 1:start + 1 + size]), previous, step)
        rows.append(previous)
    return Picture(width, height, step, rows)


def write_png(path, picture):
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    colours = next(key for key, step in CHANNELS.items() if step == picture.channels)
    header = struct.pack(">IIBBBBB", picture.width, picture.height, 8, colours, 0, 0, 0)
    raw = b"".join(b"\0" + bytes(row) for row in picture.rows)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
                     + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))


def side_by_side(pictures, gap=4):
    """Joins pictures in one row, with a white gap between them."""
    step = pictures[0].channels
    white = b"\xff" * (gap * step)
    rows = [white.join(bytes(of.rows[y]) for of in pictures) for y in range(pictures[0].height)]
    return Picture(len(rows[0]) // step, len(rows), step, rows)
