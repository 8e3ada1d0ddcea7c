# SPDX-License-Identifier: MIT
"""The figures that check_figures.py has other programs read: scenes of its own, and what is asked of each figure."""

import json
import os

# What a file of figures must keep from the reader's program: signs of XML, of TeX and of terminals, line ends, letters
# from right to left, wide ones, and such that need two units of UTF-16.
HOSTILE = "<b>&\"'</title> ]]> --> \\def $x$ %#_^~{}\nsecond \x1b[31mred \u202e \u05e9\u05dc\u05d5\u05dd \u4e2d\u6587 \U0001F600 \u00e9"
HOSTILE_NAMES = ["A<&\"'>", "\\input%$#_^~{}", "\u202e\u05e9\x1b[2J\n", "\u4e2d\u6587\U0001F600"]

SCENES = {
    "hostile": {"title": HOSTILE, "canvas": {"width": 14, "height": 12},
                "vertices": dict(zip(HOSTILE_NAMES, [[-5, -4], [4, -3], [0, 4], [5, 4]])),
                "triangles": [{"vertices": HOSTILE_NAMES[:3], "name": "T-" + HOSTILE}],
                "lines": [[HOSTILE_NAMES[3], HOSTILE_NAMES[0]]]},
    "one-pixel": {"title": "One", "canvas": {"width": 1, "height": 1, "origin": "top-left"},
                  "vertices": {"A": [0, 0]}, "points": ["A"]},
    "large": {"title": "Large", "canvas": {"width": 300, "height": 200, "origin": "top-left"},
              "vertices": {"A": [3, 5], "B": [290, 60], "C": [120, 195], "D": [20, 150], "E": [280, 190], "F": [200, 8]},
              "triangles": [{"vertices": "ABC", "color": "#3060c0"}, {"vertices": "DEF", "color": "#d08020"}],
              "method": {"scalar": "exact", "fill": "top-left"}},
    "nothing": {"title": "Nothing is drawn", "canvas": {"width": 6, "height": 5},
                "vertices": {"A": [40, 0], "B": [50, 0], "C": [40, 9]}, "triangles": ["ABC"]},
    "shared": {"title": "A shared edge", "canvas": {"width": 12, "height": 9, "origin": "bottom-left"},
               "vertices": {"A": [0.5, 0.5], "B": [10, 1.25], "C": [9, 8], "D": [1, 7]},
               "triangles": [{"vertices": "ABC", "color": "#c03030"}, {"vertices": "ACD", "color": "#3070c0"}],
               "method": {"scalar": "exact", "fill": "top-left", "sample": "center"}},
    "background": {"title": "Night", "canvas": {"width": 9, "height": 7}, "background": "#102040",
                   "vertices": {"A": [-3, -2], "B": [3, -2], "C": [0, 3]}, "triangles": [{"vertices": "ABC", "color": "#ffd040"}]},
}


class Figure:
    """A figure to draw, with `options` of the command.

    `drawn`: the raster is that of the last frame, or of the row `last_row`, so that its pixels are known.
    `has_background`: also pixels that nothing has drawn have a color."""

    def __init__(self, name, scene, options=(), drawn=True, last_row=None, has_background=False):
        self.name, self.scene, self.options = name, scene, list(options)
        self.drawn, self.last_row, self.has_background = drawn, last_row, has_background

    @property
    def is_latin(self):
        """False if it has letters that not every font has."""
        return not self.name.startswith("hostile")

    def value_of(self, option, default=None):
        return self.options[self.options.index(option) + 1] if option in self.options else default


def figures(source, folder):
    """All figures; the scenes above are written into the folder."""
    def example(name):
        return os.path.join(source, "examples", name + ".json")

    def own(name):
        path = os.path.join(folder, "scene-" + name + ".json")
        with open(path, "w", encoding="utf-8") as file:
            json.dump(SCENES[name], file)
        return path

    triangle = example("t0-fill/first-triangle")
    depths = example("t0-hidden/two-depths")
    row = ["--step", "scanline y=2"]
    return [
        Figure("plotted", triangle),
        Figure("dark", triangle, ["--theme", "dark", "--with", "samples"]),
        Figure("order", triangle, ["--with", "order"]),
        Figure("light", triangle, ["--theme", "light", "--without", "axes,title,legend"]),
        Figure("row", triangle, row + ["--with", "working"], last_row=2),
        Figure("question", triangle, ["--until", "scanline y=2", "--caption", "Which pixels? x < 3 & y > 0"], drawn=False),
        Figure("rows", triangle, ["--every", "scanline", "--sheet", "3x3", "--cell", "14", "--without", "title"], drawn=False),
        Figure("truncated", triangle, ["--against", "rounding=truncate"]),
        Figure("faces", example("t0-hidden/cube-culled"), ["--view", "faces"]),
        Figure("many-faces", example("t0-hidden/two-cubes"), ["--view", "faces"]),
        Figure("shared-edge", own("shared"), ["--with", "half-planes,samples", "--step", "edge edge=CA in=ABC"], drawn=False),
        Figure("shade", example("t4-fan/blue-to-green"), ["--view", "shade"]),
        Figure("lambert", example("t3-light/lambert"), ["--view", "shade", "--theme", "dark"]),
        Figure("background", own("background"), ["--view", "shade"], has_background=True),
        Figure("depths", depths, ["--view", "depth", "--with", "depths"]),
        Figure("depths-of-a-row", depths, ["--step", "scanline in=DEF y=2", "--with", "plot"], drawn=False),
        Figure("writes", depths, ["--view", "writes", "--with", "writes"]),
        Figure("weights", example("t3-sweep-and-box/barycentric"), ["--with", "weights", "--cell", "44"]),
        Figure("rejected", example("t3-sweep-and-box/barycentric"), ["--with", "rejected"]),
        Figure("scene", example("t0-hidden/cube-culled"), ["--with", "space"]),
        Figure("projection", example("t0-projection/box"), ["--with", "space"]),
        Figure("errors", example("t2-lines/bresenham"), ["--with", "errors"]),
        Figure("octants", example("t2-lines/octants"), ["--without", "vertices"]),
        Figure("hidden-lines", example("t1-hidden/hidden-lines")),
        Figure("culled", example("t0-hidden/cube-culled"), ["--step", "face culled name=BFG", "--with", "space"], drawn=False),
        Figure("in-space", example("t4-pipeline/behind-the-eye"), ["--view", "space", "--step", "clip"], drawn=False),
        Figure("sight", example("t0-hidden/cube-inverse-z"), ["--view", "space", "--step", "370"], drawn=False),
        Figure("hostile", own("hostile"), ["--caption", HOSTILE]),
        Figure("hostile-faces", own("hostile"), ["--view", "faces"]),
        Figure("one-pixel", own("one-pixel")),
        Figure("nothing", own("nothing")),
        Figure("large", own("large"), ["--view", "faces"]),
        Figure("large-cells", own("large"), ["--region", "100,50,119,61", "--view", "shade"]),
        Figure("region", triangle, ["--region", "-2,-1,3,4"]),
        Figure("bare", triangle, ["--bare", "--cell", "7"]),
        Figure("bare-and-dark", triangle, ["--bare", "--cell", "7", "--theme", "dark"]),
    ]
