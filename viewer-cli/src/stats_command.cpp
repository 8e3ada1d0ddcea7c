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
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

/// How many pixels of each finding the text names.
constexpr std::size_t most_pixels_named = 12;

/// And how many of the findings that need a line each.
constexpr std::size_t most_findings_named = 12;

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

/// Why pixels were drawn outside, a line for each cause.
std::string as_text(const std::vector<PixelCause>& causes) {
    std::string text;
    for (const auto& [cause, pixels] : causes)
        text += fmt::format("    {}: {}\n", printable(cause), pixels);
    return text;
}

/// What a triangle missed and what it drew too much, a line each, and why.
std::string as_text(const Coverage& coverage) {
    const auto line = [](const PixelList& pixels, std::string_view what) {
        return pixels.count == 0
                   ? std::string()
                   : fmt::format("  {} {}{}\n", counted(pixels.count), what, places_of(pixels));
    };
    return line(coverage.holes, "inside not drawn") +
           line(coverage.open_edge, "on its boundary not drawn") +
           line(coverage.outside, "drawn outside") + as_text(coverage.causes);
}

// Primitives and edges. The parts of a mesh, which may be thousands, are added up.

/// The mesh that a face, NAME.FACE, belongs to; "" if it belongs to none.
std::string_view mesh_of(std::string_view primitive) {
    const std::size_t dot = primitive.find('.');
    return dot == std::string_view::npos ? std::string_view() : primitive.substr(0, dot);
}

void add(PixelList& sum, const PixelList& more) {
    sum.count += more.count;
    const std::size_t room = most_pixels_kept - std::min(most_pixels_kept, sum.kept.size());
    const auto end =
        more.kept.begin() + static_cast<std::ptrdiff_t>(std::min(room, more.kept.size()));
    sum.kept.insert(sum.kept.end(), more.kept.begin(), end);
}

void add(Coverage& sum, const Coverage& more) {
    add(sum.holes, more.holes);
    add(sum.open_edge, more.open_edge);
    add(sum.outside, more.outside);
    for (const PixelCause& cause : more.causes) {
        const auto known =
            std::find_if(sum.causes.begin(), sum.causes.end(),
                         [&cause](const PixelCause& other) { return other.cause == cause.cause; });
        if (known == sum.causes.end())
            sum.causes.push_back(cause);
        else
            known->pixels += cause.pixels;
    }
}

std::string as_text(const PrimitiveStats& primitive) {
    std::string text = fmt::format("{} {}: {} writes", shortened(printable(primitive.kind), 30),
                                   shown(primitive.name), primitive.writes);
    if (primitive.pixels != primitive.writes)
        text += fmt::format(" to {}", counted(primitive.pixels));
    if (primitive.over > 0)
        text += fmt::format(", {} over a pixel drawn before", primitive.over);
    if (!primitive.skipped.empty())
        text += fmt::format(", skipped: {}", printable(primitive.skipped));
    return text + '\n' + (primitive.coverage ? as_text(*primitive.coverage) : "");
}

/// The faces of a mesh that follow each other.
std::string as_text(std::string_view mesh, std::span<const PrimitiveStats> faces) {
    PrimitiveStats sum;
    Coverage coverage;
    std::map<std::string, std::size_t> skipped;
    for (const PrimitiveStats& face : faces) {
        sum.writes += face.writes;
        sum.over += face.over;
        if (!face.skipped.empty())
            ++skipped[face.skipped];
        if (face.coverage)
            add(coverage, *face.coverage);
    }
    std::string text =
        fmt::format("mesh {}: {} primitives, {} writes", shown(mesh), faces.size(), sum.writes);
    if (sum.over > 0)
        text += fmt::format(", {} over a pixel drawn before", sum.over);
    for (const auto& [why, count] : skipped)
        text += fmt::format(", {} skipped: {}", count, printable(why));
    return text + '\n' + as_text(coverage);
}

std::string as_text(const std::vector<PrimitiveStats>& primitives) {
    std::string text;
    for (auto first = primitives.begin(); first != primitives.end();) {
        const std::string_view mesh = mesh_of(first->name);
        const auto end = mesh.empty()
                             ? first + 1
                             : std::find_if(first, primitives.end(), [&](const auto& other) {
                                   return mesh_of(other.name) != mesh;
                               });
        text += end - first == 1 ? as_text(*first) : as_text(mesh, {first, end});
        first = end;
    }
    return text;
}

std::string as_text(const SharedEdge& edge) {
    return fmt::format("edge {} of {} and {}: {} written twice{}; {} never{}\n", shown(edge.name),
                       shown(edge.one), shown(edge.other), counted(edge.twice.count),
                       places_of(edge.twice), edge.never.count, places_of(edge.never));
}

