#!/bin/sh
# same_headers.sh INSTALLED INCLUDE...: fails if a header of the libraries is not installed, and says which.
set -eu
installed=$1
shift
missing=0
for include; do
    for header in $(cd "$include" && find . -name '*.h' | LC_ALL=C sort); do
        [ -f "$installed/$header" ] || { echo "not installed: $header (list it in CMakeLists.txt)"; missing=1; }
    done
done
exit "$missing"
