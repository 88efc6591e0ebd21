"""Makes the PNG files of `arris render` small: a palette of at most 256 colours.

Only what that command writes is understood: 8 bits a channel, three channels, not interlaced.
"""
import struct
import zlib

SIGNATURE = b"\x89PNG\r\n\x1a\n"
TRUE_COLOUR, PALETTE = 2, 3


def chunks(data):
    at = len(SIGNATURE)
    while at < len(data):
        length, kind = struct.unpack_from(">I4s", data, at)
        yield kind, data[at + 8:at + 8 + length]
        at += length + 12


def chunk(kind, body):
    return struct.pack(">I", len(body)) + kind + body + struct.pack(
        ">I", zlib.crc32(kind + body))


def paeth(a, b, c):
    p = a + b - c
    pa, pb, pc = abs(p - a), abs(p - b), abs(p - c)
    return a if pa <= pb and pa <= pc else b if pb <= pc else c


def unfiltered(raw, width, height):
    """The rows of pixels behind the filters of the PNG format."""
    stride, rows, above = 3 * width, [], bytes(3 * width)
    for y in range(height):
        begin = y * (stride + 1)
        kind, row = raw[begin], bytearray(raw[begin + 1:begin + 1 + stride])
        for x in range(stride if kind else 0):
            left = row[x - 3] if x >= 3 else 0
            corner = above[x - 3] if x >= 3 else 0
            guess = (left, above[x], (left + above[x]) // 2, paeth(left, above[x], corner))
            row[x] = (row[x] + guess[kind - 1]) & 255
        rows.append(bytes(row))
        above = rows[-1]
    return rows


def rounded(rows, bits):
    """The pixels with so many bits a channel, as a list of rows of colours."""
    keep = 256 - (1 << (8 - bits))
    table = bytes((v & keep) | (v & keep) >> bits for v in range(256))
    rows = [row.translate(table) for row in rows]
    return [[row[x:x + 3] for x in range(0, len(row), 3)] for row in rows]


def small(data):
    """The same picture with a palette; `data` itself where that is no PNG of the kind above."""
    parts = list(chunks(data)) if data.startswith(SIGNATURE) else []
    if not parts or parts[0][0] != b"IHDR":
        return data
    width, height, depth, colour, _, _, interlace = struct.unpack(">IIBBBBB", parts[0][1])
    if (depth, colour, interlace) != (8, TRUE_COLOUR, 0):
        return data
    raw = zlib.decompress(b"".join(body for kind, body in parts if kind == b"IDAT"))
    rows = unfiltered(raw, width, height)
    for bits in (5, 4, 3, 2):
        pixels = rounded(rows, bits)
        colours = sorted({p for row in pixels for p in row})
        if len(colours) <= 256:
            break
    index = {c: i for i, c in enumerate(colours)}
    packed = b"".join(b"\0" + bytes(index[p] for p in row) for row in pixels)
    header = struct.pack(">IIBBBBB", width, height, 8, PALETTE, 0, 0, 0)
    return SIGNATURE + chunk(b"IHDR", header) + chunk(b"PLTE", b"".join(colours)) + chunk(
        b"IDAT", zlib.compress(packed, 9)) + chunk(b"IEND", b"")
