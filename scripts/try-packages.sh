#!/bin/sh
# Tries what scripts/package.sh has made as somebody would who has never seen it: lintian, a clean root made by
# debootstrap, an empty chroot, the oldest 64-bit processor that qemu has, and a build of the source archive.
# Needs root. Takes some minutes, most of them for the sources.
# usage: try-packages.sh [--without-sources | OPTION OF CMAKE...]
set -eu
cd "$(dirname "$0")/.."
scripts/install-packages.sh lintian debootstrap qemu-user binutils
packages=$PWD/build/packages
folder=$(mktemp -d)
trap 'umount "$folder/root/proc" 2>/dev/null || true; rm -rf "$folder"' EXIT
fail() {
    echo "try-packages.sh: $1" >&2
    exit 1
}

# What the examples say, run in a folder that they were copied to, by the program that is named.
try='set -e; cd "$1"; "$2" examples -o examples >/dev/null
    "$2" show examples/t0-fill/first-triangle.json | grep -c "#" >/dev/null
    "$2" check examples/claims/t0-rows.claims >/dev/null
    "$2" figure examples/t0-fill/first-triangle.json -o first.png
    "$2" figure examples/t0-fill/first-triangle.json -o first.html'

for package in "$packages"/*.deb; do
    lintian --fail-on error "$package"
done

# A clean root: installs with its dependencies, runs as typed, has its manual, and leaves nothing when it is removed.
root=$folder/root
mirror=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' 'Codename: bookworm' | head -n 1)
debootstrap --variant=minbase bookworm "$root" "$mirror" >"$folder/log" 2>&1 || { cat "$folder/log"; exit 1; }
mount -t proc proc "$root/proc"
for package in rastertrace librastertrace-dev; do
    cp "$packages/$package"_*.deb "$root/tmp/$package.deb"
done
cp /etc/apt/sources.list "$root/etc/apt/" 2>/dev/null || true
cp -R /etc/apt/sources.list.d /etc/apt/apt.conf.d "$root/etc/apt/" 2>/dev/null || true
inside() { chroot "$root" env DEBIAN_FRONTEND=noninteractive PATH=/usr/sbin:/usr/bin:/sbin:/bin "$@"; }
inside apt-get update -qq
inside apt-get install -y -qq --no-install-recommends man-db g++ pkg-config >/dev/null
inside apt-get install -y -qq --no-install-recommends /tmp/rastertrace.deb >/dev/null
inside rastertrace --version --verbose
inside mkdir /root/mine
inside sh -c "$try" sh /root/mine rastertrace
inside man rastertrace-play | grep -q 'rastertrace play' || fail "no page of the manual"
inside apt-get install -y -qq --no-install-recommends /tmp/librastertrace-dev.deb >/dev/null
cp tests/consumer/project/main.cpp "$root/root/main.cpp"
inside sh -c 'c++ -std=c++20 /root/main.cpp $(pkg-config --cflags --libs rastertrace) -o /root/consumer && /root/consumer'
inside apt-get purge -y -qq rastertrace librastertrace-dev >/dev/null
inside apt-get autoremove --purge -y -qq >/dev/null
[ -z "$(find "$root/usr" "$root/etc" -name '*rastertrace*')" ] || fail "files are left behind"

# The archive: no dynamic section, runs where there is nothing else, and on the oldest processor.
mkdir "$folder/archive" "$folder/empty" "$folder/old"
tar -C "$folder/archive" -xzf "$packages"/rastertrace-*-linux-x86_64.tar.gz
unpacked=$(echo "$folder"/archive/*)
readelf -d "$unpacked/bin/rastertrace" | grep -q 'There is no dynamic section' || fail "the program of the archive needs libraries"
cp -R "$unpacked"/* "$folder/empty"
chroot "$folder/empty" /bin/rastertrace --version
chroot "$folder/empty" /bin/rastertrace show /share/rastertrace/examples/t0-fill/first-triangle.json
printf '#!/bin/sh\nexec qemu-x86_64 -cpu qemu64 "%s" "$@"\n' "$unpacked/bin/rastertrace" >"$folder/rastertrace"
chmod +x "$folder/rastertrace"
"$unpacked/bin/rastertrace" examples -o "$folder/old/examples" >/dev/null
(cd "$folder/old" && "$folder/rastertrace" check examples/claims/t0-rows.claims >/dev/null &&
    "$folder/rastertrace" figure examples/t0-fill/first-triangle.json -o first.png)

# The sources build, here with shared libraries, and what they give draws the same; a project of somebody else uses it.
[ "${1:-}" != --without-sources ] || exit 0
mkdir "$folder/sources"
tar -C "$folder/sources" -xzf "$(ls "$packages"/rastertrace-*.tar.gz | grep -v linux)"
cd "$folder"/sources/*
cmake --preset release -G Ninja -DBUILD_SHARED_LIBS=ON "$@" >/dev/null
cmake --build build/release
cmake --install build/release --prefix "$folder/shared" >/dev/null
scene=examples/t0-fill/first-triangle.json
"$unpacked/bin/rastertrace" trace $scene >"$folder/trace"
"$folder/shared/bin/rastertrace" trace $scene | cmp - "$folder/trace"
readelf -d "$folder/shared/bin/rastertrace" | grep -q 'NEEDED.*librastertrace_core.so' || fail "expected shared libraries"
cmake -S tests/consumer/project -B "$folder/consumer" -DCMAKE_PREFIX_PATH="$folder/shared" >/dev/null
cmake --build "$folder/consumer"
"$folder/consumer/consumer"
