// SPDX-License-Identifier: MIT
#pragma once

// The kinds of step that a trace file knows by name: one row each in one table (step_kind.cpp), which says
// what a step has and how its sentence reads. Who reads, describes or compares steps asks here.
//
//     row_of(StepKind::scanline).fields;  // y, left, right, from, ...

#include <rastertrace/trace/text/language.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace rastertrace {

/// In the order in which a picture meets them; the end record counts them in this order.
enum class StepKind {
    triangulate,
    matrix,
    vertex,
    order,
    primitive,
    face,
    light,
    clip,
    edge,
    half,
    ray,
    scanline,
    along,
    decide,
    sample,
    depth,
    pixel,
    reject,
    skip,
    undecided,
};

inline constexpr std::size_t step_kinds = 20;

/// What a field of a step holds.
enum class FieldType : std::uint8_t {
    whole,    ///< an index
    quantity, ///< a number, or an exact one like "25/8"
    string,
    boolean,
    list, ///< of any of these
};

/// What a field is for.
enum class FieldRole : std::uint8_t {
    key,      ///< which of the steps of its kind, within a primitive, it is
    reason,   ///< the decision can be taken again from it (docs/trace-format.md, "Doing it again")
    decision, ///< what was decided
    told,     ///< for who wants to know
};

struct StepField {
    std::string_view name;
    FieldType type;
    FieldRole role;
    bool is_required = false; ///< without it the step cannot be understood
    bool may_be_null = false; ///< null where there is no such number
};

/// What the values of a list are, or those of the lists in it.
FieldType element_type_of(const StepField& list);

/// All about a kind of step.
struct StepRow {
    StepKind kind;
    std::string_view name;  ///< the value of "step"
    std::string_view fires; ///< "the two ends of a row are known"

    /// Its sentence, in each language: {x} is the field x, a list as (1, 2); {#x} is one of the words that traces have
    /// (language.h); {pass?passes:fails} chooses by a boolean; {@name} is worked out by describe.cpp.
    Words sentence;

    std::vector<StepField> fields; ///< in the order in which they are written
};

/// The row of a kind.
const StepRow& row_of(StepKind kind);

/// The value of "step": matrix, vertex, ...
std::string_view name_of(StepKind kind);

/// The kind of that name, if we know it. A trace may hold kinds that we do not know.
std::optional<StepKind> step_kind_named(std::string_view name);

/// All names.
std::vector<std::string_view> step_kind_names();

} // namespace rastertrace
