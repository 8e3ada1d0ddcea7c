# SPDX-License-Identifier: MIT
"""A rasterizer in Python that tells what it decides: as triangle.c.

    python3 examples/foreign/triangle.py triangle.jsonl
"""
import math, sys
from rastertrace_emit import Trace

CORNERS = [("A", 2.0, 5.0), ("B", -4.0, -3.0), ("C", 5.0, -3.0)]  # y points up


def ends_of_row(y):
    """The crossings of the row with the edges: x, and the edge's name, the upper vertex first."""
    ends = []
    for one, other in zip(CORNERS, CORNERS[1:] + CORNERS[:1]):
        upper, lower = (one, other) if one[2] > other[2] else (other, one)
        if lower[2] <= y <= upper[2] and lower[2] != upper[2]:
            x = upper[1] + (upper[1] - lower[1]) / (upper[2] - lower[2]) * (y - upper[2])
            ends.append((x, upper[0] + lower[0]))
    return sorted(ends)


def main():
    trace = Trace(sys.argv[1], 17, 14, "center",
                  {"title": "Mine", "method": {"scalar": "double", "fill": "scanline", "rounding": "floor"}})
    trace.step("primitive", {"kind": "triangle", "name": "ABC", "vertices": [name for name, x, y in CORNERS],
                             "at": [[x, y] for name, x, y in CORNERS], "color": "#000000"})
    for y in range(5, -4, -1):
        (left, left_edge), (right, right_edge) = ends_of_row(y)
        first, last = math.floor(left), math.floor(right)
        trace.step("scanline", {"y": y, "left": left, "right": right, "from": first, "to": last,
                                "left_edge": left_edge, "right_edge": right_edge})
        for x in range(first, last + 1):
            trace.step("pixel", {"x": x, "y": y})
    trace.end()


main()
