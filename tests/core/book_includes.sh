#!/bin/sh
# book_includes.sh COMPILER INCLUDE OTHER_INCLUDE: fails if a page of raster/ or transform/ includes GMP or a header
# of draw/, by itself or through others; or if two folders below core include each other.
set -eu
compiler=$1 include=$2
shift
failed=0

for page in "$include"/rastertrace/core/raster/*.h "$include"/rastertrace/core/transform/*.h; do
    # Nothing but the folder of the book is on the way, so a header of draw/ would not be found.
    included=$("$compiler" -std=c++20 -I"$include" -M -x c++ "$page") || { failed=1; continue; }
    case $included in
    *gmp*)
        echo "$page: includes GMP"
        failed=1
        ;;
    esac
done

# "raster numbers" for a folder that includes another one.
for root; do
    (cd "$root/rastertrace/core" && grep -Ro '#include <rastertrace/core/[^>]*/' -- *) |
        sed -E 's|^([^:]*)/[^/:]*:#include <rastertrace/core/(.*)/$|\1 \2|'
done | awk '$1 != $2' | LC_ALL=C sort -u >"${TMPDIR:-/tmp}/folders.$$"
trap 'rm -f "${TMPDIR:-/tmp}/folders.$$"' EXIT
while read -r from to; do
    if [ "$from" \< "$to" ] && grep -qx "$to $from" "${TMPDIR:-/tmp}/folders.$$"; then
        echo "$from and $to include each other"
        failed=1
    fi
done <"${TMPDIR:-/tmp}/folders.$$"
exit "$failed"
