// SPDX-License-Identifier: MIT
#include "traced_values.h"

#include "step_json.h"

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/json_scanner.h>
#include <rastertrace/trace/text/primitive_name.h>
#include <rastertrace/trace/text/text.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <system_error>

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

/// Where a string ends that begins at a quotation mark: behind the next one without a backslash.
const char* end_of_string(const char* at) {
    const char* const quote = std::strchr(at + 1, '"');
    if (quote[-1] != '\\') // nearly always
        return quote + 1;
    while (*++at != '"')
        at += *at == '\\' ? 1 : 0;
    return at + 1;
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

} // namespace

std::string TracedNumber::json() const {
    return step_json_parts::json_of(*this);
}

std::string TracedNumber::text() const {
    return plain_text(json());
}

std::optional<Rational> TracedNumber::exact() const {
    if (form_ == Form::fraction)
        return rastertrace::exact(Fraction64{whole_, more_});
    if (form_ == Form::whole)
        return Rational(whole_);
    const auto number = number_of(text());
    return number ? std::optional(number->exact()) : std::nullopt;
}

std::optional<double> TracedNumber::nearest_double() const {
    if (form_ == Form::real)
        return real_ + 0.0; // not -0
    const std::string json = this->json();
    if (const auto quotient = quotient_rounded_once(json))
        return quotient;
    constexpr double usual = 1e300; // others are looked at closely
    const auto stored = stored_at_once<double>(json);
    if (stored && (*stored == 0 || (1 / usual < std::abs(*stored) && std::abs(*stored) < usual)))
        return *stored + 0.0;
    const auto number = number_of(plain_text(json));
    return number ? std::optional(number->nearest_double()) : std::nullopt;
}

std::optional<double> TracedNumber::stored_double(bool is_float) const {
    if (is_float)
        return stored_at_once<float>(json());
    return form_ == Form::real ? std::optional(real_) : stored_at_once<double>(json());
}

std::string_view TracedValue::json() const {
    if (json_ == nullptr)
        return {};
    const char* end = json_;
    if (*json_ == '"')
        end = end_of_string(json_);
    else // a number or a list, of a foreign rasterizer
        for (int depth = 0; depth > 0 || std::strchr(",]} \t\r\n", *end) == nullptr;) {
            depth += *end == '[' || *end == '{' ? 1 : *end == ']' || *end == '}' ? -1 : 0;
            end = *end == '"' ? end_of_string(end) : end + 1;
        }
    return {json_, static_cast<std::size_t>(end - json_)};
}

std::string TracedValue::text() const {
    return plain_text(json());
}

std::string TracedColor::json() const {
    return step_json_parts::json_of(*this);
}

std::string TracedColor::text() const {
    return plain_text(json());
}

std::optional<Color> TracedColor::color() const {
    return form_ == Form::color ? std::optional(color_) : parse_color(text());
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

std::string_view quoted_word_of(PrimitiveKind kind) {
    static const auto words = [] {
        std::array<std::string, all_primitives.size()> quoted;
        for (const PrimitiveKind one : all_primitives)
            quoted[static_cast<std::size_t>(one)] = json_quoted(name_of(one));
        return quoted;
    }();
    return words[static_cast<std::size_t>(kind)];
}

std::string_view quoted_word_of(Space space) {
    constexpr std::array<std::string_view, 6> words{R"("object")", R"("world")",     R"("camera")",
                                                    R"("clip")",   R"("canonical")", R"("screen")"};
    return words[static_cast<std::size_t>(space)];
}

std::string_view quoted_word_of(Move move) {
    constexpr std::array<std::string_view, 8> words{R"("E")", R"("NE")", R"("N")", R"("NW")",
                                                    R"("W")", R"("SW")", R"("S")", R"("SE")"};
    return words[static_cast<std::size_t>(move)];
}

std::string_view quoted_word_of(SkipReason reason) {
    constexpr std::array<std::string_view, 10> words{
        R"("off canvas")",
        R"("between rows")",
        R"("zero area")",
        R"("culled")",
        R"("behind the eye")",
        R"("too near")",
        R"("too far")",
        R"("outside the view")",
        R"("its only pixel is its last, which is left out")",
        R"("it leaves no diamond")"};
    return words[static_cast<std::size_t>(reason)];
}

} // namespace rastertrace
