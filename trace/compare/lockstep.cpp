// SPDX-License-Identifier: MIT
#include "lockstep.h"

#include "compared_steps.h"
#include "diff_fields.h"

#include <rastertrace/trace/record/frame.h>
#include <rastertrace/trace/record/step_lines.h>
#include <rastertrace/trace/record/step_writer.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/text/method_names.h>

#include <optional>
#include <string>
#include <utility>

namespace rastertrace {

/// The steps that are told come as text, are read as those of a trace are, and kept for the sentences of what follows.
struct Lockstep::State {
    const TraceText& reference;
    DiffOptions options;
    Use use;
    ComparedSteps compared{reference, reference, options};
    FieldComparison fields{options, reference.header().method_value("scalar") == "float" ? 2 : 0};
    StepLines expected{reference};
    std::string text{};
    StringOutput output{text};
    StepWriter writer{output,
                      TraceLayout::jsonl,
                      {},
                      number_style_of(told_method(reference.header().method).triangles)};
    Listener listener{writer};
    Trace expected_steps = reference.header().without_steps();
    Trace told_steps = reference.header().without_steps();
    std::size_t told = 0;
    std::string primitive{};
    bool has_differed = false;

    State(const TraceText& of, DiffOptions asked, Use called)
        : reference(of), options(std::move(asked)), use(std::move(called)) {}

    /// The next step of the reference that is compared.
    const StepLine* next() {
        while (const StepLine* const step = expected.front()) {
            if (compared.has(*step))
                return step;
            add(expected_steps, *step);
            expected.pass();
        }
        return nullptr;
    }

    static void add(Trace& trace, const StepLine& step) {
        trace.add_to_excerpt(StepView(step.json), step.kind, step.number);
    }

    /// What the last step of a trace says.
    static DiffStep last_of(const Trace& trace, const StepLine& step) {
        Replay replay(trace, {.depths = true});
        replay.go_to(trace.size());
        return {.number = step.number,
                .line = step.place.lines + 2,
                .json = step.json,
                .sentence = describe_step(replay)};
    }

    void tell(const StepLine* a, const StepLine* b, std::vector<FieldDifference> differing) {
        has_differed = true;
        StepDifference found{.kind = a != nullptr ? a->kind_name : b->kind_name,
                             .primitive = primitive,
                             .fields = std::move(differing)};
        if (a != nullptr) {
            add(expected_steps, *a);
            found.a = last_of(expected_steps, *a);
        }
        if (b != nullptr) {
            found.b = last_of(told_steps, *b);
            found.b->line = 0;
        }
        use(found);
    }

    void take(const StepLine& step) {
        add(told_steps, step);
        if (step.kind == StepKind::primitive)
            primitive = name_in(StepView(step.json)).text();
        if (!compared.has(step))
            return;
        const StepLine* const other = next();
        if (other == nullptr || other->key != step.key)
            return tell(other, &step, {});
        if (auto differing = fields.differing(*other, step); !differing.empty())
            return tell(other, &step, std::move(differing));
        add(expected_steps, *other);
        expected.pass();
    }
};

Lockstep::Lockstep(const TraceText& reference, DiffOptions options, Use use)
    : state_(std::make_unique<State>(reference, std::move(options), std::move(use))) {}
Lockstep::Lockstep(Lockstep&&) noexcept = default;
Lockstep::~Lockstep() = default;

const Listener& Lockstep::listener() const {
    return state_->listener;
}

bool Lockstep::has_differed() const {
    return state_->has_differed;
}

void Lockstep::compare() {
    State& state = *state_;
    state.writer.flush();
    std::string text = std::exchange(state.text, "");
    const std::string_view json = step_of_line(text);
    if (state.has_differed || json.empty())
        return;
    state.take(step_line("the program", std::string(json), ++state.told));
}

void Lockstep::end() {
    if (!state_->has_differed)
        if (const StepLine* const missing = state_->next())
            state_->tell(missing, nullptr, {});
}

Lockstep compare_with(const TraceText& reference, DiffOptions options, Lockstep::Use use) {
    return {reference, std::move(options), std::move(use)};
}

} // namespace rastertrace
