#!/bin/sh
# Same scene, same bytes: builds the program with other compilers, flags and machines, draws every example with each, and
# compares the hashes of the traces. Cross builds run by qemu. (The module for pages, of 32 bits, is compared with the
# program by the test wasm-module.) The last results are in docs/performance.md.
# usage: same-bytes.sh [NAME...]     all of the table below if none is named
set -eu
cd "$(dirname "$0")/.."

# NAME COMPILER FLAGS
table='g++-O3 g++ -O3
g++-O0 g++ -O0
g++-x86-64-v3 g++ -O3 -march=x86-64-v3
clang++-O2 clang++ -O2
arm64 aarch64-linux-gnu-g++ -O1
s390x s390x-linux-gnu-g++ -O1'

folder=$PWD/build/same-bytes
mkdir -p "$folder"

# hashes NAME PROGRAM...: of the trace of every example that is a scene, in the words of sha256sum.
hashes() {
    name=$1
    shift
    find examples -name '*.json' | LC_ALL=C sort | while read -r scene; do
        "$@" trace "$scene" --frame 1 --format jsonl >"$folder/trace" 2>/dev/null || echo "refused by $name" >"$folder/trace"
        echo "$(sha256sum <"$folder/trace") $scene"
    done >"$folder/$name.hashes"
}

# The compiler for another machine, what runs its programs, and its libraries, which are not installed but only unpacked:
# unpack_for ARCHITECTURE MACHINE FOLDER
unpack_for() {
    dpkg --print-foreign-architectures | grep -qx "$1" || {
        dpkg --add-architecture "$1"
        apt-get update -qq
    }
    scripts/install-packages.sh qemu-user "g++-$2-linux-gnu"
    mkdir -p "$3/packages"
    (cd "$3/packages" && apt-get download -qq "libagg-dev:$1" "libfmt-dev:$1" "libfmt9:$1" "libgif-dev:$1" \
        "libgmp-dev:$1" "libpng-dev:$1" "libunistring-dev:$1" "zlib1g-dev:$1")
    for package in "$3/packages"/*.deb; do
        dpkg-deb -x "$package" "$3"
    done
}

echo "| build | examples | differ from g++ -O3 |"
echo "|---|---|---|"
echo "$table" | while read -r name compiler flags; do
    case " g++-O3 ${*:-$name} " in *" $name "*) ;; *) continue ;; esac
    case $name in
    arm64) machine=aarch64 ;;
    s390x) machine=s390x ;;
    *) machine= ;;
    esac
    run=
    include=
    other=
    if [ "$machine" ]; then
        root=$folder/$name-root
        [ -d "$root/usr" ] || unpack_for "$name" "$machine" "$root"
        run=qemu-$machine
        include="-isystem $root/usr/include/$machine-linux-gnu"
        other="-DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=$machine -DRASTERTRACE_STATIC=ON
            -DCMAKE_FIND_ROOT_PATH=$root -DCMAKE_FIND_ROOT_PATH_MODE_LIBRARY=ONLY -DCMAKE_FIND_ROOT_PATH_MODE_PROGRAM=NEVER"
    fi
    build=$folder/$name
    # shellcheck disable=SC2086  # lists of words
    cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_UNITY_BUILD=ON -DRASTERTRACE_BUILD_TESTS=OFF \
        -DRASTERTRACE_BUILD_MATCHERS=OFF -DRASTERTRACE_INSTALL=OFF -DCMAKE_CXX_COMPILER="$compiler" \
        -DCMAKE_CXX_FLAGS="$flags -DNDEBUG $include" $other >/dev/null
    cmake --build "$build" --target rastertrace_program >"$build/log" || { tail -n 20 "$build/log" >&2; exit 1; }
    # shellcheck disable=SC2086  # a list of words
    hashes "$name" $run "$build/viewer-cli/rastertrace"
    differing=$(diff "$folder/g++-O3.hashes" "$folder/$name.hashes" | grep -c '^>') || true
    echo "| $compiler $flags | $(wc -l <"$folder/$name.hashes") | $differing |"
    [ "$differing" = 0 ] || exit 1
done
