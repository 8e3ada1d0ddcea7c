#!/bin/sh
# Figures in pages of MkDocs, Sphinx and Pandoc, as examples/embed has them: each page has the program's own SVG, and
# LaTeX its TikZ; a scene that is wrong stops the build with the program's message.
# usage: check_embed.sh PROGRAM SOURCE
set -eu
program=$1
source=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
export RASTERTRACE="$program"
cp "$source"/examples/embed/* .
cp "$source/examples/t0-fill/first-triangle.json" scene.json

fail() {
    echo "check_embed.sh: $1" >&2
    exit 1
}

# has FILE: the figures of both blocks, byte for byte but for the sheet's own indent.
"$program" figure scene.json --step "scanline y=2" --format svg -o - >row.svg
printf '{"title": "A point", "canvas": {"width": 9, "height": 9}, "vertices": {"A": [1, 1]}, "points": ["A"]}\n' >point.json
"$program" figure point.json --cell 30 --format svg -o - >point.svg
has() {
    python3 - "$1" row.svg point.svg <<'EOF' || fail "$1: the figure is not the program's"
import sys
page = "".join(open(sys.argv[1], encoding="utf-8").read().split())
sys.exit(any("".join(open(name, encoding="utf-8").read().split()) not in page for name in sys.argv[2:]))
EOF
}

{
    printf '# A page\n\n```rastertrace\nscene.json --step "scanline y=2"\n```\n\n```rastertrace\n--cell 30\n'
    cat point.json
    printf '```\n'
} >page.md

# Pandoc
pandoc --lua-filter rastertrace.lua page.md -t html -o pandoc.html
has pandoc.html
pandoc --lua-filter rastertrace.lua page.md -t latex -o pandoc.tex
[ "$(grep -c 'begin{tikzpicture}' pandoc.tex)" = 2 ] || fail "pandoc.tex: expected two pictures"

# MkDocs
mkdir docs
cp page.md docs/index.md
cat >mkdocs.yml <<'EOF'
site_name: Figures
markdown_extensions:
  - pymdownx.superfences:
      custom_fences:
        - name: rastertrace
          class: rastertrace
          format: !!python/name:rastertrace_fence.figure
EOF
PYTHONPATH=. mkdocs build -q
has site/index.html

# Sphinx
mkdir sphinx
cat >sphinx/conf.py <<'EOF'
import os
import sys
sys.path.append(os.path.abspath(".."))
extensions = ["rastertrace_directive"]
EOF
{
    printf 'A page\n======\n\n.. rastertrace::\n\n   scene.json --step "scanline y=2"\n\n.. rastertrace::\n\n   --cell 30\n   '
    cat point.json
} >sphinx/index.rst
sphinx-build -q -W -b html sphinx sphinx-html
has sphinx-html/index.html
sphinx-build -q -W -b latex sphinx sphinx-latex
grep -q 'begin{tikzpicture}' sphinx-latex/*.tex || fail "Sphinx: expected a picture in LaTeX"

# What is wrong is told, and the page is not written.
printf '```rastertrace\nnone.json\n```\n' >docs/index.md
cp docs/index.md wrong.md
printf 'A page\n======\n\n.. rastertrace::\n\n   none.json\n' >sphinx/index.rst
for build in "pandoc --lua-filter rastertrace.lua wrong.md -t html" "env PYTHONPATH=. mkdocs build -q" \
    "sphinx-build -q -W -b html sphinx sphinx-html"; do
    if $build >told 2>&1; then
        fail "$build: expected a failure"
    fi
    grep -q 'none.json' told || fail "$build: expected the program's message, found $(cat told)"
done
