// SPDX-License-Identifier: MIT
#include "value_difference.h"

#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/json_scanner.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace rastertrace {

namespace {

/// The distance from a number to the next larger one that its type has.
template <typename Float> Rational ulp_of(const Rational& number) {
    const auto value = static_cast<Float>(std::abs(nearest_double(number)));
    const Float next = std::nextafter(value, std::numeric_limits<Float>::infinity());
    return std::isfinite(next) ? Rational(static_cast<double>(next) - static_cast<double>(value))
                               : Rational(0);
}

bool is_within(const DiffTolerance& tolerance, const Rational& a, const Rational& b) {
    return abs(a - b) <= tolerance.amount.exact();
}

/// True if two numbers are at most so many ulps apart, as the scalar has them.
bool is_within_ulps(const DiffTolerance& tolerance, const Rational& a, const Rational& b,
                    bool is_float) {
    const Rational larger = std::max<Rational>(abs(a), abs(b));
    const Rational ulp = is_float ? ulp_of<float>(larger) : ulp_of<double>(larger);
    return abs(a - b) <= tolerance.amount.exact() * ulp;
}

Differs differ_as_numbers(std::string_view json_a, const Rational& a, std::string_view json_b,
                          const Rational& b, const ValueComparison& by) {
    if (a == b)
        return std::nullopt;
    if (by.are_floats &&
        static_cast<float>(nearest_double(a)) == static_cast<float>(nearest_double(b)))
        return std::nullopt;
    if (by.tolerance != nullptr && by.tolerance->is_ulps &&
        is_within_ulps(*by.tolerance, as_stored(a, json_a, by.has_floats),
                       as_stored(b, json_b, by.has_floats), by.has_floats))
        return std::nullopt;
    if (by.tolerance != nullptr && !by.tolerance->is_ulps && is_within(*by.tolerance, a, b))
        return std::nullopt;
    const double distance = nearest_double(Rational(abs(a - b)));
    return std::isfinite(distance) ? ValueDifference{distance} : ValueDifference{};
}

Differs differ_as_lists(std::string_view a, std::string_view b, const ValueComparison& by) {
    JsonScanner in_a(a);
    JsonScanner in_b(b);
    Differs found;
    for (;;) {
        const bool has_a = in_a.next_element();
        const bool has_b = in_b.next_element();
        if (has_a != has_b)
            return ValueDifference{};
        if (!has_a)
            return found;
        const Differs here = differ(in_a.value(), in_b.value(), by);
        if (!here)
            continue;
        if (!found)
            found = here;
        else if (!here->distance || !found->distance)
            found->distance.reset();
        else
            found->distance = std::max(*found->distance, *here->distance);
    }
}

} // namespace

Differs differ(std::string_view a, std::string_view b, const ValueComparison& by) {
    if (a == b)
        return std::nullopt;
    if (a.starts_with('[') && b.starts_with('['))
        return differ_as_lists(a, b, by);
    const bool is_number = by.type ? by.type == FieldType::whole || by.type == FieldType::quantity
                                   : !a.starts_with('"') && !b.starts_with('"');
    const std::string text_a = plain_text(a);
    const std::string text_b = plain_text(b);
    if (is_number) {
        const auto number_a = number_in(text_a);
        const auto number_b = number_in(text_b);
        if (number_a && number_b)
            return differ_as_numbers(a, *number_a, b, *number_b, by);
    }
    const auto color_a = by.is_color ? parse_color(text_a) : std::nullopt;
    const auto color_b = by.is_color ? parse_color(text_b) : std::nullopt;
    const bool are_alike = (text_a == text_b && a.starts_with('"') == b.starts_with('"')) ||
                           (color_a && color_a == color_b);
    return are_alike ? std::nullopt : Differs(ValueDifference{});
}

} // namespace rastertrace
