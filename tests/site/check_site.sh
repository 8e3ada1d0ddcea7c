#!/bin/sh
# Builds the site, and looks at it as files and in a browser: check_site.py, check_look.cjs.
# usage: check_site.sh PROGRAM SOURCE_FOLDER FOLDER TOOLS   # the site is in FOLDER then; TOOLS as in check_page.sh
set -eu

program=$1
source=$2
folder=$3
tools=$4
PLAYGROUND_TOOLS=$tools/playground "$source/scripts/site" "$program" "$folder"
/usr/bin/python3 "$source/tests/site/check_site.py" "$folder" "$source"
"$source/tests/page/with_browser.sh" "$tools" "$source/tests/site/check_look.cjs" "$folder"
if [ -d "$folder/playground" ]; then
    size=$("$tools/playground/node_modules/.bin/esbuild" --minify --format=esm "$folder/playground/raster-trace.js" | wc -c)
    [ "$size" -le 60000 ] || { echo "raster-trace.js has $size bytes minified, 60,000 at most" >&2; exit 1; }
fi
[ ! -d "$folder/playground" ] || "$source/tests/page/with_browser.sh" "$tools" "$source/tests/site/check_playground.cjs" "$folder"
