// SPDX-License-Identifier: MIT
#include <rastertrace/core/numbers/number.h>

#include <rastertrace/core/numbers/fraction.h>
#include <rastertrace/core/numbers/rational.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <system_error>
#include <utility>

namespace rastertrace {

double nearest_double(const mpq_class& value) {
    if (abs(value) > std::numeric_limits<double>::max())
        return sgn(value) * std::numeric_limits<double>::infinity();

    // mpq_get_d rounds toward zero, so the nearest double is this one or its neighbor away from
    // zero.
    const double inner = value.get_d();
    const double outer = std::nextafter(
        inner, std::copysign(std::numeric_limits<double>::infinity(), sgn(value) < 0 ? -1.0 : 1.0));
    if (!std::isfinite(outer))
        return inner;
    const mpq_class to_inner = abs(value - mpq_class(inner));
    const mpq_class to_outer = abs(mpq_class(outer) - value);
    const int nearer = cmp(to_inner, to_outer);
    if (nearer != 0)
        return nearer < 0 ? inner : outer;
    // Neighbors differ by one in the last bit of the significand, the lowest bit of their encoding.
    return std::bit_cast<std::uint64_t>(inner) % 2 == 0 ? inner : outer;
}

double nearest_quotient(Int128 above, Int128 below) {
    return nearest_double(exact(Fraction128{above, below}));
}

float nearest_float(const mpq_class& value) {
    // The nearest double is rounded already: where it lies halfway between two floats, the exact
    // value may lie on either side, and is nudged back there before it is rounded again.
    double near = nearest_double(value);
    if (std::isfinite(near) && mpq_class(near) != value) {
        const double limit = std::numeric_limits<double>::infinity();
        const bool was_rounded_up = mpq_class(near) > value;
        const bool is_odd = std::bit_cast<std::uint64_t>(near) % 2 == 1;
        if (!is_odd)
            near = std::nextafter(near, was_rounded_up ? -limit : limit);
    }
    return static_cast<float>(near);
}

mpq_class Number::exact() const {
    if (is_fraction())
        return *held_.fraction;
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(exponent_)));
    mpq_class value = mpz_class(held_.digits);
    if (exponent_ >= 0)
        value *= power;
    else
        value /= power;
    return value;
}

