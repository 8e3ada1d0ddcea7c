# SPDX-License-Identifier: MIT
"""Figures in pages of Sphinx, in HTML and in LaTeX:

    .. rastertrace::

       scene.json --step "scanline y=2"

A block holds what would be typed after `rastertrace figure`; or such options, and then a scene itself. In conf.py:
sys.path.append(os.path.abspath(...)) of this file's folder, and extensions = ["rastertrace_directive"]. LaTeX needs \\usepackage{tikz}.
"""
import os
import shlex
import subprocess

from docutils import nodes
from docutils.parsers.rst import Directive


class Figure(Directive):
    has_content = True

    def run(self):
        source, scene = "\n".join(self.content), None
        words = shlex.split(source.split("{")[0])
        if "{" in source:
            words, scene = ["-", *words], source[source.index("{"):]
        command = [os.environ.get("RASTERTRACE", "rastertrace"), "figure", *words, "-o", "-", "--format"]
        drawn = []
        for language, form in (("html", "svg"), ("latex", "tex")):
            run = subprocess.run([*command, form], input=scene, capture_output=True, text=True)
            if run.returncode != 0:
                raise self.error(run.stderr)
            drawn.append(nodes.raw("", run.stdout, format=language))
        return drawn


def setup(app):
    app.add_directive("rastertrace", Figure)
    return {"parallel_read_safe": True}
