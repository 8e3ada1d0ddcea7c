// SPDX-License-Identifier: MIT
#include "traced_steps.h"

#include "field_type.h"
#include "trace.h"

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/trace/text/primitive_name.h>

#include <array>
#include <type_traits>
#include <utility>
#include <variant>

namespace rastertrace {

namespace {

/// The number of a text, if it is one.
std::optional<Number> number_of(std::string_view text) {
    auto parsed = parse_number(text, NumberSize::any);
    auto* const number = std::get_if<Number>(&parsed);
    return number == nullptr ? std::nullopt : std::optional(std::move(*number));
}

template <typename Value> constexpr bool is_list = false;
template <typename Value> constexpr bool is_list<TracedList<Value>> = true;

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

void set(Index& value, std::string_view json) {
    value = whole_in(json).value_or(0);
}
void set(std::optional<Index>& value, std::string_view json) {
    value = whole_in(json);
}
template <typename Value> void set(Value& value, std::string_view json) {
    value = Value(json);
}

template <typename Step, typename... Rows>
Step step_in(std::string_view json, FieldTable<Rows...> /*table*/) {
    Step step;
    JsonScanner fields(json);
    while (fields.next_field()) {
        const auto set_if_named = [&](auto row) {
            const bool is_it = fields.key() == row.name;
            if (is_it)
                set(row.in(step), fields.value());
            return is_it;
        };
        (set_if_named(Rows{}) || ...);
    }
    return step;
}

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

std::optional<Rational> TracedNumber::exact() const {
    const auto number = number_of(text());
    return number ? std::optional(number->exact()) : std::nullopt;
}

std::optional<double> TracedNumber::nearest_double() const {
    const auto number = number_of(text());
    return number ? std::optional(number->nearest_double()) : std::nullopt;
}

std::string_view word_of(PrimitiveKind kind) {
    return name_of(kind);
}

std::string_view word_of(Space space) {
    constexpr std::array<std::string_view, 6> words{"object", "world",     "camera",
                                                    "clip",   "canonical", "screen"};
    return words[static_cast<std::size_t>(space)];
}

std::string_view word_of(Move move) {
    constexpr std::array<std::string_view, 8> words{"E", "NE", "N", "NW", "W", "SW", "S", "SE"};
    return words[static_cast<std::size_t>(move)];
}

std::string_view word_of(SkipReason reason) {
    constexpr std::array<std::string_view, 9> words{
        "off canvas", "between rows",     "zero area",
        "culled",     "behind the eye",   "too near",
        "too far",    "outside the view", "its only pixel is its last, which is left out"};
    return words[static_cast<std::size_t>(reason)];
}

std::span<const StepField> fields_of(StepKind kind) {
    return fields_of(kind, std::make_index_sequence<step_kinds>{});
}

TracedText name_in(const StepView& step) {
    const auto name = step.plain_pixel() == nullptr ? step.field("name") : std::nullopt;
    return name ? TracedText(*name) : TracedText();
}

std::optional<Index> x_in(const StepView& step) {
    return step.whole("x");
}

std::optional<Index> y_in(const StepView& step) {
    return step.whole("y");
}

template <typename Step> Step StepView::as() const {
    return step_in<Step>(json(), typename Step::Fields{});
}

template <> PixelStep StepView::as() const {
    if (is_pixel_)
        return {.x = pixel_.x, .y = pixel_.y, .color = {}};
    return step_in<PixelStep>(json_, PixelStep::Fields{});
}

template TriangulateStep StepView::as() const;
template MatrixStep StepView::as() const;
template VertexStep StepView::as() const;
template OrderStep StepView::as() const;
template PrimitiveStep StepView::as() const;
template FaceStep StepView::as() const;
template LightStep StepView::as() const;
template ClipStep StepView::as() const;
template EdgeStep StepView::as() const;
template HalfStep StepView::as() const;
template RayStep StepView::as() const;
template ScanlineStep StepView::as() const;
template AlongStep StepView::as() const;
template DecideStep StepView::as() const;
template SampleStep StepView::as() const;
template DepthStep StepView::as() const;
template RejectStep StepView::as() const;
template SkipStep StepView::as() const;
template UndecidedStep StepView::as() const;

} // namespace rastertrace
