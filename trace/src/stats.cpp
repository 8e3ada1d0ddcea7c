// SPDX-License-Identifier: MIT
#include <rastertrace/trace/stats.h>

#include <rastertrace/trace/frame.h>
#include <rastertrace/trace/write_trace.h>

#include <algorithm>

namespace rastertrace {

Stats stats_of(const Trace& trace) {
    Stats stats;
    stats.steps = trace.size();
    const auto count = [&stats](const std::string& kind) {
        const auto known = std::find_if(stats.count.begin(), stats.count.end(),
                                        [&](const auto& entry) { return entry.first == kind; });
        if (known == stats.count.end())
            stats.count.emplace_back(kind, 1);
        else
            ++known->second;
    };

    Replay replay(trace);
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        replay.go_to(n);
        const StepView step = trace.step(n);
        const auto kind = trace.kind_of(n);
        count(kind ? std::string(name_of(*kind)) : step.kind_name());
        if (kind == StepKind::primitive)
            stats.primitives.push_back({step.text("kind"), step.text("name"), 0, 0, {}});
        if (kind == StepKind::skip && !stats.primitives.empty())
            stats.primitives.back().skipped = step.text("why");
        if (kind == StepKind::pixel && trace.canvas.contains(*step.whole("x"), *step.whole("y"))) {
            ++stats.writes;
            if (!stats.primitives.empty()) {
                ++stats.primitives.back().writes;
                stats.primitives.back().over += replay.drew_over() != 0 ? 1 : 0;
            }
        }
    }

    const Image& picture = replay.frame().image;
    stats.canvas = picture.colors().size();
    stats.pixels = picture.drawn();
    stats.frame = frame_name(picture);
    const bool is_comparable = trace.end && !trace.end->frame.empty() && !trace.is_partial;
    stats.frame_differs = is_comparable && trace.end->frame != stats.frame;
    return stats;
}

} // namespace rastertrace
