#!/bin/sh
# What pdflatex says to our pictures: no error, no warning about fonts or characters, no box that is too wide, and
# outlines of letters alone. Needs texlive-latex-base and texlive-pictures.
# usage: tikz.sh HOSTILE_TIKZ (the program that writes the pictures)
set -eu

program=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

"$program" "$folder"
cd "$folder"

# compile PICTURE NAME PREAMBLE: a document with the picture.
compile() {
    printf '%s\n' '\documentclass{article}' '\usepackage{tikz}' "$3" '\begin{document}' \
        "\\noindent\\input{$1}" '\end{document}' >"$2.tex"
    if ! pdflatex -halt-on-error -interaction=nonstopmode "$2.tex" >"$2.out" 2>&1; then
        echo "tikz.sh: pdflatex fails for $1 ($2):" >&2
        grep -A 5 '^!' "$2.log" >&2 || cat "$2.out" >&2
        exit 1
    fi
    if grep -E 'Overfull|Underfull|Warning|Missing character|mktexpk' "$2.log" "$2.out" >&2; then
        echo "tikz.sh: pdflatex complains about $1 ($2)" >&2
        exit 1
    fi
}

compile hostile.tex plain ''
# Packages for languages let signs be commands; nobody must find these.
compile hostile.tex active '\AtBeginDocument{\catcode`\"=13 \catcode`\;=13 \catcode`\:=13 \catcode`\!=13
\catcode`\?=13 \catcode`\<=13 \catcode`\>=13 \catcode`\|=13 \catcode`\-=13 }'
# Each kind of shape, as many as a picture may have.
for picture in rectangles lines dots labels; do
    compile "$picture.tex" "$picture-alone" ''
done

# A fault must be seen: the check itself is checked.
printf '%s\n' '\begin{tikzpicture}\node {a_b};\end{tikzpicture}' >wrong.tex
if (compile wrong.tex wrong '') 2>/dev/null; then
    echo "tikz.sh: an error of TeX was not seen" >&2
    exit 1
fi
