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

struct StatsCommand {
    std::string trace;
    bool json = false;
    std::vector<StatsFinding> fail_on; ///< exit status 1 if there is any of these
    MethodOverrides method;
    InputLimits input;
    FrameChoice frames;
};

/// Tells which of the findings that were asked for cannot be judged, and what the trace lacks.
ExitStatus report_unjudged(const StatsCommand& command, const Stats& stats) {
    ExitStatus status = exit_fine;
    for (const auto& [findings, lacks] : stats.unjudged) {
        std::vector<StatsFinding> asked;
        std::copy_if(findings.begin(), findings.end(), std::back_inserter(asked),
                     [&command](StatsFinding finding) {
                         return std::find(command.fail_on.begin(), command.fail_on.end(),
                                          finding) != command.fail_on.end();
                     });
        if (asked.empty())
            continue;
        print_error(problem_of(command.trace, fmt::format("--fail-on: {} cannot be judged: {}",
                                                          names_of(asked), lacks)));
        status = exit_bad_input;
    }
    return status;
}

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

} // namespace

int run(const StatsCommand& command) {
    const Trace trace = [&] {
        const Progress progress(reading_of("stats", {command.trace}));
        return load_trace(
            command.trace,
            {.method = command.method, .limits = command.input, .frames = command.frames});
    }();
    if (trace.is_partial && !command.fail_on.empty())
        throw problem_of(command.trace, "--fail-on: expected a trace with all its steps, found one "
                                        "that steps were left out of");
    const Stats stats = stats_of(trace);
    print(command.json ? stats_json(trace, stats).line() : stats_text(trace, stats));

    std::vector<StatsFinding> found;
    for (const StatsFinding finding : command.fail_on)
        if (finding == StatsFinding::redo ? has_wrong_decision(trace, command.trace)
                                          : has(stats, finding))
            found.push_back(finding);
    if (!found.empty())
        print_error(fmt::format("rastertrace: --fail-on: found {}\n", names_of(found)));
    const ExitStatus unjudged = report_unjudged(command, stats);
    const ExitStatus damage = report_damage(trace);
    if (damage != exit_fine || unjudged != exit_fine)
        return exit_bad_input;
    return found.empty() ? exit_fine : exit_difference;
}

namespace {

class StatsCommandLine final : public Command {
public:
    CommandAbout about() const override {
        return {"stats", "Count the steps, pixels and writes of a trace",
                "rastertrace stats examples/t0-fill/first-triangle.json"};
    }

    void add_to(OptionList& options) override {
        options.option("trace", command_.trace, trace_input, "TRACE").required();
        options.flag("--json", command_.json, "Print JSON");
        options.option("--fail-on", fail_on_,
                       fmt::format("End with status 1 if there are any of these, with 2 if that "
                                   "cannot be judged: {}",
                                   joined(finding_names, ",")),
                       "NAME,...");
        drawing_.add_to(options, Holds::steps);
    }

    void read() override {
        command_.fail_on = values_of<StatsFinding>(
            "--fail-on", "findings", fail_on_, {finding_names.begin(), finding_names.end()},
            [](std::string_view name) { return value_named<StatsFinding>(finding_names, name); });
        drawing_.read_into(command_);
    }

    int run() override { return rastertrace::run(command_); }

private:
    StatsCommand command_;
    std::string fail_on_;
    DrawingOptions drawing_;
};

} // namespace

std::unique_ptr<Command> stats_command() {
    return std::make_unique<StatsCommandLine>();
}

} // namespace rastertrace
