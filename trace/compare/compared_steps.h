// SPDX-License-Identifier: MIT
#pragma once

// Which steps of two traces are compared: those that neither an option nor one of the traces leaves out.
//
//     const ComparedSteps compared(a, b, options);
//     if (compared.has(step)) ...

#include "diff.h"
#include "steps_ahead.h"

#include <rastertrace/trace/record/trace_options.h>

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

class ComparedSteps {
public:
    ComparedSteps(const Trace& a, const Trace& b, const DiffOptions& options);

    /// True if steps of a kind are compared; of vertices in a space, `vertex in world`.
    bool has_kind(std::string_view with_space) const;

    /// True if both traces say where a primitive begins.
    bool has_primitives() const;

    bool has(const KeyedStep& step) const;

    /// True if the steps of a primitive, or those in front of the first ("") are compared.
    bool has_primitive(const std::string& name) const;

    /// False if one of them tells the steps of a single primitive.
    bool tells_all_primitives() const;

    /// True if both traces tell what is drawn, and of the same primitives ...
    bool has_pictures() const;

    /// ... and within which part; nothing: everywhere.
    std::optional<Region> region() const;

    /// What is not compared, in words.
    std::vector<std::string> remarks() const;

private:
    const Trace& a_;
    const Trace& b_;
    const DiffOptions& options_;
    std::optional<std::set<std::string, std::less<>>>
        common_; ///< the kinds that both have, if asked for
};

} // namespace rastertrace
