// SPDX-License-Identifier: MIT
// `rastertrace stats`: what a trace amounts to.

#include "app/command.h"
#include "app/load.h"
#include "app/option_values.h"
#include "app/progress.h"
#include "app/shared_options.h"
#include "commands/stats_text.h"

#include <rastertrace/trace/audit/redo.h>
#include <rastertrace/trace/audit/stats.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

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
