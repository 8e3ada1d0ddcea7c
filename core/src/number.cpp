// SPDX-License-Identifier: MIT
#include <rastertrace/core/numbers/conversion.h>

#include <charconv>
#include <string>
#include <system_error>

namespace rastertrace {

double nearest_double(const mpq_class& value) {
    if (abs(value) > std::numeric_limits<double>::max())
        return sgn(value) * std::numeric_limits<double>::infinity();

    // get_d rounds toward zero: the nearest double is this one or its neighbor away from zero.
    const double infinity = std::numeric_limits<double>::infinity();
    const double inner = value.get_d();
    const double outer = std::nextafter(inner, sgn(value) < 0 ? -infinity : infinity);
    if (!std::isfinite(outer))
        return inner;
    const int nearer =
        cmp(mpq_class(abs(value - mpq_class(inner))), mpq_class(abs(mpq_class(outer) - value)));
    if (nearer != 0)
        return nearer < 0 ? inner : outer;
    // Neighbors differ by one in the last bit of the significand, the lowest bit of their encoding.
    return std::bit_cast<std::uint64_t>(inner) % 2 == 0 ? inner : outer;
}

double nearest_quotient(std::int64_t above, std::int64_t below) {
    return nearest_double(exact(Fraction64{above, below}));
}

float nearest_float(const mpq_class& value) {
    // A double halfway between two floats, whose last bit is 0, may have been rounded to there: it
    // is moved back to the side of the exact value before it is rounded again.
    const double near = nearest_double(value);
    const bool is_odd = std::bit_cast<std::uint64_t>(near) % 2 == 1;
    if (!std::isfinite(near) || is_odd || mpq_class(near) == value)
        return static_cast<float>(near);
    const double limit = std::numeric_limits<double>::infinity();
    return static_cast<float>(std::nextafter(near, mpq_class(near) > value ? -limit : limit));
}

std::optional<std::int64_t> denominator_of(const mpq_class& value) {
    if (!value.get_den().fits_slong_p())
        return std::nullopt;
    return value.get_den().get_si();
}

std::optional<std::int64_t> nearest_numerator(const mpq_class& value, std::int64_t denominator) {
    const mpq_class doubled = value * mpz_class(denominator) * 2 + 1;
    const mpz_class below = doubled.get_den() * 2;
    mpz_class nearest;
    mpz_fdiv_q(nearest.get_mpz_t(), doubled.get_num_mpz_t(), below.get_mpz_t());
    if (mpz_sizeinbase(nearest.get_mpz_t(), 2) > 62)
        return std::nullopt;
    return nearest.get_si();
}

namespace {

/// Whole numbers up to this one are doubles.
constexpr std::int64_t exact_in_double = std::int64_t{1} << 53;

constexpr bool is_within(std::int64_t whole, std::int64_t limit) {
    return -limit <= whole && whole <= limit;
}

/// The Real nearest to digits x 10^exponent, if digits and power of ten are Reals: an operation on
/// them rounds once (Clinger 1990).
template <typename Real> std::optional<Real> rounded_once(std::int64_t digits, int exponent) {
    constexpr bool is_float = std::same_as<Real, float>;
    if (!is_within(digits, is_float ? std::int64_t{1} << 24 : exact_in_double) ||
        !is_within(exponent, is_float ? 10 : 18))
        return std::nullopt;
    const auto whole = static_cast<Real>(digits);
    const auto power = static_cast<Real>(power_of_ten(std::abs(exponent)));
    return exponent < 0 ? whole / power : whole * power;
}

/// digits x 10^exponent.
mpq_class decimal_value(const mpz_class& digits, std::int64_t exponent) {
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(exponent)));
    mpq_class value = digits;
    if (exponent >= 0)
        value *= power;
    else
        value /= power;
    return value;
}

} // namespace

mpq_class Number::exact() const {
    return is_fraction() ? *held_.fraction : decimal_value(held_.digits, exponent_);
}

