#!/bin/sh
# Two programs must print the same.
# usage: same_output.sh ONE OTHER
set -eu
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
"$1" > "$folder/one"
"$2" > "$folder/other"
diff "$folder/one" "$folder/other" | head -n 20 >&2
cmp "$folder/one" "$folder/other"
echo "$(wc -l < "$folder/one") lines are the same."
