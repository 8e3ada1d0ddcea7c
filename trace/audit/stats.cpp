// SPDX-License-Identifier: MIT
#include "stats.h"

#include "coverage.h"
#include "part_counts.h"
#include "stats_needs.h"

#include <rastertrace/core/raster/image.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/text/in_threads.h>
#include <rastertrace/trace/text/text.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

/// Takes the parts of a trace, one after the other, and keeps the picture that their pixels make.
class WholeCounts {
public:
    WholeCounts(const Trace& trace, Stats& stats)
        : stats_(stats), needs_(trace), picture_(trace.canvas), is_tied_(picture_.colors().size()) {
    }

    void take_events(PartCounts& part) {
        for (const auto& [what, pixel, color] : part.events) {
            if (what == PixelEvent::What::begin) {
                ++begun_;
                continue;
            }
            Color& before = picture_.at(pixel);
            const std::size_t offset = picture_.canvas().offset_of(pixel);
            if (what == PixelEvent::What::pass) {
                is_tied_[offset] = false;
            } else if (what == PixelEvent::What::tie) {
                if (before != no_color && before != color)
                    is_tied_[offset] = true;
            } else {
                if (begun_ > 0 && before != no_color)
                    ++stats_.primitives[begun_ - 1].over;
                before = color;
            }
        }
        part.events.clear();
    }

    /// Behind its last step.
    void take(const PartCounts& part) {
        kinds_.add(part.kinds);
        stats_.writes += part.writes;
        stats_.wrong_rows.insert(stats_.wrong_rows.end(), part.rows.wrong().begin(),
                                 part.rows.wrong().end());
        needs_.add(part.needs);
    }

    /// Behind the last part.
    void finish() {
        stats_.count = kinds_.all();
        stats_.unjudged = needs_.unjudged();
        const Canvas& canvas = picture_.canvas();
        for (int row = 0; row < canvas.height; ++row)
            for (int x = canvas.left(); x <= canvas.right(); ++x) {
                const Pixel pixel{x, canvas.y_of(row)};
                if (is_tied_[canvas.offset_of(pixel)])
                    stats_.depth_ties.add(pixel);
            }
    }

    const Image& picture() const { return picture_; }

private:
    Stats& stats_;
    KindCounts kinds_;
    StatsNeeds needs_;
    std::size_t begun_ = 0; ///< primitives
    Image picture_;
    std::vector<bool> is_tied_; ///< pixels where a depth test was a tie that decided what is seen
};

/// Steps that one thread takes: from a primitive, or the beginning, to the next part.
struct Part {
    std::size_t first;
    std::size_t primitives_before;
};

/// So many steps are gone through before what they did to pixels is taken.
constexpr std::size_t steps_in_round = 1 << 20;

/// The parts of a trace, of at least so many steps each; behind the last stands the end.
std::vector<Part> parts_of(const Trace& trace, std::size_t least) {
    std::vector<Part> parts{{1, 0}};
    std::size_t primitives = 0;
    for (const std::size_t n : trace.steps_of({StepKind::primitive})) {
        if (n >= parts.back().first + least)
            parts.push_back({n, primitives});
        ++primitives;
    }
    parts.push_back({trace.size() + 1, primitives});
    return parts;
}

/// Counts the steps of a trace, and finds what each primitive has drawn: several parts at a time if they are small, else
/// one in several rounds.
std::vector<DrawnPrimitive> count_steps(const Trace& trace, std::size_t jobs,
                                        std::size_t steps_in_part, WholeCounts& counted,
                                        Stats& stats) {
    const std::vector<Part> parts = parts_of(trace, steps_in_part);
    stats.primitives.resize(parts.back().primitives_before);
    std::vector<DrawnPrimitive> drawn(stats.primitives.size());
    std::vector<StepReader> readers;
    for (std::size_t i = 0; i < jobs; ++i)
        readers.emplace_back(trace);
    for (std::size_t part = 0, end = 0; part + 1 < parts.size(); part = end) {
        end = part + 1;
        while (end + 1 < parts.size() && parts[end + 1].first <= parts[part].first + steps_in_round)
            ++end;
        std::vector<PartCounts> counts;
        counts.reserve(end - part);
        for (std::size_t i = part; i < end; ++i) {
            const std::size_t begun = parts[i].primitives_before;
            const std::size_t count = parts[i + 1].primitives_before - begun;
            counts.emplace_back(trace, std::span(stats.primitives).subspan(begun, count),
                                std::span(drawn).subspan(begun, count));
        }
        for (std::size_t n = parts[part].first; n < parts[end].first; n += steps_in_round) {
            in_threads(counts.size(), jobs, [&](std::size_t i, std::size_t thread) {
                counts[i].take(readers[thread], std::max(n, parts[part + i].first),
                               std::min(n + steps_in_round, parts[part + i + 1].first));
            });
            for (PartCounts& one : counts)
                counted.take_events(one);
        }
        for (std::size_t i = part; i < end; ++i) {
            counts[i - part].finish(i + 2 < parts.size() || trace.end);
            counted.take(counts[i - part]);
        }
    }
    counted.finish();
    return drawn;
}

} // namespace

std::string_view name_of(StatsFinding finding) {
    switch (finding) {
    case StatsFinding::holes:
        return "holes";
    case StatsFinding::twice:
        return "twice";
    case StatsFinding::outside:
        return "outside";
    case StatsFinding::rows:
        return "rows";
    case StatsFinding::redo:
        break;
    }
    return "redo";
}

std::string names_of(const std::vector<StatsFinding>& findings) {
    std::vector<std::string_view> names;
    for (const StatsFinding finding : findings)
        names.push_back(name_of(finding));
    return joined(names, ", ");
}

Stats stats_of(const Trace& trace, std::size_t jobs, std::size_t steps_in_part) {
    jobs = jobs_or_usual(jobs);
    Stats stats;
    stats.steps = trace.size();
    WholeCounts counted(trace, stats);
    std::vector<DrawnPrimitive> drawn = count_steps(trace, jobs, steps_in_part, counted, stats);

    // Against what should have been drawn, where all of that can be there.
    if (!trace.end && !drawn.empty())
        drawn.pop_back();
    if (!trace.is_partial)
        compare_with_corners(trace, drawn, jobs, stats);

    // The picture that came of it.
    const Image& picture = counted.picture();
    stats.canvas = picture.colors().size();
    stats.pixels = picture.drawn();
    stats.frame = frame_name(picture);
    const bool is_comparable = trace.end && !trace.end->frame.empty() && !trace.is_partial;
    stats.frame_differs = is_comparable && trace.end->frame != stats.frame;
    return stats;
}

} // namespace rastertrace
