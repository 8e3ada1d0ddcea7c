#!/bin/sh
# Makes the packages, in build/packages: two for Debian, an archive with a program that needs no
# other library, and the sources. Each is tried: scripts/try-packages.sh.
# usage: package.sh [OPTION OF CMAKE...]
set -eu
cd "$(dirname "$0")/.."
# shellcheck disable=SC2046  # a list of words
scripts/install-packages.sh $(cat scripts/program-packages.txt) dpkg-dev emscripten libboost-dev node-acorn
packages=$PWD/build/packages
version=$(sed -n 's/^project(rastertrace VERSION \([^ ]*\).*/\1/p' CMakeLists.txt)
name=rastertrace-$version
rm -rf "$packages"
mkdir -p "$packages"

# The sources as they are committed.
git archive --prefix="$name/" HEAD | gzip -9n >"$packages/$name.tar.gz"

# build FOLDER OPTION...: a release of it, with pages that draw by themselves.
build() {
    folder=$1
    shift
    cmake --preset release -G Ninja -B "$folder" -DRASTERTRACE_WASM=ON -DRASTERTRACE_BUILD_MATCHERS=OFF \
        -DCMAKE_INSTALL_PREFIX=/usr "$@" >/dev/null
    cmake --build "$folder"
}
build build/debian "$@"
cpack --config build/debian/CPackConfig.cmake -G DEB -B "$packages"
rm -rf "$packages/_CPack_Packages"

build build/static -DRASTERTRACE_STATIC=ON "$@"
archive=$name-linux-x86_64
cmake --install build/static --component program --strip --prefix "$packages/$archive" >/dev/null
tar -C "$packages" --sort=name --owner=0 --group=0 --numeric-owner --mtime="@$(git log -1 --format=%ct)" -cf - "$archive" |
    gzip -9n >"$packages/$archive.tar.gz"
rm -rf "${packages:?}/$archive"
ls -l "$packages"
