// SPDX-License-Identifier: MIT
// Any bytes as a scene: what is wrong with them is said safely, and a scene that can be read can be
// drawn, by every kind of number, and its trace read back to the same picture.

#include "check.h"

#include <rastertrace/trace/describe.h>
#include <rastertrace/trace/frame.h>
#include <rastertrace/trace/scene_file.h>
#include <rastertrace/trace/trace.h>
#include <rastertrace/trace/write_trace.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace rastertrace::fuzz {

namespace {

/// A canvas of the largest size for one triangle, a smaller one for many.
bool can_be_drawn_fast(const Scene& scene) {
    constexpr std::size_t most_triangles = 64;
    constexpr auto most_pixels = std::size_t{largest_side} * largest_side;
    const auto pixels = static_cast<std::size_t>(scene.canvas.width) *
                        static_cast<std::size_t>(scene.canvas.height);
    return is_small(scene.canvas) && scene.primitives.size() <= most_triangles &&
           pixels * scene.primitives.size() <= most_pixels;
}

/// A trace of ours is whole, can be described, and leads to the picture that it names.
void check_trace(const Trace& trace) {
    check(trace.damage.empty(), "the trace of a scene is damaged");

    Replay replay(trace);
    // Pixel steps are many and say little: of them, only the first are described.
    constexpr std::size_t most_described = 1000;
    for (std::size_t n = 0; n <= trace.size(); ++n) {
        replay.go_to(n);
        if (n <= most_described || trace.kind_of(n) != StepKind::pixel)
            check_description(describe_step(replay));
    }

    const Image& picture = replay.frame().image;
    check(trace.end->frame == frame_name(picture), "the replay ends in another picture");
    check(trace.end->pixels == picture.drawn(), "the end record counts other pixels");
}

void draw_and_read_back(const Source& source, const std::string& scalar, TraceLayout layout) {
    const auto scene = read_scene(source, {{"scalar", scalar}});
    if (!scene)
        return check_message(scene.problem());
    if (!can_be_drawn_fast(scene.value().scene))
        return;

    std::string text;
    StringOutput output(text);
    write_trace(scene.value().scene, scene.value().plan, {.layout = layout, .filter = {}}, output);

    const auto trace = read_trace({"fuzz.trace.json", std::move(text)});
    check(static_cast<bool>(trace), "the trace of a scene cannot be read back");
    check_trace(trace.value());
}

} // namespace

} // namespace rastertrace::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace rastertrace;
    const Source source = fuzz::source_of("fuzz.json", data, size);
    fuzz::draw_and_read_back(source, "double", TraceLayout::json);
    fuzz::draw_and_read_back(source, "exact", TraceLayout::jsonl);
    fuzz::draw_and_read_back(source, "float", TraceLayout::jsonl);
    fuzz::draw_and_read_back(source, "fixed", TraceLayout::json);
    return 0;
}
