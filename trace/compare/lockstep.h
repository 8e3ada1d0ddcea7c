// SPDX-License-Identifier: MIT
#pragma once

// A sink that holds each step against the next one of a reference, while the program that decides still runs: a
// breakpoint in `use` is in the middle of the fill that has gone another way.
//
//     Lockstep sink = compare_with(reference, {}, [](const StepDifference& found) { puts(found.b->sentence.c_str()); });
//     draw(scene, plan, sink);  // or your own fill: sink(PixelPlotted{{3, 2}, color});
//     sink.end();

#include "diff.h"

#include <rastertrace/core/draw/tell/listener.h>
#include <rastertrace/trace/record/trace_text.h>

#include <functional>
#include <memory>

namespace rastertrace {

class Lockstep {
public:
    using Use = std::function<void(const StepDifference& found)>;

    /// The reference has to live as long. Throws a Problem for options that name what no trace can have.
    Lockstep(const TraceText& reference, DiffOptions options, Use use);
    Lockstep(Lockstep&&) noexcept;
    ~Lockstep();

    /// Takes a step (steps.h), its numbers as Quantity. Throws a Problem if the next step of the reference is none.
    template <typename Step>
    requires CallableWith<const Listener, const Step>
    void operator()(const Step& step) {
        listener()(step);
        compare();
    }

    /// Nothing more comes: what the reference has besides is a difference.
    void end();

    /// True once `use` has been called: what follows is not compared.
    bool has_differed() const;

private:
    const Listener& listener() const;
    void compare();

    struct State;
    std::unique_ptr<State> state_;
};

/// Calls `use` at the first step that differs from the reference's, once. Kinds of step that `options.only` does not
/// name, if it names any, or that are ignored, are passed over.
Lockstep compare_with(const TraceText& reference, DiffOptions options, Lockstep::Use use);

} // namespace rastertrace
