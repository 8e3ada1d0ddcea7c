#!/usr/bin/env python3
"""Writes docs/mistakes.md anew. With --check it only says whether the page is what the program tells.

    scripts/make-mistakes.py [--check] [PROGRAM]

Each mistake is drawn in the scene that its entry on the page names."""

import difflib
import functools
import json
import pathlib
import re
import subprocess
import sys

root = pathlib.Path(__file__).resolve().parent.parent
arguments = sys.argv[1:]
is_check = arguments[:1] == ["--check"]
program = pathlib.Path((arguments[is_check:] or [root / "build/release/viewer-cli/rastertrace"])[0]).resolve()


def told(*words):
    return subprocess.run([program, *words], cwd=root, check=True, capture_output=True, text=True).stdout


@functools.cache
def drawn(*words):
    """The canvas, and the color of each pixel that is drawn: its own, or that of its primitive."""
    trace = json.loads(told("trace", "--only", "primitive,pixel", *words))
    colors, of_primitive = {}, None
    for step in trace["steps"]:
        if step["step"] == "primitive":
            of_primitive = step.get("color")
        else:
            colors[step["x"], step["y"]] = step.get("color", of_primitive)
    # A pixel of the usual color has none in the trace.
    return trace["canvas"], {pixel: color or "usual" for pixel, color in colors.items()}


def marked_picture(scene, mistake):
    """`+` is too much, `-` missing, `*` of another color; from the first row that has something to the last one."""
    canvas, asked = drawn(scene)
    _, found = drawn(scene, "--mistake", mistake)
    width, height = canvas["width"], canvas["height"]
    # Where the rows and columns are: canvas.h.
    is_centered = canvas["origin"] == "center"
    left = -(width // 2) if is_centered else 0
    highest = height // 2 if is_centered else height - 1
    rows = range(height) if canvas["origin"] == "top-left" else range(highest, highest - height, -1)

    def mark(pixel):
        a, b = asked.get(pixel), found.get(pixel)
        return (".#"[a is not None]) if a == b else "+" if a is None else "-" if b is None else "*"

    lines = ["".join(mark((x, y)) for x in range(left, left + width)) for y in rows]
    is_empty = re.compile(r"\.*$").match
    while lines and is_empty(lines[0]):
        lines.pop(0)
    while lines and is_empty(lines[-1]):
        lines.pop()
    return "".join(line + "\n" for line in lines)


def entry(mistake, scene):
    text = f"\n## {mistake['name']}\n\n{mistake['symptom'][0].upper()}{mistake['symptom'][1:]} ({mistake['source']}).\n\n"
    text += f"```text\nit says   {mistake['says']}\n"
    for label, key in (("should    ", "should"), ("the same  ", "setting")):
        text += label + mistake[key] + "\n" if mistake[key] else ""
    return text + f"scene     {scene}\n\n{marked_picture(scene, mistake['name'])}```\n"


page = root / "docs/mistakes.md"
before = page.read_text()
scenes = dict(re.findall(r"^## (\S+)$.*?^scene     (\S+)$", before, re.M | re.S))
after = before[: before.index("\n## ")]
for mistake in json.loads(told("diagnose", "--list", "--json"))["mistakes"]:
    if mistake["name"] not in scenes:
        sys.exit(f"docs/mistakes.md: expected an entry for {mistake['name']} with a line \"scene     FILE\", found none")
    after += entry(mistake, scenes[mistake["name"]])
if not is_check:
    page.write_text(after)
elif before != after:
    sys.stdout.writelines(difflib.unified_diff(before.splitlines(True), after.splitlines(True), "docs/mistakes.md", "renewed"))
    sys.exit(f"docs/mistakes.md is not what the program tells; to renew it: scripts/make-mistakes.py {program}")