double Number::nearest_double() const {
    if (is_fraction())
        return rastertrace::nearest_double(*held_.fraction);
    // Digits below 2^53 and powers of ten up to 10^22 are doubles, so one operation on them
    // rounds once (Clinger 1990). Everything else is left to from_chars, which rounds
    // correctly.
    constexpr std::int64_t exact_digits = std::int64_t{1} << 53;
    if (-exact_digits <= held_.digits && held_.digits <= exact_digits && -18 <= exponent_ &&
        exponent_ <= 18) {
        const auto digits = static_cast<double>(held_.digits);
        const auto power = static_cast<double>(power_of_ten(std::abs(exponent_)));
        return exponent_ < 0 ? digits / power : digits * power;
    }
    const std::string text = std::to_string(held_.digits) + "e" + std::to_string(exponent_);
    double value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

bool Number::is_exactly(double value) const {
    // What is no fraction was divided by a power of ten that is a double: with nothing left over?
    if (-18 <= exponent_ && exponent_ <= 0) {
        const auto power = static_cast<double>(power_of_ten(-exponent_));
        constexpr std::int64_t exact_digits = std::int64_t{1} << 53;
        const auto digits = static_cast<double>(held_.digits);
        return -exact_digits <= held_.digits && held_.digits <= exact_digits &&
               std::fma(value, power, -digits) == 0;
    }
    return std::isfinite(value) && mpq_class(value) == exact();
}

float Number::nearest_float() const {
    // As above: digits below 2^24 and powers of ten up to 10^10 are floats.
    constexpr std::int64_t exact_digits = std::int64_t{1} << 24;
    if (!is_fraction() && -exact_digits <= held_.digits && held_.digits <= exact_digits &&
        -10 <= exponent_ && exponent_ <= 10) {
        const auto digits = static_cast<float>(held_.digits);
        const auto power = static_cast<float>(power_of_ten(std::abs(exponent_)));
        return exponent_ < 0 ? digits / power : digits * power;
    }
    return rastertrace::nearest_float(exact());
}

std::optional<std::int64_t> Number::denominator() const {
    if (is_fraction()) {
        if (!held_.fraction->get_den().fits_slong_p())
            return std::nullopt;
        return held_.fraction->get_den().get_si();
    }
    if (exponent_ < -18)
        return std::nullopt;
    return exponent_ >= 0 ? 1 : power_of_ten(-exponent_);
}

std::optional<std::int64_t> Number::numerator_over(std::int64_t denominator) const {
    std::int64_t numerator = 0;
    if (!is_fraction()) {
        const auto own = this->denominator();
        if (!own || denominator % *own != 0 || exponent_ > 18)
            return std::nullopt;
        const std::int64_t factor = exponent_ >= 0 ? power_of_ten(exponent_) : denominator / *own;
        if (__builtin_mul_overflow(held_.digits, factor, &numerator))
            return std::nullopt;
        if (exponent_ >= 0 && __builtin_mul_overflow(numerator, denominator, &numerator))
            return std::nullopt;
        return numerator;
    }
    const mpq_class scaled = *held_.fraction * mpz_class(denominator);
    if (scaled.get_den() != 1 || !scaled.get_num().fits_slong_p())
        return std::nullopt;
    return scaled.get_num().get_si();
}

std::optional<std::int64_t> Number::nearest_numerator_over(std::int64_t denominator) const {
    const mpq_class doubled = exact() * mpz_class(denominator) * 2 + 1;
    const mpz_class below = doubled.get_den() * 2;
    mpz_class nearest;
    mpz_fdiv_q(nearest.get_mpz_t(), doubled.get_num_mpz_t(), below.get_mpz_t());
    if (mpz_sizeinbase(nearest.get_mpz_t(), 2) > 62)
        return std::nullopt;
    return nearest.get_si();
}

namespace {

/// A value that is known to have the form of a number: in the range of double?
std::optional<NumberFault> fault_of_size(const mpq_class& value) {
    static const mpq_class largest(std::numeric_limits<double>::max());
    static const mpq_class smallest(std::numeric_limits<double>::denorm_min());
    if (abs(value) > largest)
        return NumberFault::too_large;
    if (sgn(value) != 0 && abs(value) < smallest)
        return NumberFault::too_small;
    return std::nullopt;
}

} // namespace

std::variant<Number, NumberFault> parse_number(std::string_view text, NumberSize size) {
    using namespace number_text;

    if (size == NumberSize::of_double && text.size() > longest_number)
        return NumberFault::too_long;

    // The sign and the digits before the point or the bar.
    std::string_view rest = text;
    const bool negative = take(rest, '-');
    const std::string_view whole = take_digits(rest);
    if (whole.empty())
        return NumberFault::malformed;

    // A fraction: numerator/denominator, brought to lowest terms.
    if (take(rest, '/')) {
        const std::string_view below = take_digits(rest);
        if (below.empty() || !rest.empty())
            return NumberFault::malformed;
        const mpz_class denominator(std::string(below), 10);
        if (denominator == 0)
            return NumberFault::zero_denominator;
        mpq_class value(mpz_class(std::string(whole), 10), denominator);
        value.canonicalize();
        if (negative)
            value = -value;
        if (size == NumberSize::of_double)
            if (const auto fault = fault_of_size(value))
                return *fault;
        if (value.get_den() == 1 && value.get_num().fits_slong_p())
            return Number(value.get_num().get_si());
        return Number::fraction(std::move(value));
    }

    // A whole number that only an exact result can be.
    if (size == NumberSize::any && rest.empty() && whole.size() > 309) {
        const mpq_class value(mpz_class(std::string(whole), 10));
        return Number::fraction(negative ? mpq_class(-value) : value);
    }

    // A decimal: whole.fraction e exponent.
    std::string_view fraction;
    if (take(rest, '.')) {
        fraction = take_digits(rest);
        if (fraction.empty())
            return NumberFault::malformed;
    }
    bool negative_exponent = false;
    std::string_view exponent_digits;
    if (take(rest, 'e') || take(rest, 'E')) {
        negative_exponent = take(rest, '-');
        if (!negative_exponent)
            take(rest, '+');
        exponent_digits = take_digits(rest);
        if (exponent_digits.empty())
            return NumberFault::malformed;
    }
    if (!rest.empty())
        return NumberFault::malformed;

    // Only the significant digits count: 0007.50 is 75 x 10^-1.
    std::string digits = std::string(whole) + std::string(fraction);
    std::int64_t exponent = 0;
    const auto read = std::from_chars(exponent_digits.data(),
                                      exponent_digits.data() + exponent_digits.size(), exponent);
    constexpr std::int64_t largest_exponent = std::numeric_limits<std::int32_t>::max();
    if (read.ec == std::errc::result_out_of_range || exponent > largest_exponent)
        exponent = largest_exponent;
    exponent =
        (negative_exponent ? -exponent : exponent) - static_cast<std::int64_t>(fraction.size());
    const std::size_t first = digits.find_first_not_of('0');
    if (first == std::string::npos)
        return Number(0);
    const std::size_t last = digits.find_last_not_of('0');
    exponent += static_cast<std::int64_t>(digits.size() - 1 - last);
    digits = digits.substr(first, last + 1 - first);

    // The decimal point of 1.797e308 stands 309 places from the right of its first digit. Beyond
    // that, and below 1e-324, the size is clear without writing the power of ten out.
    const std::int64_t places = exponent + static_cast<std::int64_t>(digits.size());
    if (places > 309)
        return NumberFault::too_large;
    if (places < -323)
        return NumberFault::too_small;

    if (digits.size() <= 18 && -307 <= places && places <= 308) {
        std::int64_t value = 0;
        std::from_chars(digits.data(), digits.data() + digits.size(), value);
        return Number::decimal(negative ? -value : value, static_cast<int>(exponent));
    }
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(exponent)));
    mpq_class value(mpz_class(digits, 10));
    if (exponent >= 0)
        value *= power;
    else
        value /= power;
    if (negative)
        value = -value;
    if (const auto fault = fault_of_size(value))
        return *fault;
    return Number::fraction(std::move(value));
}

} // namespace rastertrace
