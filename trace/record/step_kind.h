// SPDX-License-Identifier: MIT
#pragma once

// The kinds of step that a trace file knows by name: one row each in one table (step_kind.cpp), which says
// how its sentence reads; what it has, the table of its struct says (core/raster/steps.h).
//
//     fields_of(StepKind::scanline);  // y, left, right, from, ...

#include <rastertrace/core/raster/steps.h>
#include <rastertrace/trace/text/language.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace rastertrace {

inline constexpr std::size_t step_kinds = step_names.size();

/// How many steps of each kind there are.
using KindCounts = std::array<std::uint64_t, step_kinds>;

/// Some of the kinds.
class StepKindSet {
public:
    constexpr StepKindSet() = default;
    constexpr StepKindSet(std::initializer_list<StepKind> kinds) {
        for (const StepKind kind : kinds)
            add(kind);
    }

    static constexpr StepKindSet all() {
        StepKindSet set;
        set.bits_ = ~std::uint32_t{0};
        return set;
    }

    constexpr void add(StepKind kind) { bits_ |= bit(kind); }
    constexpr bool has(StepKind kind) const { return (bits_ & bit(kind)) != 0; }

private:
    static constexpr std::uint32_t bit(StepKind kind) {
        static_assert(step_kinds <= 32);
        return std::uint32_t{1} << static_cast<unsigned>(kind);
    }

    std::uint32_t bits_ = 0;
};

/// What a field of a step holds.
enum class FieldType : std::uint8_t {
    whole,    ///< an index
    quantity, ///< a number, or an exact one like "25/8"
    string,
    boolean,
    list, ///< of any of these
};

struct StepField {
    std::string_view name;
    FieldType type;
    FieldType element; ///< of a list: what its values are, or those of the lists in it; else `type`
    bool is_color;     ///< a string that is a color, or a list of them
    FieldRole role;
    FieldNeed need;
    bool is_required() const { return need == FieldNeed::required; }
    bool may_be_null() const { return need == FieldNeed::or_null; }
};

/// The fields of a kind, in the order in which they are written: the table of its struct (core/raster/steps.h).
std::span<const StepField> fields_of(StepKind kind);

/// The rest about a kind of step.
struct StepRow {
    StepKind kind;
    std::string_view fires; ///< "the two ends of a row are known"

    /// Its sentence, in each language: {x} is the field x, a list as (1, 2); {#x} is one of the words that traces have
    /// (language.h); {pass?passes:fails} chooses by a boolean; {@name} is worked out by describe.cpp.
    Words sentence;
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
