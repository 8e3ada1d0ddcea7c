// SPDX-License-Identifier: MIT
// `rastertrace stats`: what a trace amounts to.

#include "commands.h"
#include "load.h"

#include <rastertrace/trace/stats.h>
#include <rastertrace/trace/text.h>

#include <fmt/format.h>

#include <iterator>

namespace rastertrace {

namespace {

std::string as_text(const Trace& trace, const Stats& stats) {
    std::string text = shortened(printable(trace.title), 79) + "\n";
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "steps       {}\n", stats.steps);
    for (const auto& [kind, count] : stats.count)
        fmt::format_to(out, "  {:<9} {}\n", shortened(printable(kind), 30), count);
    fmt::format_to(out, "pixels      {} of {} on the canvas\n", stats.pixels, stats.canvas);
    fmt::format_to(out, "writes      {}, {} of them over a pixel drawn before\n", stats.writes,
                   stats.writes - stats.pixels);
    fmt::format_to(out, "frame       {}{}\n", stats.frame,
                   stats.frame_differs
                       ? ", not " + printable(trace.end->frame) + " as the end record says"
                       : "");
    for (const PrimitiveStats& primitive : stats.primitives) {
        fmt::format_to(out, "{} {}: {} writes", shortened(printable(primitive.kind), 30),
                       shortened(printable(primitive.name), 60), primitive.writes);
        if (primitive.over > 0)
            fmt::format_to(out, ", {} over a pixel drawn before", primitive.over);
        if (!primitive.skipped.empty())
            fmt::format_to(out, ", skipped: {}", printable(primitive.skipped));
        text += '\n';
    }
    if (trace.is_partial)
        text += "steps were left out when this trace was written; the counts are of those it has\n";
    return text;
}

std::string as_json(const Trace& trace, const Stats& stats) {
    std::string text =
        fmt::format(R"({{"title":{},"steps":{},"count":{{)", json_quoted(trace.title), stats.steps);
    const auto out = std::back_inserter(text);
    std::string_view separator;
    for (const auto& [kind, count] : stats.count) {
        fmt::format_to(out, "{}{}:{}", separator, json_quoted(kind), count);
        separator = ",";
    }
    fmt::format_to(out, R"(}},"canvas":{},"pixels":{},"writes":{},"frame":"{}","frame_differs":{})",
                   stats.canvas, stats.pixels, stats.writes, stats.frame, stats.frame_differs);
    text += R"(,"primitives":[)";
    separator = "";
    for (const PrimitiveStats& primitive : stats.primitives) {
        fmt::format_to(out, R"({}{{"kind":{},"name":{},"writes":{},"over":{})", separator,
                       json_quoted(primitive.kind), json_quoted(primitive.name), primitive.writes,
                       primitive.over);
        if (!primitive.skipped.empty())
            fmt::format_to(out, R"(,"skipped":{})", json_quoted(primitive.skipped));
        text += '}';
        separator = ",";
    }
    return text + "]}\n";
}

} // namespace

int run(const StatsCommand& command) {
    const Trace trace = load_trace(command.trace, command.method);
    const Stats stats = stats_of(trace);
    print(command.json ? as_json(trace, stats) : as_text(trace, stats));
    const ExitStatus damage = report_damage(trace);
    if (damage != exit_fine)
        return damage;
    return stats.frame_differs ? exit_difference : exit_fine;
}

} // namespace rastertrace
