#!/bin/sh
# Compares what two builds of the program draw and say: one hash for the trace (or the refusal) of every example
# and of some thousand random scenes, with every fill, line, depth rule and scalar; for each example one more
# for every command that tells about a scene, and for screens of the player; and for 200 scenes with a fault, one for the message.
#
#     scripts/freeze.sh before/rastertrace after/rastertrace   # lists what differs
#     scripts/freeze.sh build/release/viewer-cli/rastertrace   # prints the hashes
#
# COUNT=10000 in the environment for more random scenes than 4,000; KEEP=FOLDER keeps those that differ.
# Exit status 1: something differs.
set -eu
cd "$(dirname "$0")/.."

if [ $# -lt 1 ] || [ $# -gt 2 ]; then
    echo "usage: scripts/freeze.sh PROGRAM [PROGRAM]" >&2
    exit 2
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
c++ -std=c++20 -O1 -Itests -o "$folder/random_scenes" tests/freeze/random_scenes.cpp
mkdir "$folder/scenes" "$folder/faults"
"$folder/random_scenes" "${COUNT:-4000}" "$folder/scenes"
"$folder/random_scenes" --with-faults 200 "$folder/faults"

# One call for each line: what comes after the name of the program.
{
    find examples -name '*.json' | sort | while read -r scene; do
        for call in trace show 'show --all --working --max-steps 500' plan stats 'stats --json' sheet \
            'figure -o - --format svg' 'figure -o - --format tex' 'play --print 100x30 --step last' \
            'diff --against fill=top-left' 'diff --against fill=two-halves --json'; do
            echo "$call $scene"
        done
        for what in 'step last' 'pixel 1,2' 'scanline 1'; do
            echo "explain --$what $scene"
            echo "explain --$what --json $scene"
        done
        for step in 2 12 40; do
            echo "play --print 80x24 --step $step $scene"
        done
    done
    find examples -name '*.claims' | sort | sed 's/^/check /;p;s/^check/& --json/'
    find "$folder/scenes" "$folder/faults" -name '*.json' | sort | sed 's/^/trace /'
} >"$folder/list"

# What a program prints, and its exit status; without the folder's name.
cat >"$folder/hash" <<'END'
#!/bin/sh
program=$1
folder=$2
shift 2
for call in "$@"; do
    {
        # shellcheck disable=SC2086 # words of a call
        timeout 60 "$program" $call 2>"$folder/said.$$" || echo "exit $?"
        cat "$folder/said.$$"
    } | sed "s|$folder/||" | sha256sum | sed "s|-$|$(echo "$call" | sed "s|$folder/||")|"
done
rm -f "$folder/said.$$"
END
chmod +x "$folder/hash"
hashes_of() {
    xargs -d '\n' -n 64 -P "$(nproc)" "$folder/hash" "$1" "$folder" <"$folder/list" | sort -k 2
}

hashes_of "$1" >"$folder/first"
if [ $# -eq 1 ]; then
    cat "$folder/first"
    exit
fi
hashes_of "$2" >"$folder/second"
if cmp -s "$folder/first" "$folder/second"; then
    echo "$(wc -l <"$folder/list") calls: all print the same"
    exit
fi
diff "$folder/first" "$folder/second" | sed -n 's/^> [0-9a-f]*  *//p' >"$folder/differ"
kept=${KEEP:-}
if [ -n "$kept" ]; then
    mkdir -p "$kept"
    sed -n 's/^trace \(scenes\|faults\)/\1/p' "$folder/differ" | while read -r scene; do
        cp "$folder/$scene" "$kept"
    done
fi
echo "$(wc -l <"$folder/differ") of $(wc -l <"$folder/list") calls differ:"
cat "$folder/differ"
exit 1
