// SPDX-License-Identifier: MIT
#pragma once

// A number exactly as the author of a scene typed it: a decimal or a fraction. It becomes a Scalar
// only when drawing starts, so that 0.1 is 1/10 in exact arithmetic.
//
//     const auto slope = parse_number("25/8");   // a Number, or what is wrong with the text
//     std::get<Number>(slope).nearest_double();  // 3.125

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

namespace rastertrace {

/// 1, 10, 100, ... 10^18.
inline constexpr auto powers_of_ten = [] {
    std::array<std::int64_t, 19> powers{1};
    for (std::size_t i = 1; i < powers.size(); ++i)
        powers[i] = 10 * powers[i - 1];
    return powers;
}();

/// 10^exponent, for 0 <= exponent <= 18.
constexpr std::int64_t power_of_ten(int exponent) {
    return powers_of_ten[static_cast<std::size_t>(exponent)];
}

/// The double nearest to an exact value; ties go to the even significand, as in IEEE 754. Beyond
/// the largest double there is only infinity.
double nearest_double(const mpq_class& value);

/// The same for float.
float nearest_float(const mpq_class& value);

/// The denominator of a fraction in lowest terms, if it fits.
std::optional<std::int64_t> denominator_of(const mpq_class& value);

/// value * denominator, rounded to the nearest whole number (a half up), if it is below 2^62.
std::optional<std::int64_t> nearest_numerator(const mpq_class& value, std::int64_t denominator);

/// A decimal of up to 18 digits is held in place, as digits x 10^exponent; any other number as a
/// fraction in lowest terms on the heap. Every Number is finite and lies in the range of double.
/// It takes 16 bytes: a model has hundreds of thousands.
class Number {
public:
    /// A whole number.
    Number(std::int64_t whole = 0) : held_{whole} {} // NOLINT: numbers are written as numbers

    Number(const Number& other) : held_(other.held_), exponent_(other.exponent_) {
        if (other.is_fraction())
            held_.fraction = new mpq_class(*other.held_.fraction);
    }
    Number(Number&& other) noexcept : Number() { swap(other); }
    Number& operator=(Number other) noexcept {
        swap(other);
        return *this;
    }
    ~Number() {
        if (is_fraction())
            delete held_.fraction;
    }

    /// digits x 10^exponent.
    struct Decimal {
        std::int64_t digits;
        int exponent;
    };
    /// A number of up to 18 digits.
    static Number decimal(std::int64_t digits, int exponent) {
        Number number(digits);
        number.exponent_ = digits == 0 ? 0 : exponent;
        return number;
    }

    /// A fraction; its denominator must be positive and it must be in lowest terms.
    static Number fraction(mpq_class value) {
        Number number;
        number.held_.fraction = new mpq_class(std::move(value));
        number.exponent_ = fraction_instead;
        return number;
    }

    /// The decimal that is held in place, if it is.
    std::optional<Decimal> as_decimal() const {
        return is_fraction() ? std::nullopt : std::optional(Decimal{held_.digits, exponent_});
    }

    /// The value, exactly.
    mpq_class exact() const;

    /// The nearest double, ties to even.
    double nearest_double() const;

    /// True if the number is this double, and not just near it.
    bool is_exactly(double value) const;

    /// The nearest float, ties to even; beyond the largest float there is only infinity.
    float nearest_float() const;

    /// A denominator that the value can be written over, if it fits: 10^3 for 0.250.
    std::optional<std::int64_t> denominator() const;

    /// value * denominator, if that is a whole number that fits.
    std::optional<std::int64_t> numerator_over(std::int64_t denominator) const;

    /// Equal values, however they were typed.
    friend bool operator==(const Number& a, const Number& b) {
        if (!a.is_fraction() && !b.is_fraction() && a.exponent_ == b.exponent_)
            return a.held_.digits == b.held_.digits;
        return a.exact() == b.exact();
    }

private:
    bool is_fraction() const { return exponent_ == fraction_instead; }

    void swap(Number& other) {
        std::swap(held_, other.held_);
        std::swap(exponent_, other.exponent_);
    }

    /// Stands for the exponent where there is a fraction; that of a decimal is far smaller.
    static constexpr std::int32_t fraction_instead = std::numeric_limits<std::int32_t>::max();

    union Held {
        std::int64_t digits;
        const mpq_class* fraction;
    };
    Held held_;
    std::int32_t exponent_ = 0;
};

/// What can be wrong with the text of a number.
enum class NumberFault {
    malformed,        ///< neither a decimal nor a fraction
    zero_denominator, ///< "1/0"
    too_large,        ///< beyond the largest double, 1.797...e308
    too_small,        ///< not 0, and nearer to 0 than the smallest double, 4.94...e-324
    too_long,         ///< of more characters than longest_number
};

/// The most characters of a number of a scene. Every double can be written out in fewer; exact
/// arithmetic on much longer numbers would be slow at every pixel.
inline constexpr std::size_t longest_number = 1200;

namespace number_text {

inline bool is_digit(char c) {
    return '0' <= c && c <= '9';
}

/// Takes the digits at the front off `text`.
inline std::string_view take_digits(std::string_view& text) {
    const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
    const auto digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    text.remove_prefix(digits.size());
    return digits;
}

inline bool take(std::string_view& text, char c) {
    if (text.empty() || text.front() != c)
        return false;
    text.remove_prefix(1);
    return true;
}

} // namespace number_text

/// Which sizes of numbers are read.
enum class NumberSize {
    of_double, ///< those of a scene
    any,       ///< fractions and whole numbers of any size too, as exact results have
};

/// Reads a decimal (`-4`, `0.25`, `1e-3`) or a fraction of whole numbers (`25/8`, `-1/4`).
/// The whole of `text` must be the number: no space, no `+` in front.
std::variant<Number, NumberFault> parse_number(std::string_view text,
                                               NumberSize size = NumberSize::of_double);

} // namespace rastertrace
