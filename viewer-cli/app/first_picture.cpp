// SPDX-License-Identifier: MIT
// What `rastertrace show SCENE` prints of an example, by what draws and tells alone: demo.sh shows it while the rest of the
// program is built.

#include "frames/frame_text.h"

#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/scene/scene_file.h>

#include <iostream>

int main(int count, char** words) {
    using namespace rastertrace;
    const auto source = read_source(count > 1 ? words[1] : "");
    if (!source) {
        std::cerr << to_text(source.problem()) << "\n";
        return 2;
    }
    const auto scene = read_scene(source.value());
    if (!scene) {
        std::cerr << to_text(scene.problem()) << "\n";
        return 2;
    }
    const Trace trace = drawn_trace(scene.value().scene, scene.value().plan, source.value().name,
                                    InputLimits().steps);
    const View view = default_view(trace);
    Replay replay(trace, parts_for(view, trace));
    replay.go_to(trace.size());
    const FrameText about{.caption = {},
                          .view = view,
                          .colors = output_colors(ColorChoice::automatic),
                          .below = text_below(trace)};
    std::cout << summary_text(replay, about, output_size());
}
