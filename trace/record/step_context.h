// SPDX-License-Identifier: MIT
#pragma once

// What a step of a trace belongs to: its primitive, and what came before it that its numbers hang on.
//
//     const StepContext at(trace, 14);
//     trace.step(at.primitive());     // the triangle whose row step 14 is
//     at.edges();                     // its edges, by number
//
// Nothing is remembered from step to step. All steps of a kind are listed once someone asks for one.

#include "trace.h"
#include "traced_steps.h"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace rastertrace {

/// A step of a trace, which must outlive it. Copies share their lists.
class StepContext {
public:
    explicit StepContext(const Trace& trace, std::size_t step = 0);

    /// Another step of the same trace.
    StepContext at(std::size_t step) const;

    const Trace& trace() const { return *trace_; }

    /// The number of the step; 0 before the first.
    std::size_t step() const { return step_; }

    /// All steps of a kind, in order; those up to this one; and those of this one's primitive, before and behind it.
    const std::vector<std::size_t>& all_of(StepKind kind) const;
    std::span<const std::size_t> so_far(StepKind kind) const;
    std::span<const std::size_t> in_primitive(StepKind kind) const;

    /// Steps up to this one, by number; 0 if there is none. The primitive that it belongs to, the last row, and the one
    /// before that of the same primitive.
    std::size_t primitive() const { return primitive_of(step_); }
    std::size_t scanline() const;
    std::size_t scanline_before() const;

    /// Where the current line of a `fan` began.
    std::size_t ray() const;

    /// The step that told how the painter sorts the triangles.
    std::size_t order() const;

    /// The last place of a vertex before the one that is told last.
    std::size_t vertex_before() const;

    /// The edges of the primitive that have been set up.
    std::span<const std::size_t> edges() const;

    /// The primitives and the `matrix` steps so far.
    std::span<const std::size_t> primitives() const { return so_far(StepKind::primitive); }
    std::span<const std::size_t> matrices() const { return so_far(StepKind::matrix); }

    /// The primitive that any step of the trace belongs to; 0 if there is none.
    std::size_t primitive_of(std::size_t step) const;

    /// All steps of the trace that tell where a vertex is on its way to the screen, by number.
    const std::vector<std::size_t>& places_of(const std::string& vertex) const;

protected:
    std::size_t step_;

private:
    struct Lists {
        std::map<StepKind, std::vector<std::size_t>> of_kind;
        std::optional<std::unordered_map<std::string, std::vector<std::size_t>>> places;
    };

    std::span<const std::size_t> of_primitive_so_far(StepKind kind) const;

    const Trace* trace_;
    std::shared_ptr<Lists> lists_;
};

} // namespace rastertrace
