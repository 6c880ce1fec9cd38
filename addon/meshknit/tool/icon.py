"""The tool's icon, in the form of Blender's own toolbar icons: coloured triangles on a square.

    python3 addon/meshknit/tool/icon.py     # writes knit_time.dat beside this file"""

import math
import struct
from pathlib import Path

FILE = Path(__file__).resolve().with_name("knit_time")  # Blender adds .dat
SIDE = 255
EARLY, MIDDLE, LATE = (69, 117, 180, 255), (255, 224, 144, 255), (215, 70, 50, 255)
CHAIN = (255, 255, 255, 255)


def triangles():
    """-> [(three corners, colour)]: three rows that swing over a surface, the middle one drawn as a
    chain with its vertices."""
    found = []
    for middle, shade in ((60, EARLY), (190, LATE)):
        found += _band(middle, 34, shade)
    found += _band(125, 34, MIDDLE)
    found += _band(125, 12, CHAIN)
    for step in range(5):
        x = 30 + step * 49
        found += _disk(x, 125 + _swing(x), 15, CHAIN)
    return found


def _swing(x):
    return 22.0 * math.sin(2.0 * math.pi * (x - 20) / 215)


def _band(middle, width, shade, pieces=10):
    found = []
    xs = [20 + 215 * i / pieces for i in range(pieces + 1)]
    for a, b in zip(xs, xs[1:]):
        low = [(x, middle + _swing(x) - width / 2) for x in (a, b)]
        high = [(x, y + width) for x, y in low]
        found += [((low[0], low[1], high[1]), shade), ((low[0], high[1], high[0]), shade)]
    return found


def _disk(x, y, radius, shade, sides=8):
    turns = [2.0 * math.pi * i / sides for i in range(sides + 1)]
    rim = [(x + radius * math.cos(t), y + radius * math.sin(t)) for t in turns]
    return [(((x, y), a, b), shade) for a, b in zip(rim, rim[1:])]


def icon_bytes():
    """A head with the size and where drawing starts, then corners, then a colour per corner."""
    shapes = triangles()
    corners = [round(c) for points, _ in shapes for point in points for c in point]
    colors = [c for _, shade in shapes for _ in range(3) for c in shade]
    return struct.pack("4s4B", b"VCO\0", SIDE, SIDE, 0, 0) + bytes(corners) + bytes(colors)


if __name__ == "__main__":
    Path(f"{FILE}.dat").write_bytes(icon_bytes())
