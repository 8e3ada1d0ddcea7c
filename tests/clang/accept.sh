#!/bin/sh
# accept.sh CLANGXX OPTION... -- COMPILE_COMMANDS [PART OF A PATH...]: fails if clang++ refuses, or warns of, a public header, or
# a source that is compiled beside the tests and has none of the parts in its path. Runs in the folder of the project. Nothing
# is generated, but all templates in use are instantiated.
set -eu
compiler=$1
shift
if ! command -v "$compiler" >/dev/null; then
    echo "clang++ is missing: ./test.sh installs it, or apt-get install clang" >&2
    exit 1
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# The options turn into "$@", and the sources into lines of a file.
for word; do
    shift
    if [ -f "$folder/sources" ]; then
        grep -vF -e "$word" "$folder/sources" >"$folder/others"
        mv "$folder/others" "$folder/sources"
    elif [ "${behind_options:-}" ]; then
        sed -n 's/^ *"file": "\(.*\)",*$/\1/p' "$word" |
            grep -vF -e "$PWD/tests/" -e "$(dirname "$word")/tests/" -e "$PWD/examples/" -e /numerics/ -e /page/ -e /cmake_pch. | LC_ALL=C sort >"$folder/sources"
    elif [ "$word" = -- ]; then
        behind_options=yes
    else
        set -- "$@" "$word"
    fi
done
accepts() { # accepts ARGUMENT...
    "$compiler" -std=c++20 "$@" -Werror -Wno-unknown-warning-option # g++ knows other warnings
}

# All public headers, and what most of the sources include besides, are read once.
for include in core/include core/draw/include trace/testing/include trace/emit/include trace/figures/include trace/numerics/include; do
    (cd "$include" && find rastertrace -name '*.h' | LC_ALL=C sort | sed 's/.*/#include <&>/')
done >"$folder/headers.h"
# Those of trace lie beside the sources.
find trace -name '*.h' | grep -v '^trace/testing/\|^trace/emit/\|^trace/figures/\|^trace/numerics/' | LC_ALL=C sort | sed 's,.*,#include <rastertrace/&>,' \
    >>"$folder/headers.h"
printf '#include <%s>\n' fmt/format.h nlohmann/json.hpp CLI/CLI.hpp >>"$folder/headers.h"
accepts "$@" -x c++-header -fpch-instantiate-templates "$folder/headers.h" -o "$folder/headers.pch"

while read -r source; do
    accepts "$@" -include-pch "$folder/headers.pch" -fsyntax-only "$source" || failed=1
done <"$folder/sources"
echo "$(wc -l <"$folder/headers.h") headers, $(wc -l <"$folder/sources") sources"
exit "${failed:-0}"
