// SPDX-License-Identifier: MIT
// Uses both libraries as somebody else would: draws with the core, writes and reads a trace.

#include <rastertrace/core.h>
#include <rastertrace/core/draw/paint/fill.h>
#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/write_trace.h>

#include <cstdio>

int main() {
    using namespace rastertrace;
    Scene scene;
    scene.canvas = {.width = 17, .height = 14};
    scene.vertices = {{"A", 2, 5, {}}, {"B", -4, -3, {}}, {"C", 5, -3, {}}};
    scene.primitives = {
        {.kind = PrimitiveKind::triangle, .name = "ABC", .vertices = {0, 1, 2}, .color = {}}};
    const Image picture = draw(scene, plan_for(scene));

    Source source{"first.json", {}};
    StringOutput output(source.text);
    write_trace(scene, {}, output);
    const Result<Trace> trace = read_trace(source);
    const bool is_right =
        trace && picture.drawn() == 49 &&
        frame_after(trace.value(), trace.value().size()).image.colors() == picture.colors();
    std::puts(is_right ? "the consumer's picture has 49 pixels"
                       : "the consumer's picture is wrong");
    return is_right ? 0 : 1;
}
