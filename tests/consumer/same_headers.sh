#!/bin/sh
# same_headers.sh INSTALLED INCLUDE...: fails if a header below an INCLUDE is not installed, or if one that is installed
# includes one that is not, and says which.
set -eu
installed=$1
shift
missing=0
for include; do
    for header in $(cd "$include" && find . -name '*.h' | LC_ALL=C sort); do
        [ -f "$installed/$header" ] || { echo "not installed: $header (list it in CMakeLists.txt)"; missing=1; }
    done
done
for header in $(cd "$installed" && find rastertrace -name '*.h' | LC_ALL=C sort); do
    folder=$(dirname "$header")
    for included in $(sed -n 's,^#include <\(rastertrace/[^>]*\)>.*,\1,p; s,^#include "\([^"]*\)".*,'"$folder"'/\1,p' "$installed/$header"); do
        [ -f "$installed/$included" ] || { echo "$header includes $included, which is not installed"; missing=1; }
    done
done
exit "$missing"
