// SPDX-License-Identifier: MIT
#pragma once

// Steps of a trace found by their key fields, without walking the trace for each.
//
//     StepIndex index(trace);
//     index.find(StepKind::scanline, {{"y", "2"}});  // {14}

#include <rastertrace/core/raster/image.h>
#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/step_context.h>
#include <rastertrace/trace/record/step_kind.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/tell/numbers.h>

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

    const StepContext& steps() const { return right_.steps(); }
    const Trace& trace() const { return steps().trace(); }

    /// The numbers of the trace.
    const Numbers& right() const { return right_; }

    /// The `primitive` step that step n belongs to; 0 for none.
    std::size_t primitive_of(std::size_t n) const { return steps().primitive_of(n); }

    /// The steps of a kind that have all these values, in order.
    const std::vector<std::size_t>& find(StepKind kind, const Keys& keys) const;

    /// Every value of a field in steps of a kind, each once.
    std::vector<std::string> values_of(StepKind kind, const std::string& field) const;

    /// The final picture.
    const Frame& frame() const;

private:
    using Found = std::unordered_map<std::string, std::vector<std::size_t>>;

    /// The `edge` step of the side that is being drawn in step n; 0 for none.
    std::size_t side_of(std::size_t n) const;

    /// The names that "in" may have for step n.
    std::vector<std::string> names_around(std::size_t n) const;

    /// True if step n has all these values.
    bool has_all(std::size_t n, StepKind kind, const Keys& wanted) const;

    Numbers right_;
    mutable std::map<std::pair<StepKind, std::string>, Found>
        found_; ///< by kind and names of fields; of a kind with many steps, only what was asked for
    mutable std::optional<Frame> frame_;
};

/// A value as it is compared: a number in lowest terms, any other text as it is.
std::string normal_form(const std::string& value);

} // namespace rastertrace
