// SPDX-License-Identifier: MIT
#pragma once

// The steps of a trace that the answer about one pixel needs: those about this pixel and its row, and what is
// told of each primitive. They are few, however many pixels there are, so a trace of any size can be asked as
// it is read.
//
//     StepsOfPixel steps(stream.header(), {4, 2});
//     while (stream.next())
//         steps.take(stream.step(), stream.kind(), stream.number());
//     const auto answer = explain(std::move(steps).finish(), {.pixel = {4, 2}});

#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/trace/record/trace.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rastertrace {

class StepsOfPixel {
public:
    /// `header` is the trace, or one without its steps.
    StepsOfPixel(const Trace& header, Pixel pixel)
        : excerpt_(header.without_steps()), pixel_(pixel) {}

    /// Takes a step. Steps come in order.
    void take(const StepView& step, std::optional<StepKind> kind, std::size_t number);

    /// The excerpt, once all steps have been taken. Its steps have the numbers that they were taken with.
    Trace finish() &&;

private:
    /// A step that matters only if a later one does.
    struct Waiting {
        std::string_view in_file{}; ///< its text, if that stays where it is
        std::string copy{};         ///< else
        std::optional<StepKind> kind{};
        std::size_t number = 0; ///< 0: none waits
    };
    Waiting waiting(const StepView& step, StepKind kind, std::size_t number) const;

    void begin_primitive(const StepView& step);
    void begin_line();
    void take_scanline(const StepView& step, std::size_t number);
    void take_fragment(const StepView& step, StepKind kind, std::size_t number);
    void take_reason(const StepView& step, StepKind kind, std::size_t number);
    bool is_at_pixel(const StepView& step) const;
    bool shares_line(const StepView& step, StepKind kind) const;
    void keep(const StepView& step, std::optional<StepKind> kind, std::size_t number);
    void keep(Waiting& waiting);

    Trace excerpt_;
    Pixel pixel_;
    bool is_line_ = false; ///< the current primitive is a line, sides, or a point
    bool is_point_ = false;
    std::optional<bool> is_x_major_; ///< of the current line, if it says so
    bool has_row_ = false;           ///< the current primitive has told one
    Waiting row_;                    ///< the last row, which says where the rows end
    Waiting ray_;                    ///< the last line of a `fan`
    Waiting reason_before_;
    Waiting reason_;          ///< where a line is: a pixel comes of it
    bool is_decided_ = false; ///< a decision is kept: the next one of the line tells what d becomes
};

} // namespace rastertrace
