// SPDX-License-Identifier: MIT
#include "slip_answers.h"

#include <rastertrace/trace/check/derivation.h>
#include <rastertrace/trace/check/slips.h>
#include <rastertrace/trace/check/step_index.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace rastertrace {

Answers slip_answers_in(const Trace& trace) {
    constexpr std::array worked_out{StepKind::vertex, StepKind::face,     StepKind::light,
                                    StepKind::edge,   StepKind::scanline, StepKind::decide,
                                    StepKind::along,  StepKind::depth};
    constexpr std::size_t most = 200;
    const StepIndex index(trace);
    const Numbers numbers(index);
    Answers answers(slips().size());
    std::size_t count = 0;
    for (std::size_t n = 1; n <= trace.size() && count < most; ++n) {
        const auto kind = trace.kind_of(n);
        if (!kind || std::find(worked_out.begin(), worked_out.end(), *kind) == worked_out.end())
            continue;
        ++count;
        for (const StepField& field : fields_of(*kind)) {
            if (!trace.step(n).field(field.name)) // nobody is asked for it
                continue;
            const auto formulas = formulas_of(numbers, n, field.name);
            if (formulas.empty())
                continue;
            for (std::size_t i = 0; i < answers.size(); ++i)
                for (const SlipResult& result : slips()[i].redo(formulas.front())) {
                    std::string& answer = answers[i] ? *answers[i] : answers[i].emplace();
                    answer += fmt::format("{}.{}=", n, field.name);
                    for (const Rational& value : result.values)
                        answer += value.get_str() + ",";
                }
        }
    }
    return answers;
}

} // namespace rastertrace