double Number::nearest_double() const {
    if (is_fraction())
        return rastertrace::nearest_double(*held_.fraction);
    if (const auto nearest = rounded_once<double>(held_.digits, exponent_))
        return *nearest;
    const std::string text = std::to_string(held_.digits) + "e" + std::to_string(exponent_);
    double value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

bool Number::is_exactly(double value) const {
    // A decimal was divided by a power of ten that is a double: is anything left over?
    if (-18 <= exponent_ && exponent_ <= 0) {
        const auto power = static_cast<double>(power_of_ten(-exponent_));
        const auto digits = static_cast<double>(held_.digits);
        return is_within(held_.digits, exact_in_double) && std::fma(value, power, -digits) == 0;
    }
    return std::isfinite(value) && mpq_class(value) == exact();
}

float Number::nearest_float() const {
    if (!is_fraction())
        if (const auto nearest = rounded_once<float>(held_.digits, exponent_))
            return *nearest;
    return rastertrace::nearest_float(exact());
}

std::optional<std::int64_t> Number::denominator() const {
    if (is_fraction())
        return denominator_of(*held_.fraction);
    if (exponent_ < -18)
        return std::nullopt;
    return exponent_ >= 0 ? 1 : power_of_ten(-exponent_);
}

std::optional<std::int64_t> Number::numerator_over(std::int64_t denominator) const {
    if (is_fraction()) {
        const mpq_class scaled = *held_.fraction * mpz_class(denominator);
        if (scaled.get_den() != 1 || !scaled.get_num().fits_slong_p())
            return std::nullopt;
        return scaled.get_num().get_si();
    }
    const auto own = this->denominator();
    if (!own || denominator % *own != 0 || exponent_ > 18)
        return std::nullopt;
    std::int64_t factor = denominator / *own;
    if (exponent_ > 0 && __builtin_mul_overflow(factor, power_of_ten(exponent_), &factor))
        return std::nullopt;
    std::int64_t numerator = 0;
    if (__builtin_mul_overflow(held_.digits, factor, &numerator))
        return std::nullopt;
    return numerator;
}

namespace {

using number_text::take;
using number_text::take_digits;
using Parsed = std::variant<Number, NumberFault>;

/// A number whose text has the right form: is it in the range of double?
std::optional<NumberFault> fault_of_size(const mpq_class& value) {
    static const mpq_class largest(std::numeric_limits<double>::max());
    static const mpq_class smallest(std::numeric_limits<double>::denorm_min());
    if (abs(value) > largest)
        return NumberFault::too_large;
    if (sgn(value) != 0 && abs(value) < smallest)
        return NumberFault::too_small;
    return std::nullopt;
}

/// A fraction, brought to lowest terms: its sign, and what stands before and behind the bar.
Parsed parse_fraction(bool is_negative, std::string_view above, std::string_view below,
                      NumberSize size) {
    const std::string_view digits = take_digits(below);
    if (digits.empty() || !below.empty())
        return NumberFault::malformed;
    const mpz_class denominator(std::string(digits), 10);
    if (denominator == 0)
        return NumberFault::zero_denominator;
    mpq_class value(mpz_class(std::string(above), 10), denominator);
    value.canonicalize();
    if (is_negative)
        value = -value;
    if (size == NumberSize::of_double)
        if (const auto fault = fault_of_size(value))
            return *fault;
    if (value.get_den() == 1 && value.get_num().fits_slong_p())
        return Number(value.get_num().get_si());
    return Number::fraction(std::move(value));
}

/// digits x 10^exponent without zeros at the ends: 0007.50 is 75 x 10^-1. 0 has no digits.
struct DecimalText {
    std::string digits;
    std::int64_t exponent;
};

/// The exponent that `text` begins with, behind its e. It is clamped to 32 bits: too large anyway.
std::optional<std::int64_t> take_exponent(std::string_view& text) {
    const bool is_negative = take(text, '-');
    if (!is_negative)
        take(text, '+');
    const std::string_view digits = take_digits(text);
    if (digits.empty())
        return std::nullopt;
    std::int32_t exponent = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    if (read.ec == std::errc::result_out_of_range)
        exponent = std::numeric_limits<std::int32_t>::max();
    return is_negative ? -std::int64_t{exponent} : exponent;
}

/// A decimal without its sign: `whole` is before the point. `nullopt` if it is malformed.
std::optional<DecimalText> decimal_text(std::string_view whole, std::string_view rest) {
    std::string_view fraction;
    if (take(rest, '.')) {
        fraction = take_digits(rest);
        if (fraction.empty())
            return std::nullopt;
    }
    std::optional<std::int64_t> exponent = 0;
    if (take(rest, 'e') || take(rest, 'E'))
        exponent = take_exponent(rest);
    if (!exponent || !rest.empty())
        return std::nullopt;

    const std::string digits = std::string(whole) + std::string(fraction);
    const std::size_t first = digits.find_first_not_of('0');
    if (first == std::string::npos)
        return DecimalText{};
    const std::size_t end = digits.find_last_not_of('0') + 1;
    return DecimalText{digits.substr(first, end - first),
                       *exponent - static_cast<std::int64_t>(fraction.size()) +
                           static_cast<std::int64_t>(digits.size() - end)};
}

Parsed parse_decimal(bool is_negative, const DecimalText& text) {
    const auto& [digits, exponent] = text;
    if (digits.empty())
        return Number(0);

    // The decimal point of 1.797e308 stands 309 digits right of its first digit. Beyond that, and
    // below 1e-324, the size is clear without writing the power of ten out.
    const std::int64_t places = exponent + static_cast<std::int64_t>(digits.size());
    if (places > 309)
        return NumberFault::too_large;
    if (places < -323)
        return NumberFault::too_small;

    if (digits.size() <= 18 && -307 <= places && places <= 308) {
        std::int64_t value = 0;
        std::from_chars(digits.data(), digits.data() + digits.size(), value);
        return Number::decimal(is_negative ? -value : value, static_cast<int>(exponent));
    }
    mpq_class value = decimal_value(mpz_class(digits, 10), exponent);
    if (const auto fault = fault_of_size(value))
        return *fault;
    return Number::fraction(is_negative ? mpq_class(-value) : value);
}

} // namespace

Parsed parse_number(std::string_view text, NumberSize size) {
    if (size == NumberSize::of_double && text.size() > longest_number)
        return NumberFault::too_long;

    std::string_view rest = text;
    const bool is_negative = take(rest, '-');
    const std::string_view whole = take_digits(rest);
    if (whole.empty())
        return NumberFault::malformed;
    if (take(rest, '/'))
        return parse_fraction(is_negative, whole, rest, size);

    // A whole number that only an exact result can be.
    if (size == NumberSize::any && rest.empty() && whole.size() > 309)
        return Number::fraction(mpz_class(std::string(text), 10));

    const auto decimal = decimal_text(whole, rest);
    return decimal ? parse_decimal(is_negative, *decimal) : NumberFault::malformed;
}

} // namespace rastertrace
