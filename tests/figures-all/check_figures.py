#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Has figures read by programs that others wrote: a browser, librsvg, LaTeX and Pillow.

    check_figures.py PROGRAM SOURCE_FOLDER

The figures are those of figure_list.py. Their colors are compared in chosen pixels: places in the squares of the raster
that no line and no letter comes near. Which squares are drawn is counted from the steps of the trace, what color they
have is read from the style sheet of the SVG.
"""

import json
import math
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import unicodedata
import xml.etree.ElementTree

from PIL import Image, ImageChops, ImageFilter

import figure_list
import svg_points

PROGRAM, SOURCE = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
TRIANGLE = os.path.join(SOURCE, "examples", "t0-fill", "first-triangle.json")
failures = []
counted = {}


def fail(message):
    failures.append(message)


def count(what, number=1):
    counted[what] = counted.get(what, 0) + number


def run(*words, **options):
    """What a program prints; whatever else it does is a failure of the test."""
    result = subprocess.run(words, capture_output=True, text=True, errors="replace", timeout=300, check=False, **options)
    if result.returncode:
        raise RuntimeError(f"{' '.join(words)}\nends with {result.returncode}:\n{result.stdout[-2000:]}\n{result.stderr[-2000:]}")
    return result.stdout


def rastertrace(*words):
    return run(PROGRAM, *words)


# --- the raster, from the steps of its trace ------------------------------------------------------------------------


class Raster:
    """The pixels that a trace has drawn, by column and row from the upper left, and the color of each. With `last_row`,
    up to that row of the first triangle; its pixels are `current`."""

    def __init__(self, scene, method=(), last_row=None):
        lines = [json.loads(line) for line in rastertrace("trace", scene, "--format", "jsonl", *method).splitlines()]
        canvas = lines[0]["canvas"]
        self.width, self.height, self.origin = canvas["width"], canvas["height"], canvas["origin"]
        self.colors, self.current, color, is_last = {}, set(), None, False
        for step in lines[1:-1]:
            if step["step"] == "primitive":
                color = step["color"]
            if is_last and step["step"] != "pixel":
                break
            is_last = last_row is not None and (is_last or step["step"] == "scanline" and step["y"] == last_row)
            if step["step"] == "pixel":
                square = self.square(step["x"], step["y"])
                self.colors[square] = step.get("color", color)
                if is_last:
                    self.current.add(square)

    def square(self, x, y):
        if self.origin == "center":
            return math.floor(self.width / 2 + x), math.floor(self.height / 2 - y)
        return x, (y if self.origin == "top-left" else self.height - 1 - y)


class Expected:
    """What the squares of a figure of the list should be."""

    def __init__(self, figure):
        self.figure = figure
        self.raster = Raster(figure.scene, last_row=figure.last_row)
        self.columns, self.rows = range(self.raster.width), range(self.raster.height)
        region = figure.value_of("--region")
        if region:
            x0, y0, x1, y1 = map(int, region.split(","))
            columns, rows = zip(self.raster.square(x0, y0), self.raster.square(x1, y1))
            self.columns, self.rows = range(min(columns), max(columns) + 1), range(min(rows), max(rows) + 1)
        method = figure.value_of("--against")
        self.other = method and Raster(figure.scene, ["--" + word for word in method.split("=")][:1] + method.split("=")[1:])

    def is_covered(self, square):
        return (square in self.raster.colors or self.figure.has_background
                or self.other is not None and square in self.other.colors)

    def roles(self, square):
        """Those that it may have."""
        if not self.is_covered(square):
            return {None}
        if self.other is not None:
            if square not in self.other.colors:
                return {"only-here"}
            return {"same"} if square in self.raster.colors else {"only-there"}
        if self.figure.last_row is not None:
            return {"current"} if square in self.raster.current else {"plotted"}
        return {"own", "ink", "plotted", "current"} | {f"face-{number}" for number in range(1, 9)}

    def color(self, square):
        """None: whatever the style sheet has for it."""
        if self.figure.value_of("--view") != "shade" or not self.is_covered(square):
            return None
        return svg_points.color_in(self.raster.colors.get(square, "#102040"))


# --- chosen pixels --------------------------------------------------------------------------------------------------


# Of a square, in its sides: where to look for a place.
TRIED = ((0.5, 0.5), (0.25, 0.3), (0.72, 0.3), (0.28, 0.72), (0.75, 0.7), (0.5, 0.14), (0.5, 0.86))
MOST_SQUARES = 60  # that are looked at, of those drawn and of the others


def raster_in(points, root, expected):
    """Left, top and the side of a square, in units; None if the raster cannot be found."""
    columns, rows = len(expected.columns), len(expected.rows)
    if "--bare" in expected.figure.options:
        return 0.0, 0.0, float(root.get("width")) / columns
    for path in points.borders:
        (left, top), (right, _), (_, bottom) = path[:3]
        if math.isclose((right - left) / columns, (bottom - top) / rows, rel_tol=1e-9):
            return left, top, (right - left) / columns
    return None


def chosen_points(root, expected):
    """Places in squares of the raster: (x, y, color by the style sheet). Fails if the SVG covers others than are drawn."""
    name = expected.figure.name + ".svg"
    points = svg_points.Points(root)
    raster = raster_in(points, root, expected)
    if raster is None:
        fail(f"{name}: no border around {len(expected.columns)} x {len(expected.rows)} pixels")
        return []
    left, top, side = raster
    squares = [(column, row) for column in expected.columns for row in expected.rows]
    chance = random.Random(20261123)
    found, searched = [], 0
    for is_covered in (True, False):
        group = [square for square in squares if expected.is_covered(square) == is_covered]
        for square in group if len(group) <= MOST_SQUARES else chance.sample(group, MOST_SQUARES):
            searched += 1
            for dx, dy in TRIED:
                # The middle of a pixel of the picture, as a screen has it.
                x = math.floor(left + (square[0] - expected.columns[0] + dx) * side) + 0.5
                y = math.floor(top + (square[1] - expected.rows[0] + dy) * side) + 0.5
                at = points.color_at((x, y))
                if at is None:
                    continue
                color, role = at
                if role not in expected.roles(square):
                    fail(f"{name}: column {square[0]}, row {square[1]} is {role}, not {expected.roles(square)}")
                if expected.color(square) not in (None, color):
                    fail(f"{name}: column {square[0]}, row {square[1]} is {color}, its pixel {expected.color(square)}")
                found.append((x, y, color))
                break
    if len(found) < searched / 4 or not found:
        fail(f"{name}: only {len(found)} of {searched} squares have a place that nothing is written in")
    return found


def check_points(name, image, points, scale=1.0, tolerance=0):
    """The picture has the colors of the points. `scale`: pixels of a unit."""
    wrong = []
    for x, y, color in points:
        at = (int(x * scale), int(y * scale))
        if at[0] >= image.width or at[1] >= image.height:
            wrong.append(f"{at} is not on the picture")
        else:
            got = image.getpixel(at)
            if max(abs(a - b) for a, b in zip(got, color)) > tolerance:
                wrong.append(f"{at} is {got}, not {color}")
    count("chosen pixels", len(points))
    if wrong:
        fail(f"{name}: {len(wrong)} of {len(points)} chosen pixels are wrong, the first: {wrong[0]}")


# --- SVG ------------------------------------------------------------------------------------------------------------

KNOWN_TAGS = {"svg", "title", "desc", "style", "rect", "path", "text", "g"}


def check_text(name, root, text):
    """Well-formed is what could be read. It has a title, a description, and nothing that it would ask a server for."""
    for tag in ("title", "desc"):
        element = root.find(svg_points.SVG + tag)
        if element is None or not (element.text or "").strip():
            fail(f"{name}: no {tag}")
    for element in root.iter():
        tag = element.tag.replace(svg_points.SVG, "")
        if tag not in KNOWN_TAGS:
            fail(f"{name}: an element {element.tag}")
        for attribute in element.keys():
            if attribute.startswith("on") or re.search("href|src|base$", attribute):
                fail(f"{name}: an attribute {attribute}")
    css = "".join(element.text for element in root.iter(svg_points.SVG + "style"))
    css += " ".join(element.get("style", "") for element in root.iter())
    if re.search(r"url|@import|@font-face|expression|\\", css):
        fail(f"{name}: its style sheet may refer to another file")
    if re.search(r"<!DOCTYPE|<!ENTITY|<\?xml-stylesheet", text):
        fail(f"{name}: a document type or a style sheet from elsewhere")
    for character in "".join(root.itertext()):
        if unicodedata.category(character) in ("Cc", "Cs") and character != "\n" or character in "\u202a\u202b\u202d\u202e":
            fail(f"{name}: the character U+{ord(character):04X}")


# Two programs smooth letters and slanted lines in their own ways. So pictures are compared out of focus. Letters beyond
# Latin each program takes from whatever font it finds, so with these only the average counts.
BLUR = 2  # pixels
MOST_DIFFERENCE = 40  # of 255, anywhere
MOST_MEAN = 1.5  # of 255, on the average of the picture


def check_alike(name, one, other, is_latin):
    if one.size != other.size:
        fail(f"{name}: {one.size} by librsvg, {other.size} by Chromium")
        return
    difference = ImageChops.difference(*(image.filter(ImageFilter.GaussianBlur(BLUR)) for image in (one, other))).convert("L")
    largest = difference.getextrema()[1]
    histogram = difference.histogram()
    mean = sum(level * number for level, number in enumerate(histogram)) / (one.width * one.height)
    if os.environ.get("VERBOSE"):
        print(name, largest, round(mean, 3))
    if is_latin and largest > MOST_DIFFERENCE or mean > MOST_MEAN:
        fail(f"{name}: librsvg and Chromium draw it differently, by {largest} somewhere and {mean:.2f} on the average")


def image_of(path):
    with Image.open(path) as image:
        return image.convert("RGB")


class Page:
    """A page of pictures for Chromium, and where each of them is."""

    def __init__(self, folder):
        self.folder, self.width, self.x, self.y, self.line = folder, 1900, 0, 0, 0
        self.html, self.places = "", []

    def add(self, path, width, height, scheme):
        """Returns the number of the picture."""
        if self.x and self.x + width > self.width:
            self.x, self.y, self.line = 0, self.y + self.line, 0
        # An SVG in a page is light or dark as the element that has it.
        self.html += (f'<img src="{os.path.basename(path)}" style="position:absolute;left:{self.x}px;top:{self.y}px;'
                      f'width:{width}px;height:{height}px;color-scheme:{scheme}">\n')
        self.places.append((self.x, self.y, self.x + width, self.y + height))
        self.x += width
        self.line = max(self.line, height)
        return len(self.places) - 1

    def pictures(self):
        """All of them, drawn by one run."""
        page, picture = (os.path.join(self.folder, "page." + ending) for ending in ("html", "png"))
        with open(page, "w", encoding="utf-8") as file:
            file.write(f'<!DOCTYPE html><meta charset="utf-8"><body style="margin:0;background:#00ff00">{self.html}</body>')
        chromium(f"--window-size={self.width},{self.y + self.line}", f"--screenshot={picture}", page)
        whole = image_of(picture)
        return [whole.crop(place) for place in self.places]


def chromium(*words):
    """Runs it without a screen; the last word is a file."""
    with tempfile.TemporaryDirectory() as profile:
        return run("chromium", "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--force-device-scale-factor=1",
                   "--disable-lcd-text", "--default-background-color=ffffffff", "--disable-background-networking",
                   "--host-resolver-rules=MAP * ~NOTFOUND", "--allow-file-access-from-files", f"--user-data-dir={profile}",
                   *words[:-1], "file://" + words[-1])


def by_librsvg(path):
    picture = path + ".librsvg.png"
    run("rsvg-convert", path, "-o", picture)
    return image_of(picture)


def check_svg_and_png(figures, folder):
    """Returns what TeX's picture of each figure is held against: its chosen points, by name."""
    page, shown, points_of = Page(folder), [], {}
    for figure in figures:
        path = os.path.join(folder, figure.name)
        rastertrace("figure", figure.scene, *figure.options, "-o", path + ".svg")
        with open(path + ".svg", encoding="utf-8") as file:
            text = file.read()
        root = xml.etree.ElementTree.fromstring(text)
        check_text(figure.name + ".svg", root, text)
        size = float(root.get("width")), float(root.get("height"))
        number = page.add(path + ".svg", *map(math.ceil, size), "light")
        points = []
        if figure.drawn:
            points = chosen_points(root, Expected(figure))
        points_of[figure.name] = (size, points)
        rastertrace("figure", figure.scene, *figure.options, "--scale", "1", "-o", path + ".png")
        check_points(figure.name + ".png", image_of(path + ".png"), points)
        dark = None
        if "--theme" not in figure.options and figure.drawn:
            dark = page.add(path + ".svg", *map(math.ceil, size), "dark"), root
        shown.append((figure, path, number, points, dark))
        count("figures")
    pictures = page.pictures()
    for figure, path, number, points, dark in shown:
        librsvg = by_librsvg(path + ".svg")
        check_points(figure.name + ".svg by librsvg", librsvg, points, tolerance=1)
        check_points(figure.name + ".svg by Chromium", pictures[number], points, tolerance=1)
        check_alike(figure.name, librsvg, pictures[number], figure.is_latin)
        if dark:
            by_night = svg_points.Points(dark[1], dark=True)
            colors = [(x, y, by_night.color_at((x, y))[0]) for x, y, _ in points]
            if not {"--view", "--bare"} & set(figure.options) and {color for _, _, color in colors} & {color for _, _, color in points}:
                fail(f"{figure.name}: a color is the same in the dark")
            check_points(figure.name + ".svg by Chromium in the dark", pictures[dark[0]], colors, tolerance=1)
            count("figures in the dark")
    return points_of


