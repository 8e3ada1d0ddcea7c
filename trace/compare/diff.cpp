// SPDX-License-Identifier: MIT
#include "diff.h"

#include "compared_steps.h"
#include "diff_context.h"
#include "diff_header.h"
#include "diff_options.h"
#include "trace_comparison.h"

#include <rastertrace/trace/record/trace_lines.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

namespace rastertrace {

namespace {

bool are_one_file(const Trace& a, const Trace& b) {
    return a.source().file && a.source().file == b.source().file;
}

bool have_same_bytes(const Trace& a, const Trace& b) {
    return are_one_file(a, b) || (a.header_json == b.header_json &&
                                  a.source().view() == b.source().view() && a.size() == b.size());
}

/// What is wrong behind the steps of a trace that is whole: that there is no end record, or that it counts other steps.
std::optional<Problem> fault_of_end(const Trace& trace) {
    if (!trace.end)
        return trace.damage.back();
    if (trace.end->steps.value_or(trace.size()) == trace.size())
        return std::nullopt;
    return problem_of(trace.source().name, disagreement(fmt::format("{}", *trace.end->steps),
                                                        "steps", fmt::format("{}", trace.size())));
}

/// What two end records say of the pictures that were drawn, where no step that is told may say so.
std::vector<FieldDifference> differing_ends(const EndRecord& a, const EndRecord& b) {
    std::vector<FieldDifference> differences;
    if (a.pixels && b.pixels && a.pixels != b.pixels)
        differences.push_back({.name = "end.pixels",
                               .a = fmt::format("{}", *a.pixels),
                               .b = fmt::format("{}", *b.pixels)});
    if (!a.frame.empty() && !b.frame.empty() && a.frame != b.frame)
        differences.push_back(
            {.name = "end.frame", .a = json_quoted(a.frame), .b = json_quoted(b.frame)});
    return differences;
}

/// True if options leave out something that the end record tells of.
bool leave_out_steps(const DiffOptions& options) {
    return !options.only.empty() || !options.tolerances.empty() ||
           std::any_of(options.ignored.begin(), options.ignored.end(),
                       [](const std::string& name) { return name != "header"; });
}

/// True if a trace has a step that is compared.
bool has_compared_step(const Trace& trace, const ComparedSteps& compared) {
    StepsAhead steps(trace, 1, trace.size(), {});
    bool is_compared = compared.has_primitive("");
    for (; const KeyedStep* const step = steps.front(); steps.pass()) {
        if (step->kind == StepKind::primitive)
            is_compared = compared.has_primitive(name_in(step->view()).text());
        if (is_compared && compared.has(*step))
            return true;
    }
    return false;
}

/// Throws a Problem if two traces are alike only because options, or the traces themselves, leave all steps out.
void expect_compared_steps(const Trace& a, const Trace& b, const DiffOptions& options) {
    if (!leave_out_steps(options) && !options.compares_common && !a.is_partial && !b.is_partial)
        return;
    const ComparedSteps compared(a, b, options);
    if (!has_compared_step(a, compared) && !has_compared_step(b, compared))
        throw problem_of("", fmt::format("nothing was compared: expected steps that are not left "
                                         "out, found none in {} and {}",
                                         printable(a.source().name), printable(b.source().name)));
}

TraceDiff same_bytes(TraceDiff found, const Trace& a, const Trace& b) {
    found.is_same = found.is_same_bytes = true;
    if (are_one_file(a, b))
        found.remarks.push_back(said("both are the same file"));
    if (a.cut_short) {
        const std::string what =
            "expected the rest of the trace, found the end of the file: the trace is truncated";
        found.damage.push_back(problem_of(a.source().name, what));
        if (!are_one_file(a, b))
            found.damage.push_back(problem_of(b.source().name, what));
    }
    return found;
}

} // namespace

TraceDiff diff(const Trace& a, const Trace& b, const DiffOptions& options) {
    check_names(options, a, b);
    TraceDiff found{.name_a = a.source().name, .name_b = b.source().name};
    if (have_same_bytes(a, b)) {
        expect_compared_steps(a, b, options);
        return same_bytes(std::move(found), a, b);
    }

    TraceComparison comparison(a, b, options);
    comparison.run();
    const DiffTally& tally = comparison.tally();
    found.kinds = tally.kinds();
    found.remarks = comparison.remarks();
    found.damage = comparison.damage();
    tell_first(found, comparison, a, b);
    if (auto picture = comparison.picture())
        std::tie(found.picture, found.led_to) = *std::move(picture);
    if (!options.ignores("header"))
        found.header = differing_keys(a.header_json, b.header_json);
    if (options.compares_common)
        std::erase_if(found.header,
                      [](const FieldDifference& key) { return key.a.empty() || key.b.empty(); });

    if (!comparison.is_cut_off()) {
        for (const Trace* const trace : {&a, &b})
            if (auto fault = fault_of_end(*trace))
                found.damage.push_back(*std::move(fault));
        if (a.end && b.end && tally.is_empty() && a.canvas == b.canvas && !leave_out_steps(options))
            found.end = differing_ends(*a.end, *b.end);
    }
    found.is_same = found.header.empty() && found.end.empty() && tally.is_empty();
    if (found.is_same && found.damage.empty())
        expect_compared_steps(a, b, options);
    return found;
}

} // namespace rastertrace
