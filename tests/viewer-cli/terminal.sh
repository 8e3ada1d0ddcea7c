#!/bin/sh
# What a terminal shows of a frame, in tmux: at three sizes, of three canvases, with colors and without.
# usage: terminal.sh PROGRAM EXAMPLES
set -eu

program=$1
examples=$2
folder=$(mktemp -d)
server="rastertrace-$$"
trap 'tmux -L "$server" kill-server 2>/dev/null || true; rm -rf "$folder"' EXIT

fail() {
    echo "terminal.sh: $1" >&2
    sed 's/^/  |/' "$folder/pane" >&2
    exit 1
}

# pane COLUMNS LINES ENVIRONMENT ARGUMENTS: what the program leaves on a screen of that size, as $folder/pane; with
# its escape sequences as $folder/colors.
pane() {
    tmux -L "$server" new-session -d -s one -x "$1" -y "$2" \
        "env $3 '$program' show $4; printf '%s' '\$ the prompt'; sleep 60"
    tries=0
    until tmux -L "$server" capture-pane -p -t one >"$folder/pane" &&
        grep -q '^\$ the prompt' "$folder/pane"; do
        tries=$((tries + 1))
        [ "$tries" -lt 600 ] || fail "$4 at $1x$2 does not end"
        sleep 0.1
    done
    tmux -L "$server" capture-pane -p -e -t one >"$folder/colors"
    tmux -L "$server" kill-session -t one
}

# A server without a session ends; this one lasts as long as the test.
tmux -L "$server" -f /dev/null new-session -d -s waiting "sleep 600"

# A triangle on a canvas of so many columns and rows.
canvas() {
    cat <<END >"$folder/$1x$2.json"
{"title": "A canvas of $1 x $2", "canvas": {"width": $1, "height": $2, "origin": "top-left"},
 "vertices": {"A": [0, 0], "B": [$(($1 - 1)), 0], "C": [0, $(($2 - 1))]},
 "triangles": ["ABC"]}
END
}
canvas 1 1
canvas 512 512
canvas 16384 4096
# The largest has a trace of some pixels only.
sed -i 's/"B": [^C]*"C": \[0, 4095\]/"B": [9, 0], "C": [0, 9]/' "$folder/16384x4096.json"

for size in "80 24" "40 12" "200 60"; do
    columns=${size% *}
    lines=${size#* }
    for scene in "$folder/1x1.json" "$folder/512x512.json" "$folder/16384x4096.json" \
        "$examples/t0-fill/first-triangle.json" "$examples/t0-hidden/painters-cycle.json"; do
        title=$(sed 's/.*"title": "\([^"]*\)".*/\1/;q' "$scene" | cut -c 1-12)
        case $title in
        "{"*) title=$(sed -n 's/.*"title": "\([^"]*\)".*/\1/p' "$scene" | cut -c 1-12) ;;
        esac
        for step in "--step 1" "--step last"; do
            pane "$columns" "$lines" "COLORTERM=" "'$scene' $step"
            # The whole frame fits: its first line has not been pushed off the screen.
            head -n 1 "$folder/pane" | grep -qF "$title" || fail "$scene $step at $columns x $lines: no title on top"
            rows=$(grep -cE '^[> ]*-?[0-9]+  ' "$folder/pane" || true)
            [ "$rows" -ge 1 ] || fail "$scene $step at $columns x $lines: no rows"
        done
    done
done

# Colors are what the terminal has.
lit="'$examples/t3-sweep-and-box/top-left.json' --view shade"
pane 80 24 "COLORTERM=truecolor" "$lit"
grep -q '\[48;2;' "$folder/colors" || fail "no 24-bit color"
pane 80 24 "COLORTERM= TERM=xterm-256color" "$lit"
grep -q '\[48;5;' "$folder/colors" || fail "no color of the palette"
pane 80 24 "NO_COLOR=1 COLORTERM=truecolor" "$lit"
! grep -q '\[48;' "$folder/colors" || fail "colors in spite of NO_COLOR"
pane 80 24 "TERM=dumb COLORTERM=truecolor" "$lit"
! grep -q '\[48;' "$folder/colors" || fail "colors on a dumb terminal"

# A sequence that nobody could scroll through is refused, and the way out is told.
pane 80 24 "COLORTERM=" "'$examples/t0-projection/turning.json' --vary /model/0/rotate/degrees=0:360:1001"
tr -d '\n' <"$folder/pane" | grep -q 'at most 1000 frames' || fail "1001 frames on a terminal"
grep -q -- '--frame 1 shows the first' "$folder/pane" || fail "no hint at --frame"

# started COMMAND: on a terminal of 80 columns, in the folder of the test.
started() {
    tmux -L "$server" new-session -d -s one -x 80 -y 40 -c "$folder" "$1; printf '%s' '\$ the prompt'; sleep 60"
}
seen() { # seen TEXT: waits until the screen shows it
    tries=0
    until tmux -L "$server" capture-pane -p -t one >"$folder/pane" && grep -q "$1" "$folder/pane"; do
        tries=$((tries + 1))
        [ "$tries" -lt 200 ] || fail "the screen does not come to: $1"
        sleep 0.1
    done
}

# Standard input that is a terminal: somebody who wrote - is told that the program waits.
started "'$program' show -"
seen 'Ctrl-D'
tmux -L "$server" send-keys -t one '{"vertices": {"A": [2, 5], "B": [-4, -3], "C": [5, -3]}, "triangles": ["ABC"]}' Enter C-d
seen '^\$ the prompt'
grep -q '# # # # #' "$folder/pane" || fail "no picture of what was typed"
tmux -L "$server" kill-session -t one

# Long work shows how far it has come, and when it is ended what was done.
started "'$program' trace 512x512.json --vary /vertices/A/0=0:500:501 -o all.jsonl"
seen 'trace: [0-9.]* MB written, [0-9.]* a second'
tmux -L "$server" send-keys -t one C-c
seen 'interrupted: trace: [0-9.]* MB written'
[ -z "$(ls "$folder" | grep all)" ] || fail "files of a trace that was ended"