def check_animated_svg(folder):
    """At any time one frame is seen, each in its turn; librsvg, which knows no animations, shows the last one."""
    path = os.path.join(folder, "animated.svg")
    seconds = 0.5
    words = ["figure", TRIANGLE, "--every", "scanline", "--cell", "20"]
    rastertrace(*words, "--animate", "--seconds", str(seconds), "-o", path)
    with open(path, encoding="utf-8") as file:
        text = file.read()
    root = xml.etree.ElementTree.fromstring(text)
    check_text("animated.svg", root, text)
    frames = len(root.findall(svg_points.SVG + "g"))
    script = f"""<script>
      const frames = [...document.querySelectorAll('.frame')], told = [];
      for (let turn = 0; turn < 3 * frames.length; ++turn)
        for (const part of [0.01, 0.5, 0.99]) {{
          for (const one of document.getAnimations()) {{ one.pause(); one.currentTime = (turn + part) * {seconds * 1000}; }}
          told.push(frames.map((f, i) => getComputedStyle(f).visibility == 'visible' ? i : '').filter(i => i !== '').join('+'));
        }}
      document.getElementById('told').textContent = told.join(' ');
    </script>"""
    page = os.path.join(folder, "animated.html")
    with open(page, "w", encoding="utf-8") as file:
        file.write(f'<!DOCTYPE html><meta charset="utf-8"><body>{text}<p id="told"></p>{script}</body>')
    told = re.search(r'<p id="told">([^<]*)</p>', chromium("--dump-dom", page))
    expected = " ".join(str(turn % frames) for turn in range(3 * frames) for _ in range(3))
    if frames != 9 or not told or told.group(1) != expected:
        fail(f"animated.svg: expected the frames {expected}, Chromium shows {told.group(1) if told else 'nothing'}")
    last = os.path.join(folder, "last.svg")
    rastertrace("figure", TRIANGLE, "--step", "scanline y=-3", "--cell", "20", "-o", last)
    if ImageChops.difference(*(by_librsvg(one).crop((0, 0, 300, 250)) for one in (path, last))).getbbox():
        fail("animated.svg: librsvg does not show the last frame")


