// SPDX-License-Identifier: MIT
#pragma once

// The lines of a trace's steps, one after the other, with a look at those ahead.
//
//     StepLines lines(text, {});
//     while (const StepLine* line = lines.front())
//         use(*line), lines.pass();

#include "step_kind.h"
#include "trace_text.h"

#include <rastertrace/trace/text/problem.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// Where in a text a line begins, and how many steps and lines stand in front, not counting the header.
struct LinePlace {
    std::size_t offset = 0;
    std::size_t steps = 0;
    std::size_t lines = 0;
};

/// One step, as a line has it.
struct StepLine {
    std::string json{}; ///< without a comma behind it
    std::optional<StepKind> kind{};
    std::string kind_name{};
    std::string
        key{}; ///< its kind, and the fields that tell it from others of its kind in its primitive
    LinePlace place{};      ///< of its line
    std::size_t number = 0; ///< from 1
};

/// By kinds that we do not know: the fields that tell a step from others of its kind. `name`, `x` and `y` of any other.
using StepKeys = std::map<std::string, std::vector<std::string>>;

class StepLines {
public:
    /// Goes from a place on, the first line if that is at offset 0, to the end of the steps or to `end`.
    explicit StepLines(const TraceText& text, LinePlace from = {},
                       std::size_t end = std::numeric_limits<std::size_t>::max(),
                       StepKeys keys = {});

    /// The next step; nullptr behind the last. Throws a Problem if it is none that can be understood.
    const StepLine* front() { return at(0); }

    /// The i-th step from there, from 0.
    const StepLine* at(std::size_t i);

    /// The same, if at() has been asked for it already; else nullptr.
    const StepLine* ahead() const { return ahead_.empty() ? nullptr : &ahead_.front(); }

    /// Goes on by one.
    void pass() { ahead_.pop_front(); }

    /// Whole lines that have been read and that at() has not been asked for; nothing where there are such. More are
    /// read if there are none.
    std::string_view unread_lines();

    /// Goes through whole lines, the text that comes next, as far as `use(line, place)` wants and the steps go; returns
    /// the place behind them.
    template <typename Use> LinePlace go_through(std::string_view text, const Use& use) const {
        LinePlace place = place_;
        for (std::size_t begin = 0;;) {
            const std::size_t newline = text.find('\n', begin);
            if (newline == std::string_view::npos)
                return place;
            const std::string_view line = text.substr(begin, newline - begin);
            if (ends_steps(line) || !use(line, place))
                return place;
            place.offset += line.size() + 1;
            place.steps += is_blank(line) ? 0 : 1;
            ++place.lines;
            begin = newline + 1;
        }
    }

    /// Calls `use(line, place)` with all whole lines that are left, as far as the steps go; none if at() has been asked for
    /// lines ahead.
    template <typename Use> void pass_all_lines(const Use& use) {
        const auto goes_on = [&use](std::string_view line, LinePlace place) {
            use(line, place);
            return true;
        };
        std::size_t before = 0;
        do {
            before = place_.offset;
            pass_lines(go_through(unread_lines(), goes_on));
        } while (before != place_.offset);
    }

    /// True for a line without a step.
    static bool is_blank(std::string_view line);

    /// Goes on by whole lines, to a place behind some of them.
    void pass_lines(LinePlace to);

    /// Where the line behind all that at() was asked for begins.
    LinePlace place() const { return place_; }

    /// True once front() is nullptr because the text ends, and not the steps.
    bool is_cut_off() const { return is_cut_off_; }

    /// True for the line behind the last step.
    bool ends_steps(std::string_view line) const;

private:
    bool read_more();
    Problem too_long() const;
    std::optional<std::string_view> next_line();
    StepLine step_in(std::string_view line) const;

    const TraceText& text_;
    std::string buffer_;
    std::size_t passed_ = 0; ///< bytes of the buffer
    LinePlace place_;
    std::size_t end_;
    StepKeys keys_;
    std::deque<StepLine> ahead_;
    bool has_all_ = false; ///< the text has been read to its end
    bool is_behind_ = false;
    bool is_cut_off_ = false;
};

/// A step line without blanks around it, and without the comma of a document.
std::string_view step_of_line(std::string_view line);

} // namespace rastertrace
