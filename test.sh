#!/bin/sh
# Builds everything and runs the tests. Installs what is missing first, and says so.
# usage: test.sh [--all] [OPTIONS OF CTEST]
# --all: also the tests that need a browser, TeX or other large programs
set -eu
cd "$(dirname "$0")"

all=OFF
if [ "${1:-}" = --all ]; then
    all=ON
    shift
fi

[ "$all" = OFF ] || scripts/install-packages.sh emscripten node-acorn
scripts/install-packages.sh g++ clang cmake ninja-build binutils libglm-dev nlohmann-json3-dev \
    libfmt-dev libcli11-dev libgif-dev libgmp-dev libpng-dev libunistring-dev zlib1g-dev libgtest-dev libgmock-dev librapidcheck-dev libbenchmark-dev libtinyobjloader-dev python3-jsonschema tmux git
[ "$all" = OFF ] || scripts/install-packages.sh asciinema chromium fonts-dejavu-core gdb librsvg2-bin mkdocs poppler-utils \
    python3-pil python3-pymdownx texlive-latex-base texlive-pictures
[ "$all" = OFF ] || command -v npm >/dev/null || scripts/install-packages.sh nodejs npm
[ -f build/test/build.ninja ] || cmake --preset test -G Ninja
cmake -DRASTERTRACE_TEST_ALL="$all" -DRASTERTRACE_WASM="$all" -DRASTERTRACE_BUILD_BENCHMARKS="$all" build/test >/dev/null
cmake --build build/test
status=0
ctest --preset test -j 2 "$@" || status=$?
if [ "$all" = OFF ]; then
    echo
    echo "Left out: figures-in-other-programs, figures-in-tex, pages and site, which need a browser, librsvg, TeX, asciinema, mkdocs and npm."
    echo "./test.sh --all installs these and runs all tests."
    echo "It also builds and tests the module for pages, with Emscripten, and builds and runs the benchmarks."
fi
exit "$status"
