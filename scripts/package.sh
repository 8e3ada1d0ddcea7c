#!/bin/sh
# Makes what can be carried away, in build/packages: two packages for Debian, an archive with a program that needs no
# other library, and the sources. Each is tried: scripts/try-packages.sh.
# usage: package.sh
set -eu
cd "$(dirname "$0")/.."
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
build build/debian
cpack --config build/debian/CPackConfig.cmake -G DEB -B "$packages"
build build/static -DRASTERTRACE_STATIC=ON
cpack --config build/static/CPackConfig.cmake -G TGZ -B "$packages" -D CPACK_PACKAGING_INSTALL_PREFIX=/ -D CPACK_COMPONENTS_ALL=program
rm -rf "$packages/_CPack_Packages"
ls -l "$packages"
