# SPDX-License-Identifier: MIT
"""The renderer of renderer.c in Python. It writes the trace into a file:

    python3 examples/foreign/renderer.py scene.txt mine.jsonl [top-left]
"""
import sys
from rastertrace_emit import Trace

TOP_LEFT = "top-left" in sys.argv[3:]


def edge(a, b, p):
    """Twice the area of a triangle: positive if it runs clockwise, where y points down."""
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])


def covers(a, b, p):
    """True if a sample is on the inner side of an edge."""
    e = edge(a, b, p)
    is_top_left = b[1] < a[1] or (b[1] == a[1] and b[0] > a[0])
    return e > 0 or (e == 0 and (is_top_left or not TOP_LEFT))


def fill(trace, v, width, height):
    if edge(*v) < 0:  # the other way round
        v = [v[0], v[2], v[1]]
    if edge(*v) == 0:
        return
    for y in range(height):
        for x in range(width):
            p = (x + 0.5, y + 0.5)
            if covers(v[1], v[2], p) and covers(v[2], v[0], p) and covers(v[0], v[1], p):
                trace.step("pixel", {"x": x, "y": y})


def main():
    lines = [line.split() for line in open(sys.argv[1])]
    width, height = int(lines[0][1]), int(lines[0][2])
    trace = Trace(sys.argv[2], width, height, "top-left", {"method": {"fill": "top-left", "sample": "center"}})
    for _, name, *numbers in lines[1:]:
        at = [float(number) for number in numbers[:9]]  # behind them is a color
        corners = [at[0:2], at[3:5], at[6:8]]
        trace.step("primitive", {"kind": "triangle", "name": name, "at": corners})
        fill(trace, corners, width, height)
    trace.end()


main()
