// SPDX-License-Identifier: MIT
#include "excerpt.h"

#include <rastertrace/trace/record/step_kind.h>

#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

using Json = nlohmann::ordered_json;

/// The known kinds come in the order of step_kind.h, then the others.
Json by_kind(std::map<std::string, std::uint64_t> counts) {
    Json count = Json::object();
    for (const std::string_view kind : step_names)
        if (const auto known = counts.extract(std::string(kind)))
            count[known.key()] = known.mapped();
    for (const auto& [kind, number] : counts)
        count[kind] = number;
    return count;
}

/// A step in one line.
std::string line_of(const StepView& step) {
    std::string json = step.json();
    return json.find('\n') == std::string::npos ? json : Json::parse(json).dump();
}

/// A trace of steps that come one by one.
class Excerpt {
public:
    /// The trace has the steps of these kinds, or all if none is named. Its header is written at once.
    Excerpt(std::string_view header, const std::vector<std::string>& kinds, TraceLayout layout,
            Output& output)
        : kinds_(kinds), output_(output), is_document_(layout == TraceLayout::json) {
        Json head = Json::parse(header);
        head.erase("steps"); // of a document
        if (!kinds.empty())
            head["only"] = kinds;
        std::string text = head.dump();
        if (is_document_)
            text.replace(text.size() - 1, 1, R"(,"steps":[)");
        text_ = json_printable(text);
    }

    void add(const StepView& step) {
        const std::string kind = step.kind_name();
        if (!kinds_.empty() && std::find(kinds_.begin(), kinds_.end(), kind) == kinds_.end())
            return;
        text_ += is_document_ && steps_ > 0 ? ",\n" : "\n";
        text_ += json_printable(line_of(step));
        ++counts_[kind];
        ++steps_;
        if (text_.size() > enough_to_write)
            flush();
    }

    /// Writes the end record: what was written, and the picture of the whole trace.
    void finish(const std::optional<EndRecord>& whole) {
        Json end{{"steps", steps_}, {"count", by_kind(counts_)}};
        if (whole && whole->pixels)
            end["pixels"] = *whole->pixels;
        if (whole && !whole->frame.empty())
            end["frame"] = whole->frame;
        const std::string record = json_printable(R"("end":)" + end.dump());
        text_ += is_document_ ? "\n],\n" + record + "}\n" : "\n{" + record + "}\n";
        flush();
    }

private:
    static constexpr std::size_t enough_to_write = 1 << 16; ///< bytes

    void flush() {
        output_.write(text_);
        text_.clear();
    }

    const std::vector<std::string>& kinds_;
    Output& output_;
    bool is_document_;
    std::string text_; ///< not written yet
    std::uint64_t steps_ = 0;
    std::map<std::string, std::uint64_t> counts_; ///< by kind
};

} // namespace

void write_excerpt(const Trace& trace, const std::vector<std::string>& kinds, TraceLayout layout,
                   Output& output) {
    if (!trace.damage.empty())
        throw trace.damage.front();
    for (const std::string& kind : kinds)
        if (const auto known = step_kind_named(kind); known && trace.lacks(*known))
            throw problem_of("", fmt::format("{} steps were left out of the trace", kind));

    Excerpt excerpt(trace.header_json, kinds, layout, output);
    for (std::size_t n = 1; n <= trace.size(); ++n)
        excerpt.add(trace.step(n));
    excerpt.finish(trace.end);
}

} // namespace rastertrace
