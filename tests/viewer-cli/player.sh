#!/bin/bash
# The player in a real terminal, in tmux: every key, three sizes, other sizes meanwhile, colors and none, and the
# terminal as it was before on every way out.
# usage: player.sh PROGRAM EXAMPLES
set -eu

program=$1
examples=$2
folder=$(mktemp -d)
server="rastertrace-player-$$"
trap 'tmux -L "$server" kill-server 2>/dev/null || true; rm -rf "$folder"' EXIT
cp "$examples/t0-fill/first-triangle.json" "$folder/triangle.json"
scene="$folder/triangle.json"

fail() {
    echo "player.sh: $1" >&2
    tmux -L "$server" capture-pane -p -t one 2>/dev/null | sed 's/^/  |/' >&2 || true
    exit 1
}

screen() {
    tmux -L "$server" capture-pane -p "$@" -t one
}

keys() {
    tmux -L "$server" send-keys -t one "$@"
}

# wait_for PATTERN: until a line of the screen has it.
wait_for() {
    tries=0
    until screen | grep -q -e "$1"; do
        tries=$((tries + 1))
        [ "$tries" -lt 400 ] || fail "waited for: $1"
        sleep 0.05
    done
}

# begin COLUMNS LINES ENVIRONMENT ARGUMENTS: a shell that plays, and tells how that ended, and its terminal.
begin() {
    tmux -L "$server" new-session -d -s one -x "$1" -y "$2" \
        "env $3 sh -c 'stty -g >$folder/before; \"$program\" play $4; echo \"status \$?\" >$folder/status; stty -g >$folder/after; echo the end; sleep 60'"
}

# end STATUS: the player has ended with it, and left the terminal as it was.
end() {
    wait_for "^the end"
    grep -q "^status $1\$" "$folder/status" || fail "expected status $1, found: $(cat "$folder/status")"
    cmp -s "$folder/before" "$folder/after" || fail "the terminal's settings have changed"
    screen | grep -q "nothing drawn yet" && fail "the screen of the player is still there"
    tmux -L "$server" kill-session -t one
}

# A server without a session ends; this one lasts as long as the test.
tmux -L "$server" -f /dev/null new-session -d -s waiting "sleep 600"

# Every key, at three sizes.
for size in "80 24" "40 12" "300 100" "10 3"; do
    # shellcheck disable=SC2086 # two words
    begin $size "TERM=tmux-256color LANG=C.UTF-8" "$scene"
    wait_for "of 62"
    for key in Right l Left h Down j Up k ']' '[' ')' '(' '}' '{' . , g Home G End Space p + - '?' '?' '?' F1 Escape \
        S-Left H S-Down J S-Up K S-Right L c v V v v o o z z z Z Z Z Z w w C-d C-u f F r C-l B n N 1 4 G Escape; do
        keys "$key"
    done
    keys / s c a n l i n e Space y = 2 Enter
    wait_for "14 of 62"
    keys b p i x e l Enter Space
    wait_for "15 of 62" # the breakpoint
    keys q
    end 0
done

# 200 moves: the rows of pixels are those that `show` prints.
begin 80 24 "TERM=tmux-256color NO_COLOR=1" "$scene"
wait_for "step 0 of 62"
at=0
awk 'BEGIN { srand(7); for (i = 0; i < 200; ++i) print int(rand() * 5), int(rand() * 63) }' >"$folder/moves"
while read -r kind to; do
    case $kind in
    0) keys Right && at=$((at < 62 ? at + 1 : 62)) ;;
    1) keys Left && at=$((at > 0 ? at - 1 : 0)) ;;
    *) keys "$to" G && at=$to ;;
    esac
    wait_for "^First triangle .* step $at of 62"
    "$program" show "$scene" --step "$at" | grep -E '^[ >]+-?[0-9]+   ' >"$folder/rows"
    screen >"$folder/screen"
    # + are the pixels to come, which show does not mark
    cut -c 1-39 "$folder/screen" | sed 's/ *$//; s/+/./g' | grep -E '^[ >]+-?[0-9]+   [^ ]' >"$folder/played"
    cmp -s "$folder/rows" "$folder/played" || {
        diff "$folder/rows" "$folder/played" >&2
        fail "step $at is not what show prints"
    }
