// SPDX-License-Identifier: MIT
#pragma once

// The steps of a trace that the answer about one pixel needs: those about this pixel and its row, and what is
// told of each primitive. They are few, however many pixels there are, so a large trace is answered for quickly.
//
//     StepsOfPixel steps(trace, {4, 2});
//     for (std::size_t n = 1; n <= trace.size(); ++n)
//         steps.take(n);
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
    StepsOfPixel(const Trace& trace, Pixel pixel)
        : trace_(trace), excerpt_(trace.without_steps()), pixel_(pixel) {}

    /// Takes step n of the trace. Steps come in order.
    void take(std::size_t n);

    /// The excerpt, once all steps have been taken. Its steps have the numbers that they were taken with.
    Trace finish() &&;

private:
    void begin_primitive(const StepView& step);
    void begin_line();
    void take_scanline(const StepView& step, std::size_t number);
    void take_fragment(const StepView& step, StepKind kind, std::size_t number);
    void take_reason(std::size_t number);
    bool is_at_pixel(const StepView& step) const;
    bool shares_line(const StepView& step, StepKind kind) const;
    void keep(std::size_t number);
    void keep_waiting(std::size_t& waiting);

    const Trace& trace_;
    Trace excerpt_;
    Pixel pixel_;
    bool is_line_ = false; ///< the current primitive is a line, sides, or a point
    bool is_point_ = false;
    std::optional<bool> is_x_major_; ///< of the current line, if it says so
    bool has_row_ = false;           ///< the current primitive has told one

    // Steps that are kept if something comes of them; 0: none.
    std::size_t row_ = 0; ///< the last one, which says where the rows end
    std::size_t ray_ = 0; ///< the last line of a `fan`
    std::size_t reason_before_ = 0;
    std::size_t reason_ = 0;   ///< where a line is: a pixel comes of it
    bool is_decision_ = false; ///< the last reason is one of Bresenham's
    bool is_decided_ = false; ///< a decision is kept: the next one of the line tells what d becomes
};

} // namespace rastertrace
