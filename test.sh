#!/bin/sh
# Builds everything and runs every test. Installs what is missing first, and says so.
set -eu
cd "$(dirname "$0")"

scripts/install-packages.sh g++ clang cmake ninja-build binutils libglm-dev nlohmann-json3-dev \
    libfmt-dev libcli11-dev libgif-dev libgmp-dev libpng-dev libunistring-dev libgtest-dev libgmock-dev librapidcheck-dev libbenchmark-dev libtinyobjloader-dev python3-jsonschema tmux git
[ -f build/test/build.ninja ] || cmake --preset test -G Ninja
cmake --build build/test
ctest --preset test -j 2 "$@"
