// SPDX-License-Identifier: MIT
#include "commands/stats_text.h"

#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

std::string as_json(const PixelList& pixels) {
    std::string text = fmt::format(R"({{"count":{},"pixels":[)", pixels.count);
    std::string_view separator;
    for (const Pixel& pixel : pixels.kept) {
        text += fmt::format("{}[{},{}]", separator, pixel.x, pixel.y);
        separator = ",";
    }
    return text + "]}";
}

std::string as_json(const std::vector<WrongRow>& rows) {
    std::string text = "[";
    for (const WrongRow& row : rows)
        text += fmt::format(
            R"({}{{"step":{},"primitive":{},"y":{},"from":{},"to":{},"missing":{},"others":{}}})",
            text.size() > 1 ? "," : "", row.step, json_quoted(row.primitive), row.y, row.from,
            row.to, row.missing, row.others);
    return text + "]";
}

/// The edges that triangles share.
std::string edges_as_json(const Stats& stats, const Trace& trace) {
    std::string text = R"("edges":[)";
    std::string_view separator;
    for (const SharedEdge& edge : stats.edges) {
        text += fmt::format(R"({}{{"edge":{},"triangles":[{},{}],"twice":{},"never":{}}})",
                            separator, json_quoted(name_of(edge, stats, trace)),
                            json_quoted(stats.primitives[edge.one].name),
                            json_quoted(stats.primitives[edge.other].name), as_json(edge.twice),
                            as_json(edge.never));
        separator = ",";
    }
    return text + "]";
}

} // namespace

std::string stats_json(const Trace& trace, const Stats& stats) {
    std::string text =
        fmt::format(R"({{"title":{},"steps":{},"count":{{)", json_quoted(trace.title), stats.steps);
    std::string_view separator;
    for (const auto& [kind, count] : stats.count) {
        text += fmt::format("{}{}:{}", separator, json_quoted(kind), count);
        separator = ",";
    }
    text += fmt::format(R"(}},"canvas":{},"pixels":{},"writes":{},"frame":"{}","frame_differs":{})",
                        stats.canvas, stats.pixels, stats.writes, stats.frame, stats.frame_differs);
    if (const auto& sample = stats.sample)
        text += fmt::format(R"(,"sample":{{"judged_by":"{}","explains_all":{}}})",
                            sample->is_center ? "center" : "integer", sample->explains_all);
    text += R"(,"primitives":[)";
    separator = "";
    for (const PrimitiveStats& primitive : stats.primitives) {
        text +=
            fmt::format(R"({}{{"kind":{},"name":{},"writes":{},"pixels":{},"over":{},"hidden":{})",
                        separator, json_quoted(primitive.kind), json_quoted(primitive.name),
                        primitive.writes, primitive.pixels, primitive.over, primitive.hidden);
        if (!primitive.skipped.empty())
            text += fmt::format(R"(,"skipped":{})", json_quoted(primitive.skipped));
        if (const auto& coverage = primitive.coverage)
            text += fmt::format(R"(,"holes":{},"outside":{})", as_json(coverage->holes),
                                as_json(coverage->outside));
        text += '}';
        separator = ",";
    }
    const bool has_depth =
        std::any_of(stats.count.begin(), stats.count.end(),
                    [](const auto& entry) { return entry.first == name_of(StepKind::depth); });
    return text + "]," + edges_as_json(stats, trace) + R"(,"wrong_rows":)" +
           as_json(stats.wrong_rows) +
           (has_depth ? R"(,"depth_ties":)" + as_json(stats.depth_ties) : "") + "}\n";
}

} // namespace rastertrace