# --- GIF ------------------------------------------------------------------------------------------------------------


def check_gif(folder):
    """Pillow finds every frame, its time, and the pixels of the PNG."""
    words = ["figure", TRIANGLE, "--cell", "20"]
    path = os.path.join(folder, "rows.gif")
    rastertrace(*words, "--every", "scanline", "--seconds", "0.25", "-o", path)
    with Image.open(path) as gif:
        if (gif.n_frames, gif.info.get("loop")) != (9, 0):
            fail(f"rows.gif: {gif.n_frames} frames, loop {gif.info.get('loop')}")
        for frame, y in enumerate(range(5, -4, -1)):
            gif.seek(frame)
            if gif.info["duration"] != 250:
                fail(f"rows.gif: frame {frame} takes {gif.info['duration']} ms")
            picture = os.path.join(folder, "row.png")
            rastertrace(*words, "--step", f"scanline y={y}", "--scale", "1", "-o", picture)
            expected = image_of(picture)
            if ImageChops.difference(gif.convert("RGB").crop((0, 0, *expected.size)), expected).getextrema() > ((8, 8),) * 3:
                fail(f"rows.gif: frame {frame} is not the PNG of its step")


# --- TikZ -----------------------------------------------------------------------------------------------------------

DOCUMENT = r"""\documentclass{article}
\usepackage[utf8]{inputenc}
\usepackage{tikz}
\pagestyle{empty}
%% The upper left corner of a figure is that of its page, which has room for all of them.
\pdfpagewidth=1000mm \pdfpageheight=1000mm \textwidth=1000mm \textheight=1000mm
\hoffset=-1in \voffset=-1in \oddsidemargin=0pt \topmargin=0pt \headheight=0pt \headsep=0pt \topskip=0pt \parindent=0pt
\begin{document}
%s
\end{document}
"""
WIDEST_OVERFULL = 0.5  # points


