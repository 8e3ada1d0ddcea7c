// SPDX-License-Identifier: MIT
#include "claim_comparison.h"

#include "typed_number.h"

#include <rastertrace/core/numbers/irrational.h>
#include <rastertrace/core/numbers/number.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/color_text.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

namespace rastertrace {

namespace {

/// How a claimed number is the true one, which lies within `error` of `truth`.
Fit fit_of(const TypedValue& claimed, const Rational& truth, const Rational& error) {
    const Rational difference = abs(claimed.value - truth);
    if (difference <= error)
        return Fit::exact;
    constexpr int most_places = 1000; // more than anybody writes
    const int places = claimed.places.value_or(0);
    const bool has_digits = sgn(claimed.value) != 0 || claimed.is_rounded; // 0.00 is 0
    if (!claimed.places || std::abs(places) > most_places || !has_digits)
        return Fit::none;
    mpz_class digits;
    mpz_ui_pow_ui(digits.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(places)));
    const Rational power = places < 0 ? Rational(1, digits) : Rational(digits);
    if (2 * (difference - error) * power <= 1)
        return Fit::rounded;
    // Toward 0; a number that may be a whole one is not cut off.
    const Rational scaled = (abs(truth) + error) * power;
    const mpz_class cut = scaled.get_num() / scaled.get_den();
    return abs(claimed.value) * power == cut && sgn(claimed.value) * sgn(truth) >= 0
               ? Fit::truncated
               : Fit::none;
}

/// True if two numbers are one as far as numbers that are no fractions tell.
bool is_near(const Rational& a, const Rational& b, NumbersHeld held) {
    if (held == NumbersHeld::fractions || held == NumbersHeld::many_digits)
        return false;
    const double last_bits = held == NumbersHeld::floats ? 1e-6 : 1e-14;
    const double difference = std::abs(nearest_double(a - b));
    return difference <= last_bits * std::abs(nearest_double(b));
}

void compare_one(Comparison& comparison, const std::string& claimed, const std::string& told,
                 NumbersHeld held) {
    if (claimed == open_value)
        return;
    comparison.is_open = false;
    const auto number = typed_value(claimed);
    const auto truth = number_in(told);
    if (!number || !truth) {
        const auto color = parse_color(claimed);
        const bool is_same = claimed == told || (color && color == parse_color(told));
        comparison.is_right = comparison.is_right && is_same;
        return;
    }
    const bool has_roots = held == NumbersHeld::many_digits || !number->is_exact;
    const Rational error = has_roots ? root_tolerance(*truth) : Rational(0);
    Fit fit = is_near(number->value, *truth, held) ? Fit::exact : fit_of(*number, *truth, error);
    if (fit == Fit::truncated && number->goes_on)
        fit = Fit::rounded; // its author says that it goes on
    if (fit == Fit::none)
        comparison.is_right = false;
    if (fit != Fit::exact)
        comparison.places = std::max(comparison.places, number->places.value_or(0));
    comparison.fit = std::max(comparison.fit, fit);
}

std::optional<Rational> value_of_claim(const std::string& text) {
    const auto typed = typed_value(text);
    return typed ? std::optional(typed->value) : std::nullopt;
}

} // namespace

Rational root_tolerance(const Rational& number) {
    return (abs(number) + 1) / Rational(mpz_class(1) << (many_binary_digits / 2));
}

bool is_by_place(const ClaimedField& field) {
    return field.is_list && (field.name == "d" || field.name == "pixels" || field.name == "rows");
}

Comparison compare(const ClaimedField& claimed, const std::vector<std::string>& told,
                   NumbersHeld held, bool may_lack_z) {
    Comparison comparison;
    const std::size_t count = claimed.values.size();
    comparison.is_right = count == told.size() || (is_by_place(claimed) && count < told.size()) ||
                          (may_lack_z && count == 2 && told.size() == 3 && told[2] == "0");
    for (std::size_t i = 0; i < count; ++i)
        compare_one(comparison, claimed.values[i], i < told.size() ? told[i] : std::string(), held);
    return comparison;
}

Values claimed_values(const ClaimedField& field, const std::vector<std::string>& told) {
    Values values;
    for (std::size_t i = 0; i < std::max(field.values.size(), told.size()); ++i) {
        const bool is_claimed = i < field.values.size() && field.values[i] != open_value;
        const std::string& text = is_claimed        ? field.values[i]
                                  : i < told.size() ? told[i]
                                                    : field.name;
        const auto number = text == "true"    ? std::optional(Rational(1))
                            : text == "false" ? std::optional(Rational(0))
                                              : value_of_claim(text);
        if (!number)
            return {};
        values.push_back(*number);
    }
    return values;
}

bool are_consecutive(const std::vector<std::string>& numbers) {
    return std::adjacent_find(numbers.begin(), numbers.end(), [](const auto& a, const auto& b) {
               return number_in(b) != number_in(a).value_or(0) + 1;
           }) == numbers.end();
}

Values levels_in(std::string_view text) {
    const auto color = parse_color(text);
    return color ? Values{int{color->red()}, int{color->green()}, int{color->blue()}} : Values{};
}

bool gives(const Values& values, const ClaimedField& claimed) {
    if (claimed.name == "color")
        return values == levels_in(claimed.values.front());
    const std::size_t count = claimed.values.size();
    const bool lacks_only_z = count == 2 && values.size() == 3 && sgn(values[2]) == 0;
    const bool is_beginning = is_by_place(claimed) && count < values.size();
    if (count != values.size() && !lacks_only_z && !is_beginning)
        return false;
    for (std::size_t i = 0; i < claimed.values.size(); ++i) {
        const std::string& text = claimed.values[i];
        if (text == open_value)
            continue;
        if (text == "true" || text == "false") {
            if (values[i] != (text == "true" ? 1 : 0))
                return false;
            continue;
        }
        const auto number = typed_value(text);
        const Rational error =
            number && !number->is_exact ? root_tolerance(values[i]) : Rational(0);
        if (!number || fit_of(*number, values[i], error) == Fit::none)
            return false;
    }
    return true;
}

} // namespace rastertrace
