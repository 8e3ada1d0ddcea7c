// SPDX-License-Identifier: MIT
#include "trace.h"
#include "write_trace.h"

#include <rastertrace/trace/text/input.h>

#include <fmt/core.h>

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

/// Takes a number from the front of a text; false if there is none.
bool take_number(std::string_view& text, int& number) {
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return fault == std::errc();
}

/// Takes these characters from the front of a text; false if others stand there.
bool take(std::string_view& text, std::string_view front) {
    const bool is_there = text.starts_with(front);
    text.remove_prefix(is_there ? front.size() : 0);
    return is_there;
}

/// The pixel of a line that our writer has written of a `pixel` step without a color.
std::optional<Pixel> pixel_in(std::string_view line) {
    Pixel pixel;
    if (take(line, R"({"step":"pixel","x":)") && take_number(line, pixel.x) &&
        take(line, R"(,"y":)") && take_number(line, pixel.y) && line == "}")
        return pixel;
    return std::nullopt;
}

/// The kind of a step that our writer has written.
std::optional<StepKind> kind_in(std::string_view line) {
    constexpr std::string_view front = R"({"step":")";
    line.remove_prefix(front.size());
    return step_kind_named(line.substr(0, line.find('"')));
}

} // namespace

/// Takes the lines of a trace as they are written, and keeps what is held of them.
class DrawnSteps final : public Output {
public:
    DrawnSteps(std::string name, std::size_t most) : name_(std::move(name)), most_(most) {}

    void write(std::string_view bytes) override {
        for (std::size_t newline; (newline = bytes.find('\n')) != std::string_view::npos;) {
            const std::string_view line = bytes.substr(0, newline);
            if (begun_.empty())
                take_line(line);
            else
                take_line(std::exchange(begun_, {}).append(line));
            bytes.remove_prefix(newline + 1);
        }
        begun_ += bytes;
    }

    Trace trace() && {
        Source around{name_, header_ + "\n" + end_ + "\n", {}};
        auto read = read_written_trace(std::move(around));
        if (!read)
            throw read.problem();
        Trace trace = std::move(read.value());
        trace.source_.text = std::move(held_.source_.text);
        trace.steps_ = std::move(held_.steps_);
        trace.runs_ = std::move(held_.runs_);
        trace.steps_in_runs_ = held_.steps_in_runs_;
        return trace;
    }

private:
    void take_line(std::string_view line) {
        if (header_.empty())
            header_ = line;
        else if (line.starts_with(R"({"end")"))
            end_ = line;
        else if (const auto pixel = pixel_in(line))
            add(*pixel);
        else
            add(line);
    }

    void add(const Pixel& pixel) {
        auto& runs = held_.runs_;
        const std::size_t number = held_.size() + 1;
        const bool goes_on = !runs.empty() && number - runs.back().first == runs.back().count &&
                             pixel.y == runs.back().y &&
                             pixel.x - runs.back().x == static_cast<int>(runs.back().count);
        if (goes_on) {
            ++runs.back().count;
        } else {
            make_room();
            runs.push_back({.first = number,
                            .before = held_.steps_in_runs_,
                            .count = 1,
                            .x = pixel.x,
                            .y = pixel.y});
        }
        ++held_.steps_in_runs_;
    }

    void add(std::string_view line) {
        make_room();
        std::string& text = held_.source_.text;
        held_.steps_.push_back(
            {text.size(), static_cast<std::uint32_t>(line.size()), kind_in(line)});
        text += line;
    }

    void make_room() const {
        if (held_.steps_.size() + held_.runs_.size() >= most_)
            throw too_many_steps(name_, most_);
    }

    std::string name_;
    std::size_t most_;
    std::string begun_; ///< of a line whose end has not been written yet
    std::string header_;
    std::string end_;
    Trace held_;
};

Trace drawn_trace(const Scene& scene, const Plan& plan, const std::string& name,
                  std::size_t most_steps) {
    DrawnSteps steps(name, most_steps);
    write_trace(scene, plan, {.layout = TraceLayout::jsonl, .filter = {}}, steps);
    return std::move(steps).trace();
}

} // namespace rastertrace
