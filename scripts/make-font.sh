#!/bin/sh
# Makes the fonts of trace/figures/font from DejaVu: the letters that bitmaps need, without hints and kerning.
# usage: make-font.sh. Needs fonts-dejavu-core (2.37) and python3-fonttools; run by hand, the build does not need them.
set -eu
cd "$(dirname "$0")/../trace/figures/font"

# Latin with its accents, signs, superscripts, Greek, dashes and quotes, subscripts, arrows, and signs of mathematics.
letters=20-7E,A0-FF,110,111,131,152,153,160,161,178,17D,17E,391-3A9,3B1-3C9
letters=$letters,2013,2014,2018-201A,201C-201E,2022,2026,2032,2033,2039,203A,2070,2074-2079,207F,2080-2089,20AC
letters=$letters,2190-2195,21D2,2206,2208,2211,2212,221A,221E,2248,2260,2264,2265,22C5
for face in DejaVuSans DejaVuSans-Bold DejaVuSansMono; do
    /usr/bin/python3 -m fontTools.subset "/usr/share/fonts/truetype/dejavu/$face.ttf" --unicodes="$letters" \
        --output-file="$face.ttf" --notdef-outline --no-hinting --no-recalc-timestamp --layout-features= --name-IDs=0,1,2 \
        --name-languages=0x409 --drop-tables+=FFTM,GDEF,GPOS,GSUB,MATH,gasp,kern
done
ls -l ./*.ttf