def check_tikz(figures, points_of, folder):
    """One document has all of them, a page each."""
    pages = ""
    for figure in figures:
        # As wide as the .svg: one that is made narrower has larger letters.
        (width, _), _ = points_of[figure.name]
        size = [] if "--bare" in figure.options else ["--width", repr(width * 25.4 / 96)]
        rastertrace("figure", figure.scene, *figure.options, *size, "-o", os.path.join(folder, figure.name + ".tex"))
        pages += rf"\message{{[figure {figure.name}]}}\input{{{figure.name}}}\newpage" + "\n"
    with open(os.path.join(folder, "all.tex"), "w", encoding="utf-8") as file:
        file.write(DOCUMENT % pages)
    try:
        run("pdflatex", "-interaction=nonstopmode", "-halt-on-error", "-file-line-error", "all.tex", cwd=folder)
    except RuntimeError as error:
        fail(f"TikZ: {error}")
        return
    with open(os.path.join(folder, "all.log"), encoding="utf-8", errors="replace") as file:
        log = file.read()
    for width in re.findall(r"Overfull \\[hv]box \(([\d.]+)pt", log):
        if float(width) > WIDEST_OVERFULL:
            fail(f"TikZ: a box is {width} points too large")
    for line in re.findall(r"^.*(?:Missing character|LaTeX Warning|LaTeX Font Warning|Undefined).*$", log, re.MULTILINE):
        if "Label(s) may have changed" not in line:
            fail(f"TikZ: {line}")
    number_of_pages = re.search(r"Output written on all.pdf \((\d+) pages", log.replace("\n", ""))
    if not number_of_pages or int(number_of_pages.group(1)) != len(figures):
        fail(f"TikZ: expected {len(figures)} pages, found {number_of_pages and number_of_pages.group(1)}")
        return
    for page, figure in enumerate(figures, 1):
        (width, height), points = points_of[figure.name]
        if not points:
            continue
        # So that a unit is two pixels, whatever it is in millimeters.
        with open(os.path.join(folder, figure.name + ".tex"), encoding="utf-8") as file:
            unit_mm = float(re.search(r"\[x=([\d.]+)mm", file.read()).group(1))
        picture = os.path.join(folder, f"tikz-{page}")
        run("pdftoppm", "-png", "-singlefile", "-f", str(page), "-l", str(page), "-r", repr(2 * 25.4 / unit_mm),
            "-x", "0", "-y", "0", "-W", str(math.ceil(2 * width)), "-H", str(math.ceil(2 * height)),
            os.path.join(folder, "all.pdf"), picture)
        check_points(f"{figure.name}.tex by pdfTeX", image_of(picture + ".png"), points, scale=2, tolerance=2)


