#!/bin/bash
# What is seen in terminals of four sizes: pictures of their screens, as tmux has them, in the folder `screens`.
# usage: player_screens.sh PROGRAM EXAMPLES SCREENS
# RENEW_SCREENS=1: writes them anew, to be looked at.
set -eu

program=$1
examples=$2
screens=$3
folder=$(mktemp -d)
server="rastertrace-screens-$$"
trap 'tmux -L "$server" kill-server 2>/dev/null || true; rm -rf "$folder"' EXIT
status=0

# compare NAME COLUMNS LINES ARGUMENTS: the screen once the trace has been read and its wrong steps are looked for.
compare() {
    name=$1-$2x$3
    tmux -L "$server" -f /dev/null new-session -d -s one -x "$2" -y "$3" \
        "env TERM=tmux-256color LANG=C.UTF-8 NO_COLOR=1 '$program' play $4; sleep 60"
    tries=0
    last=
    until now=$(tmux -L "$server" capture-pane -p -t one) && grep -q "keys" <<<"$now" && [ "$now" = "$last" ]; do
        tries=$((tries + 1))
        if [ "$tries" -gt 200 ]; then
            echo "player_screens.sh: $name: no screen that stays" >&2
            exit 1
        fi
        last=$now
        sleep 0.1
    done
    tmux -L "$server" kill-session -t one
    printf '%s\n' "$now" >"$folder/$name.txt"
    if [ "$(awk -v columns="$2" 'length($0) > columns' "$folder/$name.txt" | wc -l)" -ne 0 ]; then
        echo "player_screens.sh: $name: a line is wider than the terminal" >&2
        status=1
    fi
    if [ -n "${RENEW_SCREENS:-}" ]; then
        cp "$folder/$name.txt" "$screens/$name.txt"
    elif ! diff -u "$screens/$name.txt" "$folder/$name.txt"; then
        status=1
    fi
}

tmux -L "$server" -f /dev/null new-session -d -s waiting "sleep 600"
for size in "40 12" "80 24" "100 30" "200 60"; do
    # shellcheck disable=SC2086 # two words
    {
        compare row $size "$examples/t0-fill/first-triangle.json --step 'scanline y=2'"
        compare decision $size "$examples/t2-lines/bresenham.json --step 'decide x=1'"
        compare depth $size "$examples/t0-hidden/two-depths.json --step 71"
        compare space $size "$examples/t4-pipeline/six-spaces.json --step 8"
    }
done
exit "$status"
