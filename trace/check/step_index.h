// SPDX-License-Identifier: MIT
#pragma once

// Steps of a trace found by their key fields, without walking the trace for each.
//
//     StepIndex index(trace);
//     index.find(StepKind::scanline, {{"y", "2"}});  // {14}

#include <rastertrace/core/raster/image.h>
#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/step_kind.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/tell/formula.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace rastertrace {

/// The trace must outlive its index.
class StepIndex {
public:
    /// A field and the value that it must have. "in" is the name of the step's primitive, of what that is a
    /// part of, or of the side of an outline.
    using Keys = std::vector<std::pair<std::string, std::string>>;

    explicit StepIndex(const Trace& trace);

    const Trace& trace() const { return *trace_; }

    /// The `primitive` step that step n belongs to; 0 for none.
    std::size_t primitive_of(std::size_t n) const { return last_until(primitives_, n); }

    /// The steps of a kind that have all these values, in order.
    const std::vector<std::size_t>& find(StepKind kind, const Keys& keys) const;

    /// Every value of a field in steps of a kind, each once.
    std::vector<std::string> values_of(StepKind kind, const std::string& field) const;

    /// The `vertex` step of a vertex in a space; 0 if there is none.
    std::size_t place(const std::string& vertex, std::string_view space) const;

    /// The step before a `vertex` step of the same vertex, in the space that it comes from; 0 for none.
    std::size_t place_before(std::size_t n) const;

    /// A step for each pixel that a primitive has, in the order in which it has them: the test of one that is hidden.
    std::vector<std::size_t> pixels_of(std::size_t primitive) const;

    /// What a field of a step says, as numbers; nothing if it holds anything else.
    const Values& numbers(std::size_t step, std::string_view field) const;

    /// The final picture.
    const Frame& frame() const;

private:
    using Found = std::unordered_map<std::string, std::vector<std::size_t>>;

    /// Of steps in ascending order, the last that is not behind step n; 0 for none.
    static std::size_t last_until(const std::vector<std::size_t>& steps, std::size_t n);

    /// The `edge` step of the side that is being drawn in step n; 0 for none.
    std::size_t side_of(std::size_t n) const;

    /// The names that "in" may have for step n.
    std::vector<std::string> names_around(std::size_t n) const;

    /// True if step n has all these values.
    bool has_all(std::size_t n, StepKind kind, const Keys& wanted) const;

    const Trace* trace_;
    std::vector<std::size_t> primitives_; ///< the steps that begin one
    std::vector<std::size_t> sides_;      ///< the `edge` steps of outlines
    std::array<std::size_t, step_kinds> count_{};
    mutable std::map<std::pair<StepKind, std::string>, Found>
        found_; ///< by kind and names of fields; of a kind with many steps, only what was asked for
    mutable std::map<std::pair<std::size_t, std::string>, Values> numbers_; ///< that were asked for
    mutable std::optional<Frame> frame_;
};

/// A value as it is compared: a number in lowest terms, any other text as it is.
std::string normal_form(const std::string& value);

} // namespace rastertrace
