#!/bin/bash
# How the work of the commands grows with their input: draws scenes of n, 2 n, 4 n and 8 n parts, fits the
# exponent of the instructions executed, and fails where it is above 1.1. Run before a release; takes a
# few minutes. Counting instructions (by valgrind) gives the same figures on a busy machine.
#
#     scripts/check-growth.sh [PROGRAM [INPUT...]]     # names of the table at the end
#
# Exit status: 0 fine, 1 something grows faster, 3 the system failed.
set -eu
cd "$(dirname "$0")/.."
export LC_ALL=C
program=build/release/viewer-cli/rastertrace
if [ $# -gt 0 ]; then
    program=$1
    shift
else
    cmake --preset release >/dev/null
    cmake --build build/release --target rastertrace_program >/dev/null
fi
scripts/install-packages.sh valgrind
inputs=" $* "
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
printf 'v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n' >"$folder/one.obj"

# input KIND N: a scene, or a trace, of N parts.
input() {
    awk -v kind="$1" -v n="$2" '
    # N elements, each made by a function, with commas between them.
    function element(i) {
        if (kind == "triangles") return sprintf("[\"A%d\",\"B%d\",\"C%d\"]", i, i, i)
        if (kind == "fan-of-triangles") return sprintf("[\"M\",\"R%d\",\"R%d\"]", i, i + 1)
        if (kind == "one-edge") return sprintf("[\"A\",\"B\",\"P%d\"]", i)
        if (kind == "lines") return sprintf("[\"A%d\",\"B%d\"]", i, i)
        if (kind == "names") return sprintf("{\"name\":\"%s%d\",\"vertices\":\"ABC\"}", long, i)
        if (kind == "obj-meshes") return "{\"obj\":\"one.obj\"}"
        if (kind == "turned-meshes")
            return "{\"obj\":\"one.obj\",\"model\":[{\"rotate\":{\"axis\":[" third ",2,1],\"degrees\":30}}]}"
        if (kind == "named-meshes")
            return sprintf("{\"name\":\"m%d\",\"vertices\":{\"A\":[0,0],\"B\":[4,0],\"C\":[0,4]},\"faces\":[\"ABC\"]}", i)
        if (kind == "transforms") return "{\"rotate\":{\"axis\":[1,2,3],\"degrees\":30.5}}"
        if (kind == "colors") return sprintf("\"P%d\":\"red\"", i)
        if (kind == "kinds") return sprintf("\n{\"step\":\"kind%d\"}", i)
    }
    # How many steps of each of those kinds there are.
    function counts(    i, text) {
        for (i = 0; i < n; ++i)
            text = text sprintf("%s\"kind%d\":1", i ? "," : "", i)
        return text
    }
    function list(    i, text) {
        for (i = 0; i < n; ++i)
            text = text (i ? "," : "") element(i)
        return text
    }
    # Vertices NAME0, NAME1, ... on the canvas.
    function vertices(name, count,    i, text) {
        for (i = 0; i < count; ++i)
            text = text sprintf(",\"%s%d\":[%d,%d]", name, i, i * 7 % 13 - 6, i * 5 % 11 - 5)
        return text
    }
    function scene(more, rest) {
        printf "{\"canvas\":{\"width\":16,\"height\":16},\"vertices\":{\"A\":[0,0],\"B\":[5,1],\"C\":[1,5],\"M\":[0,1]%s},%s}\n", more, rest
    }
    BEGIN {
        for (i = 0; i < 100; ++i) { long = long "n"; third = third "3" }
        third = "\"1" third "/" third "1\""
        if (kind == "triangles")
            scene(vertices("A", n) vertices("B", n) vertices("C", n), "\"triangles\":[" list() "]")
        else if (kind == "lines") scene(vertices("A", n) vertices("B", n), "\"lines\":[" list() "]")
        else if (kind == "fan-of-triangles") scene(vertices("R", n + 1), "\"triangles\":[" list() "]")
        else if (kind == "one-edge") scene(vertices("P", n), "\"triangles\":[" list() "]")
        else if (kind == "names") scene("", "\"triangles\":[" list() "]")
        else if (kind == "colors") scene(vertices("P", n), "\"triangles\":[\"ABC\"],\"colors\":{" list() "}")
        else if (kind ~ /meshes/) scene("", "\"meshes\":[" list() "]")
        else if (kind == "transforms") scene("", "\"triangles\":[\"ABC\"],\"model\":[" list() "]")
        else if (kind == "steps")
            printf "{\"canvas\":{\"width\":64,\"height\":%d,\"origin\":\"top-left\"},\"vertices\":{\"A\":[0,0],\"B\":[40,0],\"C\":[0,%d]},\"triangles\":[\"ABC\"]}\n", n + 1, n
        else if (kind == "kinds")
            printf "{\"rastertrace\":1,\"canvas\":{\"width\":4,\"height\":4},\"steps\":[%s\n],\"end\":{\"steps\":%d,\"count\":{%s}}}\n", list(), n, counts()
        else printf "{\"canvas\":{\"width\":16,\"height\":16},\"meshes\":[{\"obj\":\"%s-%d.obj\"}]}\n", kind, n
    }' >"$folder/$1-$2.json"
    # A face with 2 N corners or two more, every other one reflex: a star, or a comb that is turned by 45 degrees
    # and rounded, so that no box tells its teeth from the triangles that run along them.
    case $1 in obj-star | obj-comb) ;; *) return ;; esac
    awk -v kind="$1" -v n="$2" '
    function corner(x, y) {
        ++corners
        if (kind == "obj-comb") printf "v %.9g %.9g 0\n", (x - y) * sqrt(0.5), (x + y) * sqrt(0.5)
        else printf "v %.6f %.6f 0\n", x, y
    }
    BEGIN {
        n = 2 * (n > 1 ? n : 2)
        for (i = 0; i < n; ++i) {
            angle = 2 * atan2(0, -1) * i / n
            if (kind == "obj-comb") corner(i, i % 2 * 1000)
            else corner((i % 2 ? 7 : 4) * cos(angle), (i % 2 ? 7 : 4) * sin(angle))
        }
        if (kind == "obj-comb") { corner(n, -10); corner(-1, -10) }
        printf "f"
        for (i = 1; i <= corners; ++i)
            printf " %d", i
        print ""
    }' >"$folder/$1-$2.obj"
}