/// The shared edges with a finding: those within a mesh in one line, the others in one each.
std::string as_text(const std::vector<SharedEdge>& edges) {
    struct Sum {
        std::size_t edges = 0;
        PixelList twice;
        PixelList never;
    };
    std::map<std::string_view, Sum> meshes;
    std::string text;
    for (const SharedEdge& edge : edges) {
        if (edge.twice.count == 0 && edge.never.count == 0)
            continue;
        const std::string_view mesh = mesh_of(edge.one);
        if (mesh.empty() || mesh != mesh_of(edge.other)) {
            text += as_text(edge);
            continue;
        }
        Sum& sum = meshes[mesh];
        ++sum.edges;
        add(sum.twice, edge.twice);
        add(sum.never, edge.never);
    }
    for (const auto& [mesh, sum] : meshes)
        text += fmt::format("{} edge{} within {}: {} written twice{}; {} never{}\n", sum.edges,
                            sum.edges == 1 ? "" : "s", shown(mesh), counted(sum.twice.count),
                            places_of(sum.twice), sum.never.count, places_of(sum.never));
    return text;
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

std::string as_text(const WrongRow& row) {
    std::string text = fmt::format("scanline y={} of {} (step {}), {} to {}:", row.y,
                                   shown(row.primitive), row.step, row.from, row.to);
    if (row.missing > 0)
        text += fmt::format(" {} neither drawn nor rejected", counted(row.missing));
    if (row.others > 0)
        text += fmt::format("{} {} too many", row.missing > 0 ? "," : "", counted(row.others));
    return text + '\n';
}

/// A line each for the first of some findings.
template <typename List> std::string first_of(const List& list, std::string_view what) {
    std::string text;
    const std::size_t named = std::min(list.size(), most_findings_named);
    for (std::size_t i = 0; i < named; ++i)
        text += as_text(list[i]);
    if (list.size() > named)
        text += fmt::format("... and {} more {}; --json has all\n", list.size() - named, what);
    return text;
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
    text += as_text(stats.primitives) + as_text(stats.edges) +
            first_of(stats.t_junctions, "T-junctions");
    std::vector<OutlineOnFill> beside;
    std::copy_if(stats.outlines.begin(), stats.outlines.end(), std::back_inserter(beside),
                 [](const OutlineOnFill& pair) { return pair.outside.count > 0; });
    text += first_of(beside, "outlines") + first_of(stats.wrong_rows, "scanlines");
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

std::string as_json(const std::vector<PixelCause>& causes) {
    std::string text = "[";
    for (const auto& [cause, pixels] : causes)
        text += fmt::format(R"({}{{"cause":{},"pixels":{}}})", text.size() > 1 ? "," : "",
                            json_quoted(cause), pixels);
    return text + "]";
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
            fmt::format_to(out, R"(,"holes":{},"open_edge":{},"outside":{},"causes":{})",
                           as_json(coverage->holes), as_json(coverage->open_edge),
                           as_json(coverage->outside), as_json(coverage->causes));
        text += '}';
        separator = ",";
    }
    const bool has_depth =
        std::any_of(stats.count.begin(), stats.count.end(),
                    [](const auto& entry) { return entry.first == name_of(StepKind::depth); });
    return text + "]," + pairs_as_json(stats) + "," + junctions_as_json(stats) +
           R"(,"wrong_rows":)" + as_json(stats.wrong_rows) +
           (has_depth ? R"(,"depth_ties":)" + as_json(stats.depth_ties) : "") + "}\n";
}

/// True if there is anything of the kind.
bool has(const Stats& stats, StatsFinding finding) {
    const auto any_primitive = [&stats](PixelList Coverage::*list) {
        return std::any_of(
            stats.primitives.begin(), stats.primitives.end(),
            [list](const auto& one) { return one.coverage && ((*one.coverage).*list).count > 0; });
    };
    const auto any_edge = [&stats](PixelList SharedEdge::*edge,
                                   PixelList EdgeWithJunctions::*other) {
        return std::any_of(stats.edges.begin(), stats.edges.end(),
                           [edge](const auto& one) { return (one.*edge).count > 0; }) ||
               std::any_of(stats.t_junctions.begin(), stats.t_junctions.end(),
                           [other](const auto& one) { return (one.*other).count > 0; });
    };
    switch (finding) {
    case StatsFinding::holes:
        return any_primitive(&Coverage::holes) ||
               any_edge(&SharedEdge::never, &EdgeWithJunctions::never);
    case StatsFinding::twice:
        return any_edge(&SharedEdge::twice, &EdgeWithJunctions::twice);
    case StatsFinding::outside:
        return any_primitive(&Coverage::outside);
    case StatsFinding::rows:
        break;
    }
    return !stats.wrong_rows.empty();
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
        break;
    }
    return "rows";
}

int run(const StatsCommand& command) {
    const Trace trace = load_trace(command.trace, command.method, command.input);
    if (trace.is_partial && !command.fail_on.empty())
        throw problem_of(command.trace, "--fail-on: expected a trace with all its steps, found one "
                                        "that steps were left out of");
    const Stats stats = stats_of(trace);
    print(command.json ? as_json(trace, stats) : as_text(trace, stats));

    std::vector<std::string_view> found;
    for (const StatsFinding finding : command.fail_on)
        if (has(stats, finding))
            found.push_back(name_of(finding));
    if (!found.empty())
        print_error(fmt::format("rastertrace: --fail-on: found {}\n", fmt::join(found, ", ")));
    const ExitStatus damage = report_damage(trace);
    return damage == exit_fine && !found.empty() ? exit_difference : damage;
}

} // namespace rastertrace
