#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws random triangles and lines with Mesa's software rasterizers and with `rastertrace`, by the convention opengl,
and counts the pixels in which they differ, by cause: a sample that lies on an edge, or halfway between two pixels of a
line (a tie); a pixel next to an end of a line; less than 1/256 pixel from one of these, where the driver snaps; else none.

usage: scripts/against-mesa.py PROGRAM [COUNT] [KIND] [DRIVER]

PROGRAM is rastertrace, KIND triangles or lines, DRIVER llvmpipe or softpipe. Vertices are multiples of 1/256 pixel
inside of the view. Needs libosmesa6-dev. Exit status 1: a triangle of llvmpipe differs, or a line of it without a cause.
"""

import json
import os
import random
import subprocess
import sys
import tempfile
from collections import Counter
from fractions import Fraction

SIDE = 32


def random_vertices(count, chance):
    """In pixels, from the bottom left; often on samples, and on one height or column."""
    grid = chance.choice([256, 256, 16, 2, 1])
    points = []
    for _ in range(count):
        point = [chance.randrange(0, SIDE * grid + 1) / grid for _ in range(2)]
        if points and chance.random() < 0.15:
            point[chance.randrange(2)] = points[-1][chance.randrange(2)]
        points.append(point)
    return points


def ours(program, kind, vertices, folder):
    names = "ABC"[:len(vertices)]
    scene = {
        "canvas": {"width": SIDE, "height": SIDE, "origin": "bottom-left"},
        "convention": "opengl",
        "vertices": {name: [2 * x / SIDE - 1, 2 * y / SIDE - 1, 0, 1] for name, (x, y) in zip(names, vertices)},
        kind: [names],
        "method": {"scalar": "fixed" if kind == "triangles" else "exact", "depth": "none"},
    }
    path = os.path.join(folder, "scene.json")
    with open(path, "w") as file:
        json.dump(scene, file)
    lines = subprocess.run([program, "trace", path], capture_output=True, check=True, text=True).stdout.splitlines()
    rows = [["."] * SIDE for _ in range(SIDE)]
    for line in lines:
        if line.startswith('{"step":"pixel"'):
            step = json.loads(line.rstrip(","))
            rows[SIDE - 1 - step["y"]][step["x"]] = "#"
    return "".join("".join(row) for row in rows)


def cause_of(kind, vertices, x, y):
    """Why a pixel may be drawn by one and not by the other."""
    corners = [(Fraction(px), Fraction(py)) for px, py in vertices]
    at = (x + Fraction(1, 2), y + Fraction(1, 2))
    snap = Fraction(1, 256)
    if kind == "triangles":
        distances = []
        for a, b in zip(corners, corners[1:] + corners[:1]):
            dx, dy = b[0] - a[0], b[1] - a[1]
            if longer := max(abs(dx), abs(dy)):
                distances.append(abs(dx * (at[1] - a[1]) - dy * (at[0] - a[0])) / longer)
        nearest = min(distances)
    else:
        a, b = corners
        if min(max(abs(end[0] - at[0]), abs(end[1] - at[1])) for end in corners) <= 1:
            return "end"
        major = 0 if abs(b[0] - a[0]) >= abs(b[1] - a[1]) else 1
        across = a[1 - major] + (at[major] - a[major]) * (b[1 - major] - a[1 - major]) / (b[major] - a[major])
        nearest = abs(abs(across - at[1 - major]) - Fraction(1, 2))
    return "tie" if nearest == 0 else "near a tie" if nearest <= snap else "none"


def main():
    program = os.path.abspath(sys.argv[1])
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 500
    kind = sys.argv[3] if len(sys.argv) > 3 else "triangles"
    driver = sys.argv[4] if len(sys.argv) > 4 else "llvmpipe"
    chance = random.Random(40)
    scenes = [random_vertices(3 if kind == "triangles" else 2, chance) for _ in range(count)]
    text = "".join(
        f"{kind[0]} {SIDE} {SIDE} " + " ".join(repr(2 * c / SIDE - 1) for point in vertices for c in point) + "\n"
        for vertices in scenes)
    with tempfile.TemporaryDirectory() as folder:
        drawer = os.environ.get("OSMESA_DRAW") or os.path.join(folder, "osmesa_draw")
        if "OSMESA_DRAW" not in os.environ:
            here = os.path.dirname(os.path.abspath(__file__))
            subprocess.run(["cc", "-O1", "-o", drawer, os.path.join(here, "osmesa_draw.c"), "-lOSMesa"], check=True)
        theirs = subprocess.run([drawer], input=text, capture_output=True, text=True, check=True,
                                env=dict(os.environ, GALLIUM_DRIVER=driver)).stdout.splitlines()
        renderer, pictures = theirs[0], theirs[1:]
        differing = pixels = more = fewer = 0
        causes = Counter()
        for vertices, picture in zip(scenes, pictures):
            own = ours(program, kind, vertices, folder)
            pixels += picture.count("#")
            if own == picture:
                continue
            differing += 1
            extra = sum(a == "#" and b == "." for a, b in zip(own, picture))
            missing = sum(a == "." and b == "#" for a, b in zip(own, picture))
            causes.update(cause_of(kind, vertices, i % SIDE, SIDE - 1 - i // SIDE)
                          for i in range(SIDE * SIDE) if own[i] != picture[i])
            more += extra
            fewer += missing
            if differing <= 5:
                print(f"{vertices}: {extra} pixels more, {missing} fewer than {renderer.split()[0]}")
    print(f"{renderer}: {count} {kind}, {pixels} pixels; {differing} differ, by {more} pixels more and {fewer} fewer; "
          f"causes: {', '.join(f'{cause} {n}' for cause, n in sorted(causes.items())) or 'none needed'}")
    unexplained = differing if kind == "triangles" else causes["none"]
    sys.exit(1 if unexplained and driver == "llvmpipe" else 0)


main()