# instructions COMMAND INPUT: how many the program executes.
instructions() {
    case $1 in
    show) set -- show "$2" --step last ;;
    diff)
        sed 's/"rastertrace":1/&,"title":"other"/' "$2" >"$folder/other.json"
        set -- diff "$2" "$folder/other.json"
        ;;
    every) set -- show "$2" --every no-such-kind ;; # a message that names all kinds: status 2
    esac
    valgrind --tool=cachegrind --cache-sim=no --cachegrind-out-file=/dev/null \
        "$program" "$@" </dev/null 2>"$folder/err" >/dev/null || [ $? -le 2 ] || { cat "$folder/err" >&2; exit 3; }
    awk '/I *refs:/ { gsub(",", "", $NF); print $NF }' "$folder/err"
}

# The slope of log(work) over log(n); what the program does for an input of one part is taken off.
exponent() {
    awk '{ x = log($1); y = log($2 > 1 ? $2 : 1); ++k; sx += x; sy += y; sxx += x * x; sxy += x * y }
        END { printf "%.2f\n", (k * sxy - sx * sy) / (k * sxx - sx * sx) }'
}

failed=0
printf '%-18s %6s  %s\n' input n 'exponent of each command'
while read -r kind n commands; do
    case $inputs in
    "  " | *" $kind "*) ;;
    *) continue ;;
    esac
    for size in 1 "$n" $((2 * n)) $((4 * n)) $((8 * n)); do
        input "$kind" "$size"
    done
    printf '%-18s %6d ' "$kind" $((8 * n))
    for command in $commands; do
        least=$(instructions "$command" "$folder/$kind-1.json")
        for size in "$n" $((2 * n)) $((4 * n)) $((8 * n)); do
            echo "$size $(($(instructions "$command" "$folder/$kind-$size.json") - least))"
        done >"$folder/work"
        slope=$(exponent <"$folder/work")
        printf ' %s %s' "$command" "$slope"
        if awk -v slope="$slope" 'BEGIN { exit !(slope > 1.1) }'; then
            printf ' (above 1.1)'
            failed=1
        fi
    done
    echo
done <<'KINDS'
triangles 100 plan trace show stats
lines 100 plan trace show stats
fan-of-triangles 100 plan trace show stats
one-edge 100 plan trace show stats
names 100 plan trace show stats
colors 200 plan trace
obj-meshes 100 plan trace show stats
named-meshes 100 plan trace show stats
turned-meshes 8 plan trace show stats
transforms 32 plan trace show stats
steps 16 plan trace show stats
kinds 500 show every stats diff validate
obj-star 1000 plan
obj-comb 1000 plan
KINDS
exit "$failed"
