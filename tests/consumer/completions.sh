#!/bin/sh
# completions.sh PREFIX: bash, zsh and fish complete words by the files that are installed.
set -eu
prefix=$1
export PATH="$prefix/bin:$PATH"
scene=$prefix/share/rastertrace/examples/t0-fill/first-triangle.json
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export HOME="$folder"

# By each shell: what the last word of a line becomes.
by_bash() {
    bash -c '. "$1"; COMP_WORDS=($2); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _rastertrace; printf "%s\n" "${COMPREPLY[@]}"' \
        bash "$prefix/share/bash-completion/completions/rastertrace" "$1"
}
by_fish() {
    fish -c 'source $argv[1]; complete -C $argv[2]' "$prefix/share/fish/vendor_completions.d/rastertrace.fish" "$1"
}
by_zsh() { # there is no way to ask zsh but by keys on a terminal
    zsh -fc 'zmodload zsh/zpty
        zpty shell zsh -f
        zpty -w shell "PROMPT= ; fpath=($1 \$fpath); autoload -Uz compinit; compinit -D; bindkey \"^I\" complete-word; print ready"
        zpty -r -m shell line "*ready*ready*"
        zpty -n -w shell "$2"$'"'\\t'"'
        sleep 2
        zpty -n -w shell $'"'\\n'"'
        zpty -r -t shell line; while zpty -r -t shell more; do line+=$more; done
        print -r -- "$line"' zsh "$prefix/share/zsh/site-functions" "$1"
}

for shell in bash zsh fish; do
    while IFS='|' read -r line expected; do
        found=$(by_$shell "$line")
        case $found in
        *"$expected"*) ;;
        *)
            echo "completions.sh: $shell: $line: expected $expected, found: $found" >&2
            exit 1
            ;;
        esac
    done <<END
rastertrace expl|explain
rastertrace show --fill two|two-halves
rastertrace trace $scene --primitive A|ABC
END
done
