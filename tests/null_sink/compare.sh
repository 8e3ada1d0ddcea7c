#!/bin/sh
# compare.sh COMPILER OBJDUMP SOURCE INCLUDE...: fails if removing the emissions changes the machine code.
set -eu
compiler=$1 objdump=$2 source=$3
shift 3
includes=$(printf -- '-I%s ' "$@")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

disassembly() { # disassembly NAME FLAG...
    name=$1
    shift
    # Each function in a section of its own, and these by name: a compiler may put the same functions
    # in another order.
    # shellcheck disable=SC2086  # several folders
    "$compiler" -std=c++20 -DNDEBUG -ffp-contract=off -ffunction-sections -w $includes "$@" \
        -c "$source" -o "$folder/fill.o"
    "$objdump" -d --no-show-raw-insn "$folder/fill.o" | tail -n +4 |
        awk '/^Disassembly of section/ { section = $4 } { print section "\t" $0 }' |
        LC_ALL=C sort -s -t "$(printf '\t')" -k 1,1 | cut -f 2- >"$folder/$name"
}

for level in -O2 -O3 "-O3 -march=x86-64-v3"; do
    # shellcheck disable=SC2086  # a level may be two flags
    disassembly with $level
    # shellcheck disable=SC2086
    disassembly without $level -DWITHOUT_EMISSIONS
    lines=$(wc -l <"$folder/with")
    if ! cmp -s "$folder/with" "$folder/without"; then
        echo "$compiler $level: emissions to NullSink leave a mark in the machine code:"
        diff "$folder/with" "$folder/without" | head -40
        failed=1
    fi
    [ "$lines" -gt 100 ] || { echo "nothing was compiled"; exit 1; }
    echo "$compiler $level: $lines lines, identical"
done
exit "${failed:-0}"
