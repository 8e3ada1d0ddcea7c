# SPDX-License-Identifier: MIT
"""Figures in pages of MkDocs, or of anything else that has pymdownx.superfences:

    ```rastertrace
    scene.json --step "scanline y=2"
    ```

A block holds what would be typed after `rastertrace figure`; or such options, a line each, and then a scene itself.
In mkdocs.yml, beside this file:

    markdown_extensions:
      - pymdownx.superfences:
          custom_fences:
            - name: rastertrace
              class: rastertrace
              format: !!python/name:rastertrace_fence.figure
"""
import html
import os
import shlex
import subprocess

from pymdownx.superfences import SuperFencesException


def figure(source, language, css_class, options, md, **rest):
    words, scene = shlex.split(source), None
    if "{" in source:
        begin = source.index("{")
        words, scene = ["-"] + shlex.split(source[:begin]), source[begin:]
    command = [os.environ.get("RASTERTRACE", "rastertrace"), "figure", *words, "--format", "svg", "-o", "-"]
    run = subprocess.run(command, input=scene, capture_output=True, text=True)
    if run.returncode != 0:
        raise SuperFencesException(run.stderr)
    return f'<div class="{html.escape(css_class)}">{run.stdout}</div>'
