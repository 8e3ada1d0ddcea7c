// SPDX-License-Identifier: MIT
#pragma once

// What the steps of steps.h are made of: the types of their fields, and the table that each of them has of these.

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/image.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace rastertrace {

/// Two vertices of the current primitive, by their place in PrimitiveBegan::vertices.
struct EdgeName {
    std::uint16_t from = 0;
    std::uint16_t to = 0;

    friend bool operator==(const EdgeName&, const EdgeName&) = default;
};

/// Stands for the name of the current primitive, which a drawing does not repeat in each step.
struct NameOfPrimitive {};

/// A value, or none where there is no such number. A trace says so: it is told as null.
template <typename Value> struct OrNull : std::optional<Value> {
    using std::optional<Value>::optional;
    OrNull() = default;
    OrNull(std::optional<Value> value)
        : std::optional<Value>(std::move(value)) {} // NOLINT: the same
};

/// The types of fields, while a scene is drawn with numbers of this type. A trace has types of its own for them.
template <typename Number> struct Held {
    using Name = std::string_view;
    using NameOfPrimitive = rastertrace::NameOfPrimitive;
    using Edge = EdgeName;
    using Flag = bool;
    using Color = rastertrace::Color;
    using Coordinate = int; ///< of a pixel
    using Whole = std::int64_t;
    using Cosine = double; ///< or another number that is a double whatever the scene is drawn with
    template <typename Enum> using Word = Enum;
    template <typename Value, std::size_t size> using Array = std::array<Value, size>;
    template <std::size_t size> using Vector = Vec<Number, size>;
    template <typename Value> using List = std::span<const Value>;
    template <typename Value> using Maybe = std::optional<Value>;
    template <typename Value> using OrNull = rastertrace::OrNull<Value>;
};

/// The same, as fields are declared with them.
namespace held {
template <typename Number> using Name = typename Held<Number>::Name;
template <typename Number> using NameOfPrimitive = typename Held<Number>::NameOfPrimitive;
template <typename Number> using Edge = typename Held<Number>::Edge;
template <typename Number> using Flag = typename Held<Number>::Flag;
template <typename Number> using Color = typename Held<Number>::Color;
template <typename Number> using Coordinate = typename Held<Number>::Coordinate;
template <typename Number> using Whole = typename Held<Number>::Whole;
template <typename Number> using Cosine = typename Held<Number>::Cosine;
template <typename Number, typename Enum> using Word = typename Held<Number>::template Word<Enum>;
template <typename Number, typename Value, std::size_t size>
using Array = typename Held<Number>::template Array<Value, size>;
template <typename Number, std::size_t size>
using Vector = typename Held<Number>::template Vector<size>;
template <typename Number, typename Value> using List = typename Held<Number>::template List<Value>;
template <typename Number, typename Value>
using Maybe = typename Held<Number>::template Maybe<Value>;
template <typename Number, typename Value>
using OrNull = typename Held<Number>::template OrNull<Value>;
} // namespace held

/// A list for a field that a step need not have: none if it is empty.
template <typename Range> auto if_any(const Range& range) {
    const std::span values(range);
    return values.empty()
               ? std::nullopt
               : std::optional<std::span<const typename decltype(values)::value_type>>(values);
}
inline std::optional<std::string_view> if_any(std::string_view name) {
    return name.empty() ? std::nullopt : std::optional(name);
}

/// What a field is for.
enum class FieldRole : std::uint8_t {
    key,      ///< which of the steps of its kind, within a primitive, it is
    reason,   ///< the decision can be taken again from it (docs/trace-format.md, "Doing it again")
    decision, ///< what was decided
    told,     ///< for who wants to know
};

/// Whether a step in a trace must have a field.
enum class FieldNeed : std::uint8_t {
    none,
    required, ///< without it the step cannot be understood
    or_null,  ///< it may be absent, or null where there is no such number
};

/// A string that is known when the program is compiled.
template <std::size_t size> struct FixedString {
    consteval FixedString(const char (&literal)[size]) { // NOLINT: a literal is one
        std::copy(literal, literal + size, characters);
    }
    constexpr std::string_view view() const { return {characters, size - 1}; }

    char characters[size];
};

/// A row of a step's table.
template <FixedString name_of_field, auto member, FieldRole role_of_field, FieldNeed need_of_field>
struct FieldRow {
    static constexpr FixedString fixed_name = name_of_field;
    static constexpr std::string_view name = fixed_name.view();
    static constexpr FieldRole role = role_of_field;
    static constexpr FieldNeed need = need_of_field;

    /// The field of a step.
    static constexpr auto& in(auto& step) { return step.*member; }
};

/// The fields of a step, in the order in which a trace writes them.
template <typename... Rows> struct FieldTable {};

/// Calls `use` with each field of a step, and with the same field of another one of its kind, over other numbers perhaps.
template <typename One, typename Other, typename Use>
void for_each_pair_of_fields(One& one, Other& other, Use&& use) {
    [&]<typename... OfOne, typename... OfOther>(FieldTable<OfOne...>, FieldTable<OfOther...>) {
        (use(OfOne::in(one), OfOther::in(other)), ...);
    }(typename One::Fields(), typename Other::Fields());
}

/// The words of the tables.
namespace field {
using enum FieldNeed;
template <FixedString name, auto member, FieldNeed need = none>
using Key = FieldRow<name, member, FieldRole::key, need>;
template <FixedString name, auto member, FieldNeed need = none>
using Reason = FieldRow<name, member, FieldRole::reason, need>;
template <FixedString name, auto member, FieldNeed need = none>
using Decision = FieldRow<name, member, FieldRole::decision, need>;
template <FixedString name, auto member, FieldNeed need = none>
using Told = FieldRow<name, member, FieldRole::told, need>;
} // namespace field

} // namespace rastertrace
