#!/bin/sh
# How often `diagnose` finds what was put in: the numbers of docs/diagnose.md. Takes hours with 200 scenes of each mistake.
# usage: scripts/check-diagnose.sh [SCENES OF EACH MISTAKE, 200 if not given]
set -eu
cd "$(dirname "$0")/.."
export RASTERTRACE_DIAGNOSE_SCENES="${1:-200}"
export GTEST_TOTAL_SHARDS=2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for shard in 0 1; do
    GTEST_SHARD_INDEX=$shard build/test/tests/test-trace --gtest_filter='Diagnose*' >"$folder/$shard" 2>&1 || true &
done
wait
echo "| | of |"
echo "|---|---|"
cat "$folder/0" "$folder/1" | sed -n 's/^row: \(.*\): \([0-9]*\) of \([0-9]*\)$/| \1 | \2 of \3 |/p'
cat "$folder/0" "$folder/1" | grep -v '^row: \|^\[\|^Note' >&2 || true
