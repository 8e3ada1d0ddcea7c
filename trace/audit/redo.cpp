// SPDX-License-Identifier: MIT
#include "redo.h"

#include "redo_exact.h"
#include "redo_steps.h"

#include <rastertrace/trace/record/frame.h>
#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/text/method_names.h>

#include <fmt/core.h>

#include <algorithm>

namespace rastertrace {

RulesTold::RulesTold(const Trace& header)
    : ToldMethod(told_method(header.method)), samples(told_samples(header)),
      has_view_plane(header.projection == "view-plane") {}

/// What was redone in two parts.
Redone both(Redone a, Redone b) {
    for (const auto& [what, count] : b.count)
        a.count[what] += count;
    if (a.wrong == 0 || (b.wrong > 0 && b.first.step < a.first.step))
        a.first = b.first;
    a.wrong += b.wrong;
    a.wrong_steps.merge(b.wrong_steps);
    return a;
}

Redone redo(const Trace& trace) {
    const RulesTold rules(trace);
    if (!rules.says("scalar"))
        return redo_in_rationals(trace, false);
    switch (rules.triangles.scalar) {
    case ScalarKind::single_precision:
        return redo_steps::Redo<float, float, true>(trace).run();
    case ScalarKind::double_precision:
        return redo_steps::Redo<double, double, true>(trace).run();
    case ScalarKind::fixed:
        return trace.numbers == "fractions of any size" ? redo_in_rationals(trace, true)
                                                        : redo_with_double_depths(trace);
    case ScalarKind::exact:
        return redo_in_rationals(trace, true);
    case ScalarKind::adaptive:
        return both(redo_steps::Redo<double, double, true>(trace, StepsToRedo::in_doubles).run(),
                    redo_in_rationals(trace, true, StepsToRedo::in_fractions));
    }
    not_an_enumerator();
}

std::string WrongDecision::value() const {
    return what.substr(std::min(what.find(": ") + 2, what.size()));
}

std::string WrongDecision::field() const {
    return value().substr(0, value().find_first_of(" ,"));
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