def check_slides(scene, folder):
    """Overlays of beamer, in the style of the document: a page for each frame, and edges in its color."""
    rastertrace("figure", scene, "--every", "scanline", "--animate", "-o", os.path.join(folder, "rows.tex"))
    shutil.copy(os.path.join(SOURCE, "examples", "figures", "rastertrace.sty"), folder)
    with open(os.path.join(folder, "slides.tex"), "w", encoding="utf-8") as file:
        file.write(r"\documentclass{beamer}\usepackage{rastertrace}\rastertrace{rt-line true-edge/.append style={draw=green}}"
                   r"\begin{document}\begin{frame}\input{rows}\end{frame}\end{document}")
    run("pdflatex", "-interaction=nonstopmode", "-halt-on-error", "slides.tex", cwd=folder)
    with open(os.path.join(folder, "rows.tex"), encoding="utf-8") as file:
        frames = file.read().count(r"\only<")
    run("pdftoppm", "-png", "-r", "72", os.path.join(folder, "slides.pdf"), os.path.join(folder, "slide"))
    pages = sorted(name for name in os.listdir(folder) if name.startswith("slide-"))
    if len(pages) != frames or frames != 9:
        fail(f"beamer: expected 9 pages, found {len(pages)} of {frames} frames")
    for page in pages:
        if not any(green > 200 and red < 100 and blue < 100 for red, green, blue in image_of(os.path.join(folder, page)).getdata()):
            fail(f"beamer: {page}: expected edges in the color of the style, found none")


def main():
    with tempfile.TemporaryDirectory() as folder:
        figures = figure_list.figures(SOURCE, folder)
        points_of = check_svg_and_png(figures, folder)
        check_animated_svg(folder)
        check_gif(folder)
        check_tikz(figures, points_of, folder)
        check_slides(os.path.join(SOURCE, "examples", "t0-fill", "first-triangle.json"), folder)
    print(", ".join(f"{number} {what}" for what, number in counted.items()))
    for message in failures[:40]:
        print(message)
    if failures:
        print(f"{len(failures)} failures")
    return 1 if failures else 0


sys.exit(main())
