// SPDX-License-Identifier: MIT
#pragma once

// Whether the JSON of a step's field is of the type that the table of steps gives it.
//
//     has_type("-1", FieldType::whole);  // true

#include "step_kind.h"

#include <rastertrace/core/raster/canvas.h>

#include <optional>
#include <string_view>

namespace rastertrace {

/// A JSON number that is a whole number within +-farthest_index, written without point or exponent.
std::optional<Index> whole_in(std::string_view json);

/// True for a quantity that a foreign rasterizer has recorded and that is not finite: "NaN", "inf", "-inf".
bool is_not_finite(std::string_view json);

/// The first such value of a field, or of a list; none if all are finite.
std::optional<std::string_view> not_finite_in(std::string_view json);

/// True for the fields that hold a color, or a list of them.
bool holds_color(std::string_view name);

/// True if the JSON of a value is of a type.
bool has_type(std::string_view json, FieldType type);

/// The same for a field, with the elements of a list, and with null where there may be none.
bool has_type_of(std::string_view json, const StepField& field);

/// What a value of the type is called in messages: `a whole number`.
std::string_view expected_for(FieldType type);

/// The same for a field: `an array of numbers`.
std::string_view expected_for(const StepField& field);

} // namespace rastertrace
