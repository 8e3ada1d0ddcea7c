// SPDX-License-Identifier: MIT
#pragma once

// Whether two values of traces are alike: numbers by value, within a tolerance; names and colors by what they say.
//
//     differ(R"("25/8")", "3.125", {.type = FieldType::quantity});  // nothing: they are alike

#include "diff.h"

#include <rastertrace/trace/record/step_kind.h>

#include <optional>
#include <string_view>

namespace rastertrace {

/// What two values have to be compared by.
struct ValueComparison {
    std::optional<FieldType> type; ///< none: a field that we do not know
    bool is_color = false;
    const DiffTolerance* tolerance = nullptr;
    bool has_floats = false; ///< an ulp is one of a float
    bool are_floats = false; ///< numbers of one float are alike
};

/// How two values differ; nothing if they are alike.
struct ValueDifference {
    std::optional<double> distance{};
};
using Differs = std::optional<ValueDifference>;

/// How the JSON of two values differs, lists element by element.
Differs differ(std::string_view a, std::string_view b, const ValueComparison& by);

} // namespace rastertrace
