#!/bin/sh
# walk.sh BUILD: from draw() to a pixel of a flat triangle. Prints the functions of ours that are on the way, with
# gdb at the flat painter, and fails if there are more than 9. BUILD has the libraries, in core/.
set -eu
cd "$(dirname "$0")/.."
build=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

cat >"$folder/main.cpp" <<'END'
#include <rastertrace/core.h>

int main() {
    rastertrace::Scene scene;
    scene.canvas = {.width = 17, .height = 14};
    scene.vertices = {{"A", 2, 5, {}}, {"B", -4, -3, {}}, {"C", 5, -3, {}}};
    scene.primitives = {{.kind = rastertrace::PrimitiveKind::triangle,
                         .name = "ABC",
                         .vertices = {0, 1, 2},
                         .color = {}}};
    return rastertrace::draw(scene, plan_for(scene)).drawn() == 49 ? 0 : 1;
}
END
# What is on the way is compiled for gdb; the rest comes from the libraries.
"${CXX:-g++}" -std=c++20 -O0 -g -Icore/include -Icore/draw/include -Icore/draw/src \
    "$folder/main.cpp" core/draw/src/draw.cpp core/draw/src/draw_in_double.cpp \
    "$build/core/draw/librastertrace_draw.a" "$build/core/librastertrace_core.a" -lgmpxx -lgmp -o "$folder/walk"
line=$(grep -n 'colors\[x\] = color;' core/include/rastertrace/core/raster/flat_painter.h | cut -d: -f1)
gdb -batch -nx -ex "break flat_painter.h:$line" -ex run -ex bt "$folder/walk" >"$folder/gdb" 2>&1 ||
    { cat "$folder/gdb"; exit 1; }

# "#3  0x... in rastertrace::fill<...> (triangle=...": the names alone. std:: is not counted, nor main.
sed -n 's/^#[0-9]* *\(0x[0-9a-f]* in \)\{0,1\}//p' "$folder/gdb" | grep '^rastertrace::' |
    sed 's/ (.*//; s/rastertrace:://g' >"$folder/frames"
tac "$folder/frames"
count=$(wc -l <"$folder/frames")
[ "$count" -ge 5 ] || { cat "$folder/gdb"; exit 1; }
[ "$count" -le 9 ] || { echo "$count functions of ours between draw() and a pixel: 9 are allowed"; exit 1; }
