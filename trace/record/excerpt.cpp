// SPDX-License-Identifier: MIT
#include "excerpt.h"

#include "step_kind.h"

#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

using Json = nlohmann::ordered_json;

/// How many steps of each kind there are. The known ones come in the order of step_kind.h, then the others.
class StepCount {
public:
    void add(const std::string& name) {
        ++steps_;
        if (const auto kind = step_kind_named(name))
            ++known_[static_cast<std::size_t>(*kind)];
        else
            ++others_[name];
    }

    std::uint64_t steps() const { return steps_; }

    Json by_kind() const {
        Json count = Json::object();
        for (const auto& [kind, number] : known_)
            count[std::string(name_of(static_cast<StepKind>(kind)))] = number;
        for (const auto& [kind, number] : others_)
            count[kind] = number;
        return count;
    }

private:
    std::uint64_t steps_ = 0;
    std::map<std::size_t, std::uint64_t> known_;
    std::map<std::string, std::uint64_t> others_;
};

/// The end record: what was written, and the picture of the whole trace.
std::string end_record(const Trace& trace, const StepCount& count) {
    Json end{{"steps", count.steps()}, {"count", count.by_kind()}};
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

    StepCount count;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const StepView step = trace.step(n);
        const std::string kind = step.kind_name();
        if (!kinds.empty() && std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
            continue;
        output.write((is_document && count.steps() > 0 ? ",\n" : "\n") +
                     without_unsafe(line_of(step)));
        count.add(kind);
    }
    const std::string end = without_unsafe(end_record(trace, count));
    output.write(is_document ? "\n],\n" + end + "}\n" : "\n{" + end + "}\n");
}

} // namespace rastertrace
