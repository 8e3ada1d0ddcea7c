// SPDX-License-Identifier: MIT
#include "traced_steps.h"

#include "field_type.h"
#include "trace.h"
#include "visit_step.h"

#include <rastertrace/trace/text/json_scanner.h>

#include <array>
#include <type_traits>
#include <utility>
#include <variant>

namespace rastertrace {

namespace {

/// What a value of this type is, and of a list, what its values are.
template <typename Value> struct TypeOf {
    static constexpr FieldType type = FieldType::string; // TracedText, TracedColor, TracedWord
    static constexpr FieldType element = type;
    static constexpr bool is_color = std::is_same_v<Value, TracedColor>;
};
template <FieldType of> struct Plain {
    static constexpr FieldType type = of;
    static constexpr FieldType element = of;
    static constexpr bool is_color = false;
};
template <> struct TypeOf<Index> : Plain<FieldType::whole> {};
template <> struct TypeOf<std::optional<Index>> : Plain<FieldType::whole> {};
template <> struct TypeOf<TracedNumber> : Plain<FieldType::quantity> {};
template <> struct TypeOf<TracedFlag> : Plain<FieldType::boolean> {};
template <typename Value> struct TypeOf<TracedList<Value>> {
    static constexpr FieldType type = FieldType::list;
    static constexpr FieldType element = TypeOf<Value>::element;
    static constexpr bool is_color = TypeOf<Value>::is_color;
};

template <typename Step, typename Row>
using MemberOf = std::remove_cvref_t<decltype(Row::in(std::declval<Step&>()))>;

template <typename Step, typename... Rows> constexpr auto fields_in(FieldTable<Rows...> /*table*/) {
    return std::array{StepField{.name = Rows::name,
                                .type = TypeOf<MemberOf<Step, Rows>>::type,
                                .element = TypeOf<MemberOf<Step, Rows>>::element,
                                .is_color = TypeOf<MemberOf<Step, Rows>>::is_color,
                                .role = Rows::role,
                                .need = Rows::need}...};
}

template <typename Step> constexpr auto fields_of_step = fields_in<Step>(typename Step::Fields{});

template <std::size_t... kind>
std::span<const StepField> fields_of(StepKind asked, std::index_sequence<kind...> /*all*/) {
    static_assert(
        ((static_cast<std::size_t>(std::variant_alternative_t<kind, AnyStep>::step_kind) == kind) &&
         ...));
    constexpr std::array<std::span<const StepField>, step_kinds> all{
        fields_of_step<std::variant_alternative_t<kind, AnyStep>>...};
    return all[static_cast<std::size_t>(asked)];
}

} // namespace

std::span<const StepField> fields_of(StepKind kind) {
    return fields_of(kind, std::make_index_sequence<step_kinds>{});
}

std::string name_of_whole(const PrimitiveStep& primitive) {
    const std::string name = primitive.name.text();
    return primitive.part.is_true() ? name.substr(0, name.rfind('/')) : name;
}

std::string name_of_face(const PrimitiveStep& primitive) {
    return primitive.face ? primitive.face.text() : name_of_whole(primitive);
}

namespace {

/// What the text of a step has under a name that its kind does not know, or of a kind that nobody knows; null if nothing.
std::string_view in_own_text(const StepView& step, std::string_view name) {
    JsonScanner fields(step.own_text());
    while (fields.next_field())
        if (fields.key() == name)
            return fields.value();
    return {};
}

/// A whole number that some kinds have under a name; `member_of` gives it of their structs.
template <typename MemberOf>
std::optional<Index> whole_in_step(const StepView& step, std::string_view name,
                                   const MemberOf& member_of) {
    std::optional<Index> found;
    visit_step(step, [&](const auto& known) {
        if constexpr (requires { std::optional<Index>(member_of(known)); })
            found = member_of(known);
    });
    if (found || step.own_text().empty())
        return found;
    return whole_in(in_own_text(step, name));
}

} // namespace

TracedText name_in(const StepView& step) {
    if (!step.own_text().empty())
        return TracedText(in_own_text(step, "name"));
    TracedText name;
    visit_step(step, [&name](const auto& known) {
        if constexpr (requires { known.name; })
            name = known.name;
    });
    return name;
}

std::optional<Index> x_in(const StepView& step) {
    return whole_in_step(step, "x", [](const auto& known) -> decltype(known.x) { return known.x; });
}

std::optional<Index> y_in(const StepView& step) {
    return whole_in_step(step, "y", [](const auto& known) -> decltype(known.y) { return known.y; });
}

} // namespace rastertrace
