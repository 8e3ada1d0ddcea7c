// SPDX-License-Identifier: MIT
// `rastertrace stats`: what a trace amounts to.

#include "commands.h"
#include "load.h"

#include <rastertrace/trace/stats.h>
#include <rastertrace/trace/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>

namespace rastertrace {

namespace {

/// How many pixels of each finding the text names.
constexpr std::size_t most_pixels_named = 12;

/// A name from a file, fit for a line of text.
std::string shown(std::string_view name) {
    return shortened(printable(name), 60);
}

std::string counted(std::uint64_t count) {
    return fmt::format("{} pixel{}", count, count == 1 ? "" : "s");
}

/// The coordinates of what was found, behind a colon; "" if nothing was.
std::string places_of(const PixelList& pixels) {
    if (pixels.count == 0)
        return {};
    std::string text = ":";
    const std::size_t named = std::min(pixels.kept.size(), most_pixels_named);
    for (std::size_t i = 0; i < named; ++i)
        text += fmt::format(" ({}, {})", pixels.kept[i].x, pixels.kept[i].y);
    if (pixels.count > named)
        text += fmt::format(" ... and {} more", pixels.count - named);
    return text;
}

/// What a triangle missed and what it drew too much, a line each.
std::string as_text(const Coverage& coverage) {
    const auto line = [](const PixelList& pixels, std::string_view what) {
        return pixels.count == 0
                   ? std::string()
                   : fmt::format("  {} {}{}\n", counted(pixels.count), what, places_of(pixels));
    };
    return line(coverage.holes, "inside not drawn") +
           line(coverage.open_edge, "on its boundary not drawn") +
           line(coverage.outside, "drawn outside");
}

std::string as_text(const SharedEdge& edge) {
    return fmt::format("edge {} of {} and {}: {} written twice{}; {} never{}\n", shown(edge.name),
                       shown(edge.one), shown(edge.other), counted(edge.twice.count),
                       places_of(edge.twice), edge.never.count, places_of(edge.never));
}

/// "a, b ... and 3 more", by what says how an entry reads.
template <typename List, typename TextOf> std::string some_of(const List& list, TextOf&& text_of) {
    std::string text;
    const std::size_t named = std::min(list.size(), most_pixels_named);
    for (std::size_t i = 0; i < named; ++i)
        text += (i == 0 ? "" : ", ") + text_of(list[i]);
    if (list.size() > named)
        text += fmt::format(" ... and {} more", list.size() - named);
    return text;
}

std::string as_text(const EdgeWithJunctions& edge) {
    const auto vertex = [](const VertexOnEdge& one) {
        return shown(one.name) +
               (one.distance == 0 ? " on it" : fmt::format(" {:.3g} px from it", one.distance));
    };
    return fmt::format(
        "T-junction{} at edge {} of {}: {}; beside it {}: {} in two triangles{}; {} in "
        "none{}\n",
        edge.vertices.size() == 1 ? "" : "s", shown(edge.name), shown(edge.triangle),
        some_of(edge.vertices, vertex), some_of(edge.beside, shown), counted(edge.twice.count),
        places_of(edge.twice), edge.never.count, places_of(edge.never));
}

std::string as_text(const OutlineOnFill& pair) {
    return fmt::format("outline {} on triangle {}: {} outside the fill{}\n", shown(pair.outline),
                       shown(pair.fill), counted(pair.outside.count), places_of(pair.outside));
}

std::string as_text(const Trace& trace, const Stats& stats) {
    std::string text = shortened(printable(trace.title), 79) + "\n";
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "steps       {}\n", stats.steps);
    for (const auto& [kind, count] : stats.count)
        fmt::format_to(out, "  {} {}\n", padded(shortened(printable(kind), 30), 9), count);
    fmt::format_to(out, "pixels      {} of {} on the canvas\n", stats.pixels, stats.canvas);
    fmt::format_to(out, "writes      {}, {} of them over a pixel drawn before\n", stats.writes,
                   stats.writes - stats.pixels);
    fmt::format_to(out, "frame       {}{}\n", stats.frame,
                   stats.frame_differs
                       ? ", not " + printable(trace.end->frame) + " as the end record says"
                       : "");
    for (const PrimitiveStats& primitive : stats.primitives) {
        fmt::format_to(out, "{} {}: {} writes", shortened(printable(primitive.kind), 30),
                       shown(primitive.name), primitive.writes);
        if (primitive.pixels != primitive.writes)
            fmt::format_to(out, " to {}", counted(primitive.pixels));
        if (primitive.over > 0)
            fmt::format_to(out, ", {} over a pixel drawn before", primitive.over);
        if (!primitive.skipped.empty())
            fmt::format_to(out, ", skipped: {}", printable(primitive.skipped));
        text += '\n';
        if (primitive.coverage)
            text += as_text(*primitive.coverage);
    }
    for (const SharedEdge& edge : stats.edges)
        if (edge.twice.count > 0 || edge.never.count > 0)
            text += as_text(edge);
    for (const EdgeWithJunctions& edge : stats.t_junctions)
        text += as_text(edge);
    for (const OutlineOnFill& pair : stats.outlines)
        if (pair.outside.count > 0)
            text += as_text(pair);
    if (stats.depth_ties.count > 0)
        fmt::format_to(out, "depth ties: {} would have another color in another order{}\n",
                       counted(stats.depth_ties.count), places_of(stats.depth_ties));
    if (trace.is_partial)
        text += "steps were left out when this trace was written; the counts are of those it has\n";
    return text;
}

std::string as_json(const PixelList& pixels) {
    std::string text = fmt::format(R"({{"count":{},"pixels":[)", pixels.count);
    std::string_view separator;
    for (const Pixel& pixel : pixels.kept) {
        text += fmt::format("{}[{},{}]", separator, pixel.x, pixel.y);
        separator = ",";
    }
    return text + "]}";
}

/// The edges that triangles share, and the outlines of triangles.
std::string pairs_as_json(const Stats& stats) {
    std::string text = R"("edges":[)";
    std::string_view separator;
    for (const SharedEdge& edge : stats.edges) {
        text += fmt::format(R"({}{{"edge":{},"triangles":[{},{}],"twice":{},"never":{}}})",
                            separator, json_quoted(edge.name), json_quoted(edge.one),
                            json_quoted(edge.other), as_json(edge.twice), as_json(edge.never));
        separator = ",";
    }
    text += R"(],"outlines":[)";
    separator = "";
    for (const OutlineOnFill& pair : stats.outlines) {
        text +=
            fmt::format(R"({}{{"outline":{},"triangle":{},"outside":{}}})", separator,
                        json_quoted(pair.outline), json_quoted(pair.fill), as_json(pair.outside));
        separator = ",";
    }
    return text + "]";
}

/// The edges that vertices of other triangles lie on.
std::string junctions_as_json(const Stats& stats) {
    std::string text = R"("t_junctions":[)";
    std::string_view separator;
    for (const EdgeWithJunctions& edge : stats.t_junctions) {
        text += fmt::format(R"({}{{"edge":{},"triangle":{},"vertices":[)", separator,
                            json_quoted(edge.name), json_quoted(edge.triangle));
        separator = "";
        for (const VertexOnEdge& vertex : edge.vertices) {
            text += fmt::format(R"({}{{"vertex":{},"distance":{}}})", separator,
                                json_quoted(vertex.name), vertex.distance);
            separator = ",";
        }
        text += R"(],"beside":[)";
        separator = "";
        for (const std::string& triangle : edge.beside) {
            text += separator;
            text += json_quoted(triangle);
            separator = ",";
        }
        text +=
            fmt::format(R"(],"twice":{},"never":{}}})", as_json(edge.twice), as_json(edge.never));
        separator = ",";
    }
    return text + "]";
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
        fmt::format_to(out, R"({}{{"kind":{},"name":{},"writes":{},"pixels":{},"over":{})",
                       separator, json_quoted(primitive.kind), json_quoted(primitive.name),
                       primitive.writes, primitive.pixels, primitive.over);
        if (!primitive.skipped.empty())
            fmt::format_to(out, R"(,"skipped":{})", json_quoted(primitive.skipped));
        if (const auto& coverage = primitive.coverage)
            fmt::format_to(out, R"(,"holes":{},"open_edge":{},"outside":{})",
                           as_json(coverage->holes), as_json(coverage->open_edge),
                           as_json(coverage->outside));
        text += '}';
        separator = ",";
    }
    const bool has_depth =
        std::any_of(stats.count.begin(), stats.count.end(),
                    [](const auto& entry) { return entry.first == name_of(StepKind::depth); });
    return text + "]," + pairs_as_json(stats) + "," + junctions_as_json(stats) +
           (has_depth ? R"(,"depth_ties":)" + as_json(stats.depth_ties) : "") + "}\n";
}

} // namespace

int run(const StatsCommand& command) {
    const Trace trace = load_trace(command.trace, command.method, command.input);
    const Stats stats = stats_of(trace);
    print(command.json ? as_json(trace, stats) : as_text(trace, stats));
    return report_damage(trace);
}

} // namespace rastertrace
