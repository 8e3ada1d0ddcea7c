// SPDX-License-Identifier: MIT
#include "step_tracer.h"
#include "steps.h"
#include "trace_lines.h"
#include "write_trace.h"

#include <rastertrace/core/draw/draw.h>

#include <memory>
#include <string>
#include <utility>

namespace rastertrace {

Trace drawn_trace(const Scene& scene, const Plan& plan, const std::string& name,
                  std::size_t most_steps) {
    const auto steps = std::make_shared<Steps>(Source{.name = name, .text = {}});
    steps->bound(most_steps);
    StepTracer<Steps> tracer(*steps, steps->arena(), true);
    const Image image = draw(scene, plan, tracer);
    const std::string around =
        "{" + header_members(scene, plan, {}) + "}\n{" + end_record(steps->counts(), image) + "}\n";
    Trace trace = trace_around_steps({name, around});
    trace.steps_ = steps;
    return trace;
}

} // namespace rastertrace
