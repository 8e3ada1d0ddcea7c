// SPDX-License-Identifier: MIT
#include "excerpt.h"

#include "step_counts.h"
#include "step_kind.h"

#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

using Json = nlohmann::ordered_json;

/// The known kinds come in the order of step_kind.h, then the others.
Json by_kind(const StepCounts& counts) {
    Json count = Json::object();
    for (std::size_t i = 0; i < step_kinds; ++i)
        if (counts.known[i] > 0)
            count[std::string(step_names[i])] = counts.known[i];
    for (const auto& [kind, number] : counts.others)
        count[kind] = number;
    return count;
}

/// The end record: what was written, and the picture of the whole trace.
std::string end_record(const Trace& trace, std::uint64_t steps, const StepCounts& counts) {
    Json end{{"steps", steps}, {"count", by_kind(counts)}};
    if (trace.end && trace.end->pixels)
        end["pixels"] = *trace.end->pixels;
    if (trace.end && !trace.end->frame.empty())
        end["frame"] = trace.end->frame;
    return R"("end":)" + end.dump();
}

/// JSON with escapes for the characters that a terminal would obey. But for blanks and the ends of lines, they can only
/// stand in strings.
std::string without_unsafe(std::string_view json) {
    const auto is_plain = [](char byte) { return static_cast<unsigned char>(byte) < 0x7F; };
    std::string text;
    while (!json.empty()) {
        const auto plain = static_cast<std::size_t>(
            std::find_if_not(json.begin(), json.end(), is_plain) - json.begin());
        text += json.substr(0, plain);
        json.remove_prefix(plain);
        if (json.empty())
            break;
        const CodePoint character = first_code_point(json);
        if (character.value != not_a_character && is_unsafe(character.value))
            text += fmt::format("\\u{:04x}", static_cast<unsigned>(character.value));
        else
            text += json.substr(0, character.length);
        json.remove_prefix(character.length);
    }
    return text;
}

/// A step in one line.
std::string line_of(const StepView& step) {
    const std::string_view json = step.json();
    return json.find('\n') == std::string_view::npos ? std::string(json) : Json::parse(json).dump();
}

} // namespace

void write_excerpt(const Trace& trace, std::string_view header,
                   const std::vector<std::string>& kinds, TraceLayout layout, Output& output) {
    if (!trace.damage.empty())
        throw trace.damage.front();
    for (const std::string& kind : kinds)
        if (const auto known = step_kind_named(kind); known && trace.lacks(*known))
            throw problem_of("", fmt::format("{} steps were left out of the trace", kind));

    const bool is_document = layout == TraceLayout::json;
    Json head = Json::parse(header);
    head.erase("steps"); // of a document
    head.erase("end");
    if (!kinds.empty())
        head["only"] = kinds;
    std::string text = head.dump();
    if (is_document)
        text.replace(text.size() - 1, 1, R"(,"steps":[)");
    output.write(without_unsafe(text));

    std::uint64_t steps = 0;
    StepCounts counts;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const StepView step = trace.step(n);
        const std::string kind = step.kind_name();
        if (!kinds.empty() && std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
            continue;
        output.write((is_document && steps > 0 ? ",\n" : "\n") + without_unsafe(line_of(step)));
        counts.add(step, step_kind_named(kind));
        ++steps;
    }
    const std::string end = without_unsafe(end_record(trace, steps, counts));
    output.write(is_document ? "\n],\n" + end + "}\n" : "\n{" + end + "}\n");
}

} // namespace rastertrace
