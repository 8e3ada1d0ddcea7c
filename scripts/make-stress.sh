#!/bin/sh
# Writes the entries between the marks of docs/stress.md anew, from a run of the cases. With --check it
# only says whether they are what the program writes. Takes seconds; the same on every machine.
#
#     scripts/make-stress.sh [--check] [PROGRAM]
set -eu
cd "$(dirname "$0")/.."
check=
[ "${1:-}" = --check ] && check=yes && shift
rastertrace=${1:-build/release/viewer-cli/rastertrace}
page=$(mktemp)
trap 'rm -f "$page" "$page.entries"' EXIT

# Status 1: a row is not as documented in the code. Then the page would be wrong, too.
"$rastertrace" stress --quick --markdown >"$page.entries" || {
    status=$?
    "$rastertrace" stress --quick >&2 || true
    exit $status
}

# What stands between the marks is replaced.
awk -v entries="$page.entries" '
    /<!-- stress: end -->/ { inside = 0 }
    !inside { print }
    /<!-- stress: begin/ {
        inside = 1
        while ((getline line < entries) > 0) print line
    }' docs/stress.md >"$page"

if [ -z "$check" ]; then
    cat "$page" >docs/stress.md
elif ! diff -u docs/stress.md "$page"; then
    echo "docs/stress.md is not what the program writes; to renew it: scripts/make-stress.sh $rastertrace" >&2
    exit 1
fi
