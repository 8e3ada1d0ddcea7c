#!/bin/sh
# compare.sh COMPILER OBJDUMP SOURCE INCLUDE...: fails if a function has more instructions with emissions than after
# they are removed. (That it has fewer is an accident of the compiler's choices. So is which functions are inlined into
# others: where that differs, the sums are compared.)
set -eu
compiler=$1 objdump=$2 source=$3
shift 3
includes=$(printf -- '-I%s ' "$@")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

instructions() { # instructions NAME FLAG...
    name=$1
    shift
    # For each function how many instructions it has. Which ones is not compared: a compiler chooses between equal ones,
    # ja or jbe, by the numbers of statements, also of those that it removes.
    # shellcheck disable=SC2086  # several folders
    "$compiler" -std=c++20 -DNDEBUG -ffp-contract=off -ffunction-sections -w $includes "$@" \
        -c "$source" -o "$folder/fill.o"
    "$objdump" -d --no-show-raw-insn "$folder/fill.o" |
        awk '/^Disassembly of section/ { section = $4 }
             /^ *[0-9a-f]+:/ && !/nop|xchg +%ax,%ax/ { print section }' |
        LC_ALL=C sort | uniq -c >"$folder/$name"
}

for level in -O2 -O3 "-O3 -march=x86-64-v3"; do
    # shellcheck disable=SC2086  # a level may be two flags
    instructions with $level
    # shellcheck disable=SC2086
    instructions without $level -DWITHOUT_EMISSIONS
    count=$(awk '{ sum += $1 } END { print sum + 0 }' "$folder/with")
    [ "$count" -gt 100 ] || { echo "nothing was compiled"; exit 1; }
    if awk 'NR == FNR { without[$2] = $1; sum += $1; next }
            { rest += $1; more = more || $1 > without[$2] + 0; others = others || !($2 in without); delete without[$2] }
            END { for (name in without) others = 1; exit others ? rest > sum : more }' \
        "$folder/without" "$folder/with"; then
        echo "$compiler $level: $count instructions, none of them for emissions"
    else
        echo "$compiler $level: emissions to NullSink leave a mark in the machine code:"
        diff "$folder/with" "$folder/without" | head -40
        failed=1
    fi
done
exit "${failed:-0}"
