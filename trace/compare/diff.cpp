// SPDX-License-Identifier: MIT
#include "diff.h"

#include "compared_steps.h"
#include "diff_context.h"
#include "diff_header.h"
#include "diff_options.h"
#include "trace_comparison.h"

#include <rastertrace/trace/record/step_lines.h>
#include <rastertrace/trace/record/trace_lines.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <tuple>
#include <utility>

namespace rastertrace {

namespace {

/// As much as stays in a cache close to the processor.
constexpr std::size_t block_size = 1 << 17;

bool have_same_bytes(const TraceText& a, const TraceText& b) {
    if (a.file() && a.file() == b.file())
        return true;
    std::string in_a(block_size, '\0');
    std::string in_b(block_size, '\0');
    for (std::size_t offset = 0;;) {
        const std::size_t count = a.read(offset, in_a);
        const std::size_t other =
            b.read(offset, std::span(in_b).first(std::max<std::size_t>(count, 1)));
        if (count != other || std::memcmp(in_a.data(), in_b.data(), count) != 0)
            return false;
        if (count == 0)
            return true;
        offset += count;
    }
}

/// What stands at a place of a text, up to its end.
std::string rest_of(const TraceText& text, std::size_t offset) {
    std::string rest;
    for (;;) {
        const std::size_t size = rest.size();
        rest.resize(size + block_size);
        const std::size_t count = text.read(offset + size, std::span(rest).subspan(size));
        rest.resize(size + count);
        if (count == 0)
            return rest;
    }
}

/// What stands behind the steps of a complete trace, read as read_trace does; `place` is behind its last step. That
/// counts of steps do not agree is damage. Throws a Problem.
Trace end_of(const TraceText& text, LinePlace place, std::vector<Problem>& damage) {
    std::string header = text.header_json();
    if (text.is_document())
        header.resize(header.size() - 2); // as it stands in front of steps
    auto read = read_trace({text.name(), header + "\n" + rest_of(text, place.offset), {}});
    const auto moved = [&](Problem problem) {
        problem.line = text.has_lines() ? problem.line + place.lines : 0;
        return problem;
    };
    if (!read)
        throw moved(read.problem());
    const auto& end = read.value().end;
    if (!end)
        damage.push_back(moved(read.value().damage.front()));
    else if (end->steps && *end->steps != place.steps)
        damage.push_back(
            problem_of(text.name(), disagreement(fmt::format("{}", *end->steps), "steps",
                                                 fmt::format("{}", place.steps))));
    return std::move(read.value());
}

/// True if a text has the line behind its last step; looked for among its last lines.
bool is_complete(const TraceText& text) {
    const StepLines lines(text);
    const std::size_t size = text.size();
    const std::size_t from = std::max(text.begin(), size - std::min(size, block_size));
    for (const std::string& line : split_at(rest_of(text, from), '\n'))
        if (lines.ends_steps(line))
            return true;
    return false;
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

/// True if a text has a step that is compared.
bool has_compared_step(const TraceText& text, const ComparedSteps& compared) {
    StepLines lines(text);
    bool is_compared = compared.has_primitive("");
    for (; const StepLine* const step = lines.front(); lines.pass()) {
        if (step->kind == StepKind::primitive)
            is_compared =
                compared.has_primitive(StepView(step->json).as<PrimitiveStep>().name.text());
        if (is_compared && compared.has(*step))
            return true;
    }
    return false;
}

/// Throws a Problem if two traces are alike only because options, or the traces themselves, leave all steps out.
void expect_compared_steps(const TraceText& a, const TraceText& b, const DiffOptions& options) {
    const auto leaves_out = [](const TraceText& text) { return text.header().is_partial; };
    if (!leave_out_steps(options) && !options.compares_common && !leaves_out(a) && !leaves_out(b))
        return;
    const ComparedSteps compared(a, b, options);
    if (!has_compared_step(a, compared) && !has_compared_step(b, compared))
        throw problem_of("", fmt::format("nothing was compared: expected steps that are not left "
                                         "out, found none in {} and {}",
                                         printable(a.name()), printable(b.name())));
}

TraceDiff same_bytes(TraceDiff found, const TraceText& a, const TraceText& b) {
    found.is_same = found.is_same_bytes = true;
    if (a.file() && a.file() == b.file())
        found.remarks.push_back(said({"both are the same file", "ambos são o mesmo arquivo"}));
    if (!is_complete(a)) {
        const std::string what =
            "expected the rest of the trace, found the end of the file: the trace is truncated";
        found.damage.push_back(problem_of(a.name(), what));
        if (!a.file() || a.file() != b.file())
            found.damage.push_back(problem_of(b.name(), what));
    }
    return found;
}

} // namespace

TraceDiff diff(const TraceText& a, const TraceText& b, const DiffOptions& options) {
    check_names(options, a, b);
    TraceDiff found{.name_a = a.name(), .name_b = b.name()};
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
        found.header = differing_keys(a.header_json(), b.header_json());
    if (options.compares_common)
        std::erase_if(found.header,
                      [](const FieldDifference& key) { return key.a.empty() || key.b.empty(); });

    if (!comparison.is_cut_off()) {
        const Trace end_a = end_of(a, comparison.end_of_a(), found.damage);
        const Trace end_b = end_of(b, comparison.end_of_b(), found.damage);
        const bool is_one_canvas = a.header().canvas == b.header().canvas;
        if (end_a.end && end_b.end && tally.is_empty() && is_one_canvas &&
            !leave_out_steps(options))
            found.end = differing_ends(*end_a.end, *end_b.end);
    }
    found.is_same = found.header.empty() && found.end.empty() && tally.is_empty();
    if (found.is_same && found.damage.empty())
        expect_compared_steps(a, b, options);
    return found;
}

} // namespace rastertrace
