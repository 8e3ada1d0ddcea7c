// SPDX-License-Identifier: MIT
#include "traced_steps.h"

#include "field_type.h"
#include "trace.h"

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/json_scanner.h>
#include <rastertrace/trace/text/primitive_name.h>

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>
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

/// The nearest double of "25/8" or "3", if above and below stand doubles: their division rounds once.
std::optional<double> quotient_rounded_once(std::string_view json) {
    constexpr Index exact_in_double = Index{1} << 53;
    const char* at = json.data() + (json.starts_with('"') ? 1 : 0);
    const char* const end = json.data() + json.size() - (json.ends_with('"') ? 1 : 0);
    const auto take_whole = [&at, end]() -> std::optional<double> {
        Index whole = 0;
        const auto read = std::from_chars(at, end, whole);
        at = read.ptr;
        if (read.ec != std::errc{} || whole < -exact_in_double || whole > exact_in_double)
            return std::nullopt;
        return static_cast<double>(whole);
    };
    const auto above = take_whole();
    if (above && at == end)
        return above;
    if (!above || *at++ != '/')
        return std::nullopt;
    const auto below = take_whole();
    return below && *below > 0 && at == end ? std::optional(*above / *below) : std::nullopt;
}

// The standard library for pages reads no floating-point numbers so.
template <typename Stored>
std::optional<double> stored_at_once([[maybe_unused]] std::string_view json) {
#ifdef __cpp_lib_to_chars
    Stored stored = 0;
    const char* const end = json.data() + json.size();
    const auto read = std::from_chars(json.data(), end, stored);
    const bool is_number = read.ec == std::errc() && read.ptr == end && std::isfinite(stored);
    if (is_number)
        return static_cast<double>(stored);
#endif
    return std::nullopt;
}

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

std::optional<Rational> TracedNumber::exact() const {
    const auto number = number_of(text());
    return number ? std::optional(number->exact()) : std::nullopt;
}

std::optional<double> TracedNumber::nearest_double() const {
    if (const auto quotient = quotient_rounded_once(json()))
        return quotient;
    constexpr double usual = 1e300; // others are looked at closely
    const auto stored = stored_double_in(json(), false);
    if (stored && (*stored == 0 || (1 / usual < std::abs(*stored) && std::abs(*stored) < usual)))
        return *stored + 0.0; // not -0
    const auto number = number_of(text());
    return number ? std::optional(number->nearest_double()) : std::nullopt;
}

std::optional<double> stored_double_in(std::string_view json, bool is_float) {
    return is_float ? stored_at_once<float>(json) : stored_at_once<double>(json);
}

std::string TracedValue::text() const {
    return plain_text(json_);
}

std::optional<Color> TracedColor::color() const {
    return parse_color(text());
}

std::vector<std::string_view> elements_of(std::string_view json) {
    std::vector<std::string_view> values;
    if (json.empty())
        return values;
    JsonScanner elements(json);
    while (elements.next_element())
        values.push_back(elements.value());
    return values;
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
    constexpr std::array<std::string_view, 10> words{
        "off canvas",
        "between rows",
        "zero area",
        "culled",
        "behind the eye",
        "too near",
        "too far",
        "outside the view",
        "its only pixel is its last, which is left out",
        "it leaves no diamond"};
    return words[static_cast<std::size_t>(reason)];
}

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

TracedText text_field(const StepView& step, std::string_view name) {
    const auto text = step.plain_pixel() == nullptr ? step.field(name) : std::nullopt;
    return text ? TracedText(*text) : TracedText();
}

std::optional<Index> whole_field(const StepView& step, std::string_view name) {
    const auto value = step.field(name);
    return value ? whole_in(*value) : std::nullopt;
}

} // namespace

TracedText name_in(const StepView& step) {
    return text_field(step, "name");
}

TracedText code_in(const StepView& step) {
    return text_field(step, key_of_code);
}

namespace {

/// Takes a whole number from the front of a text; of anything else, nothing.
std::optional<Index> take_whole(std::string_view& text) {
    Index number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc())
        return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

struct PlaceInStep {
    std::optional<Index> x; ///< a scanline has none
    Index y;
};

/// The pixel or row that a step begins with where StepWriter has written it; others are read as any JSON.
std::optional<PlaceInStep> leading_place(std::string_view json) {
    constexpr std::string_view before_x = R"(,"x":)";
    constexpr std::string_view before_y = R"(,"y":)";
    const std::size_t end_of_name = json.find('"', front_of_step.size());
    if (!json.starts_with(front_of_step) || end_of_name == std::string_view::npos)
        return std::nullopt;
    json.remove_prefix(end_of_name + 1);
    PlaceInStep place{};
    if (json.starts_with(before_x)) {
        json.remove_prefix(before_x.size());
        place.x = take_whole(json);
        if (!place.x)
            return std::nullopt;
    }
    if (!json.starts_with(before_y))
        return std::nullopt;
    json.remove_prefix(before_y.size());
    const auto y = take_whole(json);
    if (!y || (!json.starts_with(',') && !json.starts_with('}')))
        return std::nullopt;
    place.y = *y;
    return place;
}

} // namespace

std::optional<Index> x_in(const StepView& step) {
    if (const Pixel* const pixel = step.plain_pixel())
        return pixel->x;
    const auto place = leading_place(step.json());
    return place && place->x ? place->x : whole_field(step, "x");
}

std::optional<Index> y_in(const StepView& step) {
    if (const Pixel* const pixel = step.plain_pixel())
        return pixel->y;
    const auto place = leading_place(step.json());
    return place ? place->y : whole_field(step, "y");
}

} // namespace rastertrace
