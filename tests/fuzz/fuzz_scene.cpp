// SPDX-License-Identifier: MIT
// Any bytes as a scene: what is wrong with them is said safely, and a scene that can be read can be
// drawn, and its trace read back to the same picture. The input chooses the kind of number.

#include "check.h"

#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/tell/describe.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace rastertrace::fuzz {

namespace {

/// The most primitives that are drawn, and bytes of their trace.
constexpr std::size_t most_primitives = 16;
constexpr std::size_t longest_trace = 32768;

/// Keeps a trace, unless it is too long.
class ShortOutput final : public Output {
public:
    void write(std::string_view bytes) override {
        if (text.size() + bytes.size() > longest_trace)
            throw Problem{.message = "too long"};
        text += bytes;
    }

    std::string text;
};

/// A trace of ours is whole, can be described, and leads to the picture that it names.
void check_trace(const Trace& trace) {
    check(trace.damage.empty(), "the trace of a scene is damaged");

    Replay replay(trace);
    // Steps of a kind say much the same: the first ones of each are described.
    check_description(describe_step(replay));
    std::array<int, step_kinds> described{};
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        replay.go_to(n);
        if (++described[static_cast<std::size_t>(*trace.kind_of(n))] <= 8)
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
    const Scene& drawn = scene.value().scene;
    if (!is_small(drawn.canvas) || drawn.primitives.size() > most_primitives)
        return;

    ShortOutput output;
    try {
        write_trace(drawn, scene.value().plan, {.layout = layout, .filter = {}}, output);
    } catch (const Problem&) {
        return;
    }
    const auto trace = read_trace({"fuzz.trace.json", std::move(output.text)});
    check(static_cast<bool>(trace), "the trace of a scene cannot be read back");
    check_trace(trace.value());
}

} // namespace

} // namespace rastertrace::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace rastertrace;
    const Source source = fuzz::source_of("fuzz.json", data, size);
    const std::size_t choice = std::hash<std::string>()(source.text);
    const std::array<std::string, 5> scalars{"double", "exact", "adaptive", "float", "fixed"};
    fuzz::draw_and_read_back(source, scalars[choice % scalars.size()],
                             choice / scalars.size() % 2 == 0 ? TraceLayout::json
                                                              : TraceLayout::jsonl);
    return 0;
}
