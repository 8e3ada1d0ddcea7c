// SPDX-License-Identifier: MIT
#include <rastertrace/trace/diff.h>

#include "diff_context.h"
#include "diff_fields.h"
#include "json_scanner.h"
#include "trace_comparison.h"
#include "trace_lines.h"

#include <rastertrace/trace/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstring>
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

/// The end record behind the steps; "" if there is none.
std::string end_record_of(const TraceText& text, std::size_t offset) {
    std::string rest = rest_of(text, offset);
    const std::size_t comma = rest.find(',');
    if (text.is_document())
        rest = comma == std::string::npos ? std::string() : "{" + rest.substr(comma + 1);
    return std::string(
        StepView(without_blanks(rest.substr(0, rest.find('\n')))).field("end").value_or(""));
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

/// What two complete traces say at their end of the pictures that were drawn, which steps that were left out may
/// have changed.
std::vector<FieldDifference> differing_ends(const TraceText& a, std::size_t end_of_a,
                                            const TraceText& b, std::size_t end_of_b) {
    std::vector<FieldDifference> differences;
    const std::string json_a = end_record_of(a, end_of_a);
    const std::string json_b = end_record_of(b, end_of_b);
    for (const std::string_view name : {"pixels", "frame"}) {
        const auto in_a = StepView(json_a).field(name);
        const auto in_b = StepView(json_b).field(name);
        if (in_a && in_b && *in_a != *in_b)
            differences.push_back({.name = fmt::format("end.{}", name),
                                   .a = std::string(*in_a),
                                   .b = std::string(*in_b)});
    }
    return differences;
}

/// True if options leave out something that the end record tells of.
bool leave_out_steps(const DiffOptions& options) {
    return !options.only.empty() || !options.tolerances.empty() ||
           std::any_of(options.ignored.begin(), options.ignored.end(),
                       [](const std::string& name) { return name != "header"; });
}

TraceDiff same_bytes(TraceDiff found, const TraceText& a, const TraceText& b) {
    found.is_same = found.is_same_bytes = true;
    if (a.file() && a.file() == b.file())
        found.remarks.emplace_back("both are the same file");
    if (!is_complete(a)) {
        const std::string what =
            "expected the rest of the trace, found the end of the file: the trace is truncated";
        found.damage.push_back(problem_of(a.name(), what));
        found.damage.push_back(problem_of(b.name(), what));
    }
    return found;
}

} // namespace

TraceDiff diff(const TraceText& a, const TraceText& b, const DiffOptions& options) {
    check_names(options, a, b);
    TraceDiff found{.name_a = a.name(), .name_b = b.name()};
    if (have_same_bytes(a, b))
        return same_bytes(std::move(found), a, b);

    TraceComparison comparison(a, b, options);
    comparison.run();
    const DiffTally& tally = comparison.tally();
    found.kinds = tally.kinds();
    found.led_to = tally.led_to();
    found.picture = comparison.picture();
    found.remarks = comparison.remarks();
    found.damage = comparison.damage();
    tell_first(found, comparison, a, b);

    const auto is_ignored = [&options](std::string_view name) {
        return std::find(options.ignored.begin(), options.ignored.end(), name) !=
               options.ignored.end();
    };
    if (!is_ignored("header"))
        found.header = differing_keys(a.header_json(), b.header_json());
    const bool can_end_alike =
        a.header().canvas == b.header().canvas && a.header().background == b.header().background;
    if (tally.is_empty() && !comparison.is_cut_off() && can_end_alike && !leave_out_steps(options))
        found.end =
            differing_ends(a, comparison.end_of_a().offset, b, comparison.end_of_b().offset);
    found.is_same = found.header.empty() && found.end.empty() && tally.is_empty();
    return found;
}

} // namespace rastertrace
