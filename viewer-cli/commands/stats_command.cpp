// SPDX-License-Identifier: MIT
// `rastertrace stats`: what a trace amounts to, as text and as JSON.

#include "app/command.h"
#include "app/json_text.h"
#include "app/load.h"
#include "app/option_values.h"
#include "app/progress.h"
#include "app/shared_options.h"

#include <rastertrace/trace/audit/redo.h>
#include <rastertrace/trace/audit/stats.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
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
std::string shown_name(std::string_view name) {
    return shortened(printable(name), 60);
}

std::string counted(std::uint64_t count, std::string_view what = "pixel") {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
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

/// What a triangle missed and what it drew too much, a line each. What is hidden counts as drawn.
std::string as_text(const Coverage& coverage, bool has_hidden) {
    const auto line = [](const PixelList& pixels, std::string_view what) {
        return pixels.count == 0
                   ? std::string()
                   : fmt::format("  {} {}{}\n", counted(pixels.count), what, places_of(pixels));
    };
    return line(coverage.holes, "inside not drawn") +
           line(coverage.outside, has_hidden ? "drawn or hidden outside" : "drawn outside");
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
    add(sum.outside, more.outside);
}

std::string as_text(const PrimitiveStats& primitive) {
    std::string text = fmt::format("{} {}: {}", shortened(printable(primitive.kind), 30),
                                   shown_name(primitive.name), counted(primitive.writes, "write"));
    if (primitive.pixels != primitive.writes)
        text += fmt::format(" to {}", counted(primitive.pixels));
    if (primitive.hidden > 0)
        text += fmt::format(", {} hidden", primitive.hidden);
    if (primitive.over > 0)
        text += fmt::format(", {} over a pixel drawn before", primitive.over);
    if (!primitive.skipped.empty())
        text += fmt::format(", skipped: {}", printable(primitive.skipped));
    return text + '\n' +
           (primitive.coverage ? as_text(*primitive.coverage, primitive.hidden > 0) : "");
}

/// The faces of a mesh that follow each other.
std::string as_text(std::string_view mesh, std::span<const PrimitiveStats> faces) {
    PrimitiveStats sum;
    Coverage coverage;
    std::map<std::string, std::size_t> skipped;
    for (const PrimitiveStats& face : faces) {
        sum.writes += face.writes;
        sum.hidden += face.hidden;
        sum.over += face.over;
        if (!face.skipped.empty())
            ++skipped[face.skipped];
        if (face.coverage)
            add(coverage, *face.coverage);
    }
    std::string text = fmt::format("mesh {}: {} primitives, {}", shown_name(mesh), faces.size(),
                                   counted(sum.writes, "write"));
    if (sum.hidden > 0)
        text += fmt::format(", {} hidden", sum.hidden);
    if (sum.over > 0)
        text += fmt::format(", {} over a pixel drawn before", sum.over);
    for (const auto& [why, count] : skipped)
        text += fmt::format(", {} skipped: {}", count, printable(why));
    return text + '\n' + as_text(coverage, sum.hidden > 0);
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

std::string as_text(const SharedEdge& edge, const Stats& stats, const Trace& trace) {
    return fmt::format("edge {} of {} and {}: {} written twice{}; {} never{}\n",
                       shown_name(name_of(edge, stats, trace)),
                       shown_name(stats.primitives[edge.one].name),
                       shown_name(stats.primitives[edge.other].name), counted(edge.twice.count),
                       places_of(edge.twice), edge.never.count, places_of(edge.never));
}

/// The shared edges with a finding: those within a mesh in one line, the others in one each.
std::string edges_as_text(const Stats& stats, const Trace& trace) {
    struct Sum {
        std::size_t edges = 0;
        PixelList twice;
        PixelList never;
    };
    std::map<std::string_view, Sum> meshes;
    std::string text;
    for (const SharedEdge& edge : stats.edges) {
        if (edge.twice.count == 0 && edge.never.count == 0)
            continue;
        const std::string_view mesh = mesh_of(stats.primitives[edge.one].name);
        if (mesh.empty() || mesh != mesh_of(stats.primitives[edge.other].name)) {
            text += as_text(edge, stats, trace);
            continue;
        }
        Sum& sum = meshes[mesh];
        ++sum.edges;
        add(sum.twice, edge.twice);
        add(sum.never, edge.never);
    }
    for (const auto& [mesh, sum] : meshes)
        text += fmt::format("{} edge{} within {}: {} written twice{}; {} never{}\n", sum.edges,
                            sum.edges == 1 ? "" : "s", shown_name(mesh), counted(sum.twice.count),
                            places_of(sum.twice), sum.never.count, places_of(sum.never));
    return text;
}

std::string as_text(const WrongRow& row) {
    std::string text = fmt::format("scanline y={} of {} (step {}), {} to {}:", row.y,
                                   shown_name(row.primitive), row.step, row.from, row.to);
    if (row.missing > 0)
        text += fmt::format(" {} neither drawn nor rejected", counted(row.missing));
    if (row.others > 0)
        text += fmt::format("{} {} too many", row.missing > 0 ? "," : "", counted(row.others));
    return text + '\n';
}

std::string as_text(const FoundSample& sample) {
    return fmt::format("sample      {}: the header has no method.sample, and {}\n",
                       sample.is_center ? "center" : "integer",
                       sample.explains_all ? "only this one explains all pixels"
                                           : "neither integer nor center explains all pixels");
}

/// A line each for the first of the rows that are wrong.
std::string as_text(const std::vector<WrongRow>& rows) {
    std::string text;
    const std::size_t named = std::min(rows.size(), most_findings_named);
    for (std::size_t i = 0; i < named; ++i)
        text += as_text(rows[i]);
    if (rows.size() > named)
        text += fmt::format("... and {} more scanlines; --json has all\n", rows.size() - named);
    return text;
}

JsonText json_of(const PixelList& pixels) {
    return {{"count", pixels.count}, {"pixels", pixels.kept}};
}

JsonText json_of(const WrongRow& row) {
    return {
        {"step", row.step}, {"primitive", row.primitive}, {"y", row.y},          {"from", row.from},
        {"to", row.to},     {"missing", row.missing},     {"others", row.others}};
}

JsonText json_of(const PrimitiveStats& primitive) {
    JsonText json{{"kind", primitive.kind},     {"name", primitive.name},
                  {"writes", primitive.writes}, {"pixels", primitive.pixels},
                  {"over", primitive.over},     {"hidden", primitive.hidden}};
    if (!primitive.skipped.empty())
        json.add("skipped", primitive.skipped);
    if (const auto& coverage = primitive.coverage)
        json.add("holes", json_of(coverage->holes)).add("outside", json_of(coverage->outside));
    return json;
}

/// For people: a line for each primitive or mesh, and for each finding, with the first pixels of each.
std::string stats_text(const Trace& trace, const Stats& stats) {
    std::string text = shortened(printable(trace.title), 79) + "\n";
    text += fmt::format("steps       {}\n", stats.steps);
    for (const auto& [kind, count] : stats.count)
        text += fmt::format("  {} {}\n", padded(shortened(printable(kind), 30), 9), count);
    text += fmt::format("pixels      {} of {} on the canvas\n", stats.pixels, stats.canvas);
    text += fmt::format("writes      {}, {} of them over a pixel drawn before\n", stats.writes,
                        stats.writes - stats.pixels);
    text += fmt::format("frame       {}{}\n", stats.frame,
                        stats.frame_differs
                            ? ", not " + printable(trace.end->frame) + " as the end record says"
                            : "");
    if (stats.sample)
        text += as_text(*stats.sample);
    text += as_text(stats.primitives) + edges_as_text(stats, trace) + as_text(stats.wrong_rows);
    if (stats.depth_ties.count > 0)
        text += fmt::format("depth ties: {} would have another color in another order{}\n",
                            counted(stats.depth_ties.count), places_of(stats.depth_ties));
    if (trace.is_partial)
        text += "steps were left out when this trace was written; the counts are of those it has\n";
    return text;
}

/// The same as JSON, with everything one by one.
JsonText stats_json(const Trace& trace, const Stats& stats) {
    JsonText count{};
    for (const auto& [kind, number] : stats.count)
        count.add(kind, number);
    JsonText json{{"title", trace.title},   {"steps", stats.steps},
                  {"count", count},         {"canvas", stats.canvas},
                  {"pixels", stats.pixels}, {"writes", stats.writes},
                  {"frame", stats.frame},   {"frame_differs", stats.frame_differs}};
    if (const auto& sample = stats.sample)
        json.add("sample", {{"judged_by", sample->is_center ? "center" : "integer"},
                            {"explains_all", sample->explains_all}});
    const auto any_json = [](const auto& one) { return json_of(one); };
    const auto edge_json = [&](const SharedEdge& edge) {
        const std::vector<std::string> triangles{stats.primitives[edge.one].name,
                                                 stats.primitives[edge.other].name};
        return JsonText{{"edge", name_of(edge, stats, trace)},
                        {"triangles", triangles},
                        {"twice", json_of(edge.twice)},
                        {"never", json_of(edge.never)}};
    };
    json.add("primitives", JsonText::list(stats.primitives, any_json))
        .add("edges", JsonText::list(stats.edges, edge_json))
        .add("wrong_rows", JsonText::list(stats.wrong_rows, any_json));
    const bool has_depth = std::ranges::any_of(
        stats.count, [](const auto& entry) { return entry.first == name_of(StepKind::depth); });
    return has_depth ? json.add("depth_ties", json_of(stats.depth_ties)) : json;
}

// The command.

/// True if there is anything of the kind.
bool has(const Stats& stats, StatsFinding finding) {
    const auto any_primitive = [&stats](PixelList Coverage::*list) {
        return std::any_of(
            stats.primitives.begin(), stats.primitives.end(),
            [list](const auto& one) { return one.coverage && ((*one.coverage).*list).count > 0; });
    };
    const auto any_edge = [&stats](PixelList SharedEdge::*list) {
        return std::any_of(stats.edges.begin(), stats.edges.end(),
                           [list](const auto& one) { return (one.*list).count > 0; });
    };
    switch (finding) {
    case StatsFinding::holes:
        return any_primitive(&Coverage::holes) || any_edge(&SharedEdge::never);
    case StatsFinding::twice:
        return any_edge(&SharedEdge::twice);
    case StatsFinding::outside:
        return any_primitive(&Coverage::outside);
    case StatsFinding::rows:
        return !stats.wrong_rows.empty();
    case StatsFinding::redo:
        break;
    }
    return false;
}

/// True if a decision of the trace is not the one that its numbers give; the first one is told.
bool has_wrong_decision(const Trace& trace, const std::string& path) {
    const Redone redone = redo(trace);
    if (redone.values() == 0)
        throw problem_of(path, "--fail-on redo: " + nothing_redone());
    if (redone.wrong > 0)
        print_error(problem_of(redone, trace));
    return redone.wrong > 0;
}

class StatsCommand final : public Command {
public:
    CommandAbout about() const override {
        return {"stats", "Count the steps, pixels and writes of a trace",
                "rastertrace stats examples/t0-fill/first-triangle.json"};
    }

    void add_to(OptionList& options) override {
        options.option("trace", trace_, trace_input, "TRACE").required();
        options.flag("--json", json_, "Print JSON");
        options.option("--fail-on", fail_on_names_,
                       fmt::format("End with status 1 if there are any of these, with 2 if that "
                                   "cannot be judged: {}",
                                   joined(finding_names, ",")),
                       "NAME,...");
        drawing_.add_to(options, Holds::steps);
    }

    void read() override {
        fail_on_ = values_of<StatsFinding>(
            "--fail-on", "findings", fail_on_names_, {finding_names.begin(), finding_names.end()},
            [](std::string_view name) { return value_named<StatsFinding>(finding_names, name); });
        scenes_ = drawing_.scene_options();
    }

    int run() override {
        const Trace trace = [&] {
            const Progress progress(reading_of("stats", {trace_}));
            return load_trace(trace_, scenes_);
        }();
        if (trace.is_partial && !fail_on_.empty())
            throw problem_of(trace_, "--fail-on: expected a trace with all its steps, found one "
                                     "that steps were left out of");
        const Stats stats = stats_of(trace);
        print(json_ ? stats_json(trace, stats).line() : stats_text(trace, stats));

        std::vector<StatsFinding> found;
        for (const StatsFinding finding : fail_on_)
            if (finding == StatsFinding::redo ? has_wrong_decision(trace, trace_)
                                              : has(stats, finding))
                found.push_back(finding);
        if (!found.empty())
            print_error(fmt::format("rastertrace: --fail-on: found {}\n", names_of(found)));
        const ExitStatus unjudged = report_unjudged(stats);
        const ExitStatus damage = report_damage(trace);
        if (damage != exit_fine || unjudged != exit_fine)
            return exit_bad_input;
        return found.empty() ? exit_fine : exit_difference;
    }

private:
    /// Tells which of the findings that were asked for cannot be judged, and what the trace lacks.
    ExitStatus report_unjudged(const Stats& stats) const {
        ExitStatus status = exit_fine;
        for (const auto& [findings, lacks] : stats.unjudged) {
            std::vector<StatsFinding> asked;
            std::ranges::copy_if(findings, std::back_inserter(asked), [&](StatsFinding finding) {
                return std::ranges::find(fail_on_, finding) != fail_on_.end();
            });
            if (asked.empty())
                continue;
            print_error(problem_of(
                trace_, fmt::format("--fail-on: {} cannot be judged: {}", names_of(asked), lacks)));
            status = exit_bad_input;
        }
        return status;
    }

    std::string trace_;
    bool json_ = false;
    std::string fail_on_names_;
    std::vector<StatsFinding> fail_on_; ///< exit status 1 if there is any of these
    DrawingOptions drawing_;
    SceneOptions scenes_;
};

} // namespace

std::unique_ptr<Command> stats_command() {
    return std::make_unique<StatsCommand>();
}

} // namespace rastertrace
