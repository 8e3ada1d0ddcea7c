# SPDX-License-Identifier: MIT
"""Writes the trace of a rasterizer. What is wrong raises ValueError, what cannot be written OSError.
    trace = Trace("mine.jsonl", 17, 14, "center", {"title": "Mine", "method": {"fill": "scanline"}})
    trace.step("pixel", {"x": -1, "y": 2})
    trace.end()
"""
import collections, json, math, os, sys

NEEDED = {kind: keys for kind, *keys in map(str.split, """triangulate name,matrix name,vertex name space,face dot,
primitive kind name,light intensity,clip plane,edge edge,half half,ray x y,crossings y,skip why,pixel x y,sample x y,
scanline y left right from to,along value pixel,decide x y d move,depth x y depth,reject why""".split(","))}

def told(value):
    if isinstance(value, (list, tuple)):
        return [told(one) for one in value]
    if isinstance(value, float) and not math.isfinite(value):
        return "NaN" if math.isnan(value) else "inf" if value > 0 else "-inf"
    return value + 0.0 if isinstance(value, float) else value  # -0 is 0

class Trace:
    def __init__(self, path, width, height, origin, header):
        self.file, self.count = open(path, "w"), collections.Counter()
        self.write({"rastertrace": 1, "canvas": {"width": width, "height": height, "origin": origin}, **header})

    def write(self, line):
        self.file.write(json.dumps(line, separators=(",", ":")) + "\n")

    def step(self, kind, fields):
        caller = sys._getframe(1)
        place = f"{os.path.basename(caller.f_code.co_filename)}:{caller.f_lineno}"
        missing = [key for key in NEEDED.get(kind, []) if key not in fields]
        if missing or self.file.closed:
            raise ValueError(f"{kind} in {place}: expected {(missing or ['it before the end'])[0]}")
        self.count[kind] += 1
        self.write({"step": kind, **{key: told(value) for key, value in fields.items()}, "code": place})

    def end(self):
        self.write({"end": {"steps": self.count.total(), "count": self.count}})
        self.file.close()
