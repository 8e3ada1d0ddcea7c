#!/bin/sh
# Compares what two builds of the program draw: one hash for the trace (or the refusal) of every
# example and of some thousand random scenes, with every fill, line, depth rule and scalar.
#
#     scripts/freeze.sh before/rastertrace after/rastertrace   # lists the scenes that differ
#     scripts/freeze.sh build/release/viewer-cli/rastertrace   # prints the hashes
#
# COUNT=10000 in the environment for more random scenes than 4,000. Exit status 1: some differ.
set -eu
cd "$(dirname "$0")/.."

if [ $# -lt 1 ] || [ $# -gt 2 ]; then
    echo "usage: scripts/freeze.sh PROGRAM [PROGRAM]" >&2
    exit 2
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
c++ -std=c++20 -O1 -Itests -o "$folder/random_scenes" tests/freeze/random_scenes.cpp
mkdir "$folder/scenes"
"$folder/random_scenes" "${COUNT:-4000}" "$folder/scenes"
find "$folder/scenes" examples -name '*.json' | sort >"$folder/list"

# What a program says about a scene, refusals and exit status included; without the folder's name.
cat >"$folder/hash" <<'END'
#!/bin/sh
program=$1
folder=$2
shift 2
for scene in "$@"; do
    {
        timeout 60 "$program" trace "$scene" 2>&1
        echo "exit $?"
    } | sed "s|$folder/||" | sha256sum | sed "s|-$|${scene#"$folder"/}|"
done
END
chmod +x "$folder/hash"
hashes_of() {
    xargs -n 64 -P "$(nproc)" "$folder/hash" "$1" "$folder" <"$folder/list" | sort -k 2
}

hashes_of "$1" >"$folder/first"
if [ $# -eq 1 ]; then
    cat "$folder/first"
    exit
fi
hashes_of "$2" >"$folder/second"
if cmp -s "$folder/first" "$folder/second"; then
    echo "$(wc -l <"$folder/list") scenes: every trace is the same"
    exit
fi
diff "$folder/first" "$folder/second" | sed -n 's/^> [0-9a-f]*  *//p' >"$folder/differ"
kept=${KEEP:-}
if [ -n "$kept" ]; then
    mkdir -p "$kept"
    while read -r scene; do
        case "$scene" in scenes/*) cp "$folder/$scene" "$kept" ;; esac
    done <"$folder/differ"
fi
echo "$(wc -l <"$folder/differ") of $(wc -l <"$folder/list") scenes differ:"
cat "$folder/differ"
exit 1
