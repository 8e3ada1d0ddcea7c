#!/bin/sh
# Builds everything and runs the tests. Installs what is missing first, and says so.
# usage: test.sh [--all] [OPTIONS OF CTEST]
# --all: also the tests that build other projects, renew whole pages, or need another compiler, Python, a browser or TeX
set -eu
cd "$(dirname "$0")"

all=OFF
if [ "${1:-}" = --all ]; then
    all=ON
    shift
fi

[ "$all" = OFF ] || scripts/install-packages.sh emscripten libboost-dev node-acorn
# shellcheck disable=SC2046  # a list of words
scripts/install-packages.sh $(cat scripts/program-packages.txt) binutils libgtest-dev libgmock-dev librapidcheck-dev libtinyobjloader-dev \
    tmux git
[ "$all" = OFF ] || scripts/install-packages.sh bsdextrautils chromium clang fish fonts-dejavu-core gdb libbenchmark-dev libosmesa6-dev librsvg2-bin man-db \
    mkdocs pandoc pkg-config poppler-utils python3-ipykernel python3-jsonschema python3-nbconvert python3-pil python3-pymdownx python3-sphinx \
    texlive-latex-base texlive-latex-recommended texlive-pictures zsh
[ "$all" = OFF ] || command -v rustc >/dev/null || scripts/install-packages.sh rustc
[ "$all" = OFF ] || command -v npm >/dev/null || scripts/install-packages.sh nodejs npm
[ -f build/test/build.ninja ] || cmake --preset test -G Ninja -DCMAKE_UNITY_BUILD=ON
cmake -DRASTERTRACE_TEST_ALL="$all" -DRASTERTRACE_WASM="$all" -DRASTERTRACE_BUILD_BENCHMARKS="$all" build/test >/dev/null
cmake --build build/test
status=0
ctest --preset test -j 3 "$@" || status=$? # on two cores: some wait for a browser or a terminal
if [ "$all" = OFF ]; then
    echo
    cat <<'END'
Left out, as they
- build other projects: Consumer.*, Algorithms.ANewOneIsMissedInEveryTable, StepKinds.ANewOneIsThreeFiles
- renew whole pages: docs-are-up-to-date, stress
- need another compiler: BitmapsAreTheSameByAnyCompiler, ClangAcceptsTheSources, NullSinkCostsNothing.clang++, wasm-*
- need other programs: schemas (jsonschema), walk (gdb), benchmarks, against-mesa-*, figures-in-other-programs, figures-in-tex, pages, site, python (nbconvert)
- need Python, node and rustc: Emit.foreign, Emit.page
- need node and npm: editors
./test.sh --all installs what these need (also a browser, TeX and Emscripten), and runs all tests.
END
fi
exit "$status"
