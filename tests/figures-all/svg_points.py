# SPDX-License-Identifier: MIT
"""What an SVG of ours says about single points: which color is there, as far as no line or letter is near."""

import math
import re
import unicodedata
import xml.etree.ElementTree

SVG = "{http://www.w3.org/2000/svg}"
NUMBER = r"-?[\d.]+"
RECTANGLE = re.compile(rf"M({NUMBER}) ({NUMBER})h({NUMBER})v({NUMBER})h-{NUMBER}z")
DOT = re.compile(rf"M({NUMBER}) ({NUMBER})a({NUMBER}) ")


def color_in(text):
    return tuple(int(text[i:i + 2], 16) for i in (1, 3, 5))


def declarations(text):
    return dict(part.split(":", 1) for part in text.split(";") if part)


def rules_in(css):
    """The properties of each class. Those of the same class are joined."""
    rules = {}
    for classes, body in re.findall(r"([^{}]+)\{([^{}]*)\}", css):
        for name in classes.split(","):
            rules.setdefault(name.rpartition(".")[2].strip(), {}).update(declarations(body))
    return rules


def style_rules(root, dark=False):
    """The rules of a figure's style sheet: those for light paper, or those for dark."""
    css = root.find(SVG + "style").text
    light, _, rest = css.partition("@media (prefers-color-scheme:dark){")
    return rules_in(rest.rsplit("}", 1)[0] if dark else light)


def subpaths(data):
    """Paths of M, L and Z, as lists of points; closed ones end where they began."""
    paths = []
    for part in data.split("M")[1:]:
        points = [tuple(map(float, pair.split())) for pair in part.rstrip("Z").split("L")]
        if part.endswith("Z"):
            points.append(points[0])
        paths.append(points)
    return paths


def distance_to(point, begin, end):
    """Of a point to a line between two."""
    dx, dy = end[0] - begin[0], end[1] - begin[1]
    length = dx * dx + dy * dy
    share = 0 if length == 0 else max(0, min(1, ((point[0] - begin[0]) * dx + (point[1] - begin[1]) * dy) / length))
    return math.dist(point, (begin[0] + share * dx, begin[1] + share * dy))


def is_inside(point, polygon):
    inside = False
    for (x1, y1), (x2, y2) in zip(polygon, polygon[1:]):
        if (y1 > point[1]) != (y2 > point[1]) and point[0] < x1 + (point[1] - y1) / (y2 - y1) * (x2 - x1):
            inside = not inside
    return inside


def box_of(text):
    """More than a line of text takes, whatever the font."""
    size = float(text.get("font-size"))
    columns = sum(0 if unicodedata.combining(c) else 2 if ord(c) > 0x2000 else 1 for c in text.text or "")
    width, x, y = columns * size * 0.8, float(text.get("x", "nan")), float(text.get("y", "nan"))
    left = {"start": x, "middle": x - width / 2, "end": x - width}[text.get("text-anchor", "start")]
    return (left - 3, y - 1.2 * size - 3, left + width + 3, y + 0.5 * size + 3)


class Points:
    """The colors of points of a figure that does not move."""

    CLEARANCE = 1.2  # what a line may be blurred by, in units

    def __init__(self, root, dark=False):
        rules = style_rules(root, dark)
        self.paper = color_in(rules["sheet"]["fill"])
        # In the order drawn: kind; what it is; an area's role; color; opacity, or half of a line's width.
        self.layers = []
        self.borders = []
        for element in root:
            classes = element.get("class", "").split()
            if element.tag == SVG + "text":
                if element.get("x") is None:
                    raise ValueError("a turned text; draw the figure without it")
                self.layers.append(("keep-off", box_of(element), None, None, 0))
            if element.tag != SVG + "path":
                continue
            data, own = element.get("d"), declarations(element.get("style", ""))
            role = rules.get(classes[1], {}) if len(classes) > 1 else {}
            if classes[0] == "area":
                rectangles = [tuple(map(float, found)) for found in RECTANGLE.findall(data)]
                self.layers.append(("area", rectangles, classes[1] if len(classes) > 1 else "own", color_in(own.get("fill") or role["fill"]),
                                    float(own.get("fill-opacity") or role.get("fill-opacity", 1))))
            elif classes[0] == "line":
                paths = subpaths(data)
                self.layers.append(("line", paths, None, None, float(role["stroke-width"]) / 2))
                if classes[1] == "border":
                    self.borders += paths
            elif "a" in data:
                for x, y, radius in DOT.findall(data):
                    x, y, radius = float(x), float(y), float(radius)
                    self.layers.append(("keep-off", (x - 1, y - radius - 1, x + 2 * radius + 1, y + radius + 1), None, None, 0))
            else:
                self.layers.append(("polygon", subpaths(data), None, color_in(own.get("fill") or role["fill"]),
                                    float(own.get("fill-opacity") or role.get("fill-opacity", 1))))

    def color_at(self, point):
        """The color there, and the role of the area ("own" if it has a color of its own; None: the paper). Nothing at all if
        a line or a letter is near."""
        color, role = self.paper, None
        for kind, what, of_area, paint, number in self.layers:
            covers = False
            if kind == "keep-off":
                if what[0] <= point[0] <= what[2] and what[1] <= point[1] <= what[3]:
                    return None
            elif kind == "area":
                covers = any(x <= point[0] < x + width and y <= point[1] < y + height for x, y, width, height in what)
                role = of_area if covers else role
            else:
                clearance = self.CLEARANCE + (number if kind == "line" else 0)
                if any(distance_to(point, begin, end) < clearance for path in what for begin, end in zip(path, path[1:])):
                    return None
                covers = kind == "polygon" and any(is_inside(point, path) for path in what)
            if covers:
                color = tuple(number * over + (1 - number) * under for over, under in zip(paint, color))
        return tuple(round(channel) for channel in color), role