done <"$folder/moves"
screen -e | grep -q "$(printf '\033\[[34]8')" && fail "NO_COLOR has colors"
keys q
end 0

# The mouse: row y=2, a pixel of the triangle.
begin 80 24 "TERM=tmux-256color" "$scene --step last"
wait_for "step 62 of 62"
row=$(screen | grep -n '^ *2   ' | cut -d : -f 1)
keys -l "$(printf '\033[<0;22;%dM' "$row")"
wait_for "pixel (0, 2): drawn by ABC at step 16"
# Another size, while it plays on.
keys 3 1 G
wait_for "step 31 of 62"
tmux -L "$server" resize-window -t one -x 60 -y 16
wait_for "step 31 of 62"
[ "$(screen | wc -l)" -le 16 ] || fail "more lines than the terminal has"
tmux -L "$server" resize-window -t one -x 120 -y 40
wait_for "scalar exact"
keys q
end 0

# Colors: of a scene that has them.
begin 80 24 "TERM=tmux-256color COLORTERM=truecolor LANG=C.UTF-8" "$examples/t0-hidden/painters-cycle.json --step last"
wait_for "? keys"
screen -e | grep -q "$(printf '\033\[')" || fail "there are no colors"
keys Z
wait_for "[▀▄]"
keys q
wait_for "^the end"
tmux -L "$server" kill-session -t one

# No terminal to be played on: what show prints, and why.
begin 80 24 "TERM=dumb" "$scene"
wait_for "no terminal that can be played on"
end 0
"$program" play "$scene" >"$folder/out" 2>"$folder/err" </dev/null
"$program" show "$scene" --working | cmp - "$folder/out" || fail "without a terminal: not what show prints"
[ "$(wc -l <"$folder/err")" = 1 ] || fail "expected one line about it, found $(cat "$folder/err")"

# A pipe.
tmux -L "$server" new-session -d -s one -x 80 -y 24 \
    "'$program' trace '$scene' -o - --format jsonl | '$program' play -; echo the end; sleep 60"
wait_for "step 0 of 62"
keys G
wait_for "step 62 of 62"
keys q
wait_for "^the end"
tmux -L "$server" kill-session -t one

# Every way out. A signal that ends the player is told to the shell.
pid() {
    pgrep -f "^$program play $scene"
}
for signal in TERM HUP ABRT SEGV; do
    # A program with the sanitizers would handle it by itself.
    begin 80 24 "ASAN_OPTIONS=handle_segv=0 TERM=tmux-256color" "$scene"
    wait_for "step 0 of 62"
    kill -"$signal" "$(pid)"
    end $((128 + $(kill -l "$signal")))
done
# Ctrl-C and Ctrl-Z, in a shell with jobs.
tmux -L "$server" new-session -d -s one -x 80 -y 24 "env TERM=tmux-256color PS1='ready> ' bash --norc --noprofile -i"
wait_for "ready>"
keys "stty -g >$folder/before; $program play $scene" Enter
wait_for "step 0 of 62"
keys C-z
wait_for "Stopped"
keys "stty -g >$folder/after; fg" Enter
wait_for "step 0 of 62"
keys G
wait_for "step 62 of 62"
keys C-c
wait_for "ready>"
keys "status=\$?; stty -g >$folder/later; echo status \$status" Enter
wait_for "status 130"
# A shell that edits its line has other settings than its commands: compare what commands see.
cmp -s "$folder/before" "$folder/after" || fail "after Ctrl-Z the terminal's settings have changed"
cmp -s "$folder/before" "$folder/later" || fail "after Ctrl-C the terminal's settings have changed"
tmux -L "$server" kill-session -t one

# A file that is changed meanwhile.
"$program" trace "$scene" -o "$folder/trace.jsonl"
begin 80 24 "TERM=tmux-256color" "$folder/trace.jsonl --step last"
wait_for "step 62 of 62"
truncate -s 2000 "$folder/trace.jsonl"
keys Left
wait_for "step 61 of 62"
keys r
wait_for "truncated after"
keys q
end 2
