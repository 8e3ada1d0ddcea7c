// SPDX-License-Identifier: MIT
#include "diff_fields.h"

#include "value_difference.h"

#include <rastertrace/trace/record/field_type.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/record/visit_step.h>

#include <fmt/core.h>

#include <optional>
#include <string>
#include <utility>

namespace rastertrace {

namespace {

using Fields = std::vector<std::pair<std::string, std::string>>;

const std::string* value_in(const Fields& fields, std::string_view name) {
    for (const auto& [key, value] : fields)
        if (key == name)
            return &value;
    return nullptr;
}

/// The type of a field; of a list, that of its elements.
std::optional<FieldType> type_of(std::optional<StepKind> kind, std::string_view name) {
    if (!kind)
        return std::nullopt;
    for (const StepField& field : fields_of(*kind))
        if (field.name == name)
            return field.element;
    return std::nullopt;
}

/// The last tolerance that is about a field.
const DiffTolerance* tolerance_for(const std::vector<DiffTolerance>& tolerances,
                                   std::string_view kind, std::string_view field) {
    const DiffTolerance* last = nullptr;
    for (const DiffTolerance& one : tolerances)
        if ((one.kind.empty() || one.kind == kind) && (one.field.empty() || one.field == field))
            last = &one;
    return last;
}

} // namespace

std::vector<FieldDifference> FieldComparison::differing(const KeyedStep& a,
                                                        const KeyedStep& b) const {
    std::vector<FieldDifference> differences;
    const StepView step_a = a.view();
    const StepView step_b = b.view();
    if (are_same(step_a, step_b))
        return differences;
    const Fields of_a = step_a.fields();
    const Fields of_b = step_b.fields();
    const auto is_compared = [&](std::string_view name) {
        return name != "step" && name != key_of_code &&
               !options_.ignores(fmt::format("{}.{}", a.kind_name, name));
    };
    for (const auto& [name, value] : of_a) {
        const std::string* const other = value_in(of_b, name);
        if (!is_compared(name))
            continue;
        if (other == nullptr && options_.compares_common)
            continue;
        if (other == nullptr) {
            differences.push_back({.name = name, .a = value});
            continue;
        }
        const ValueComparison by{.type = type_of(a.kind, name),
                                 .is_color = holds_color(name),
                                 .tolerance = tolerance_for(options_.tolerances, a.kind_name, name),
                                 .has_floats = floats_ > 0,
                                 .are_floats = floats_ == 2};
        if (const Differs here = differ(value, *other, by))
            differences.push_back(
                {.name = name, .a = value, .b = *other, .distance = here->distance});
    }
    if (options_.compares_common)
        return differences;
    for (const auto& [name, value] : of_b)
        if (value_in(of_a, name) == nullptr && is_compared(name))
            differences.push_back({.name = name, .b = value});
    return differences;
}

} // namespace rastertrace
