// SPDX-License-Identifier: MIT
#include "redo.h"

#include "redo_beside.h"
#include "redo_drawn.h"
#include "redo_space.h"

#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/tell/describe.h>

#include <fmt/core.h>

#include <algorithm>

namespace rastertrace {

Redone redo(const Trace& trace) {
    Findings findings;
    SpaceAgain space(trace, findings);
    DrawnAgain drawn(trace, findings);
    const StepKindSet begins{StepKind::primitive};
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const auto kind = trace.kind_of(n);
        if (kind == StepKind::vertex)
            drawn.see(trace.step(n).as<VertexStep>());
        if (kind == StepKind::primitive) {
            const std::size_t last = trace.next_of(begins, n + 1, trace.size()) - 1;
            if (!drawn.redo(n, last))
                redo_beside(trace, n, last, findings);
        }
        space.redo(n);
    }
    space.finish();
    return findings.take();
}

std::string WrongDecision::value() const {
    return what.substr(std::min(what.find(": ") + 2, what.size()));
}

std::string WrongDecision::field() const {
    return value().substr(0, value().find_first_of(" ,"));
}

std::uint64_t Redone::values() const {
    std::uint64_t values = 0;
    for (const auto& [what, times] : count)
        values += times;
    return values;
}

std::string nothing_redone() {
    return "nothing was compared: expected numbers that can be done again, found none";
}

void mark_wrong_steps(Trace& trace) {
    if (!trace.is_partial)
        trace.numbers_give =
            std::make_shared<const std::map<std::size_t, std::string>>(redo(trace).wrong_steps);
}

Problem problem_of(const Redone& redone, const Trace& trace) {
    const WrongDecision& first = redone.first;
    Replay replay(trace);
    replay.go_to(first.step);
    Problem problem = trace.problem_at_field(
        first.step, first.field(),
        fmt::format("expected {} for {}, done again from the numbers of the trace, found {}",
                    first.redone, first.what, first.told));
    problem.hint = fmt::format("step {} tells: {}", first.step, describe_step(replay));
    if (redone.wrong > 1)
        problem.message += fmt::format("; {} more {} not what {} numbers give", redone.wrong - 1,
                                       redone.wrong == 2 ? "value is" : "values are",
                                       redone.wrong == 2 ? "its" : "their");
    return problem;
}

} // namespace rastertrace
