// SPDX-License-Identifier: MIT
#pragma once

// Numbers as a trace writes them, straight into a buffer: integers from a table of digit pairs,
// doubles in their shortest form, exact numbers as "25/8" in lowest terms and in quotes.
//
//     char buffer[32];
//     char* const end = format_number(buffer, 0.25);   // 0.25

#include <rastertrace/core/numbers/adaptive.h>
#include <rastertrace/core/numbers/conversion.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <string>

namespace rastertrace {

namespace digit_tables {

/// "00", "01", ... "99".
inline constexpr auto pairs = [] {
    std::array<std::array<char, 2>, 100> table{};
    for (std::size_t i = 0; i < 100; ++i)
        table[i] = {static_cast<char>('0' + i / 10), static_cast<char>('0' + i % 10)};
    return table;
}();

/// The digits of k/1024 behind the point, without zeros at their end: 512 -> "5", 1 ->
/// "0009765625".
struct DyadicFraction {
    std::array<char, 15> digits{};
    std::uint8_t length = 0;
};
inline constexpr auto dyadic_fractions = [] {
    std::array<DyadicFraction, 1024> table{};
    for (std::size_t k = 1; k < 1024; ++k) {
        for (std::uint64_t rest = k; rest != 0; rest %= 1024) {
            rest *= 10;
            table[k].digits[table[k].length++] = static_cast<char>('0' + rest / 1024);
        }
    }
    return table;
}();

} // namespace digit_tables

/// The most bytes that format_number writes for a value of this kind.
constexpr std::size_t room_for(int) {
    return 20;
}
constexpr std::size_t room_for(std::int64_t) {
    return 20;
}
constexpr std::size_t room_for(double) {
    return 32;
}
constexpr std::size_t room_for(const Fraction64&) {
    return 2 * 20 + 3;
}
inline std::size_t room_for(const Rational& value) {
    return mpz_sizeinbase(value.get_num_mpz_t(), 10) + mpz_sizeinbase(value.get_den_mpz_t(), 10) +
           6;
}
inline std::size_t room_for(const Adaptive& value) {
    return room_for(value.value());
}

/// Writes a value to `out`, which must have room for it; returns the place behind it.
inline char* format_number(char* out, std::uint64_t value) {
    // Two digits at a time. Most indices of a picture have at most four.
    const auto put_pair = [&out](std::uint64_t pair) {
        std::memcpy(out, digit_tables::pairs[pair].data(), 2);
        out += 2;
    };
    const auto put_first = [&](std::uint64_t pair) {
        if (pair < 10)
            *out++ = static_cast<char>('0' + pair);
        else
            put_pair(pair);
    };
    if (value < 100) {
        put_first(value);
    } else if (value < 10'000) {
        put_first(value / 100);
        put_pair(value % 100);
    } else {
        out = std::to_chars(out, out + 20, value).ptr;
    }
    return out;
}

inline char* format_number(char* out, std::int64_t value) {
    if (value >= 0)
        return format_number(out, static_cast<std::uint64_t>(value));
    *out++ = '-';
    return format_number(out, std::uint64_t{0} - static_cast<std::uint64_t>(value));
}

inline char* format_number(char* out, int value) {
    return format_number(out, std::int64_t{value});
}

/// Throws a Problem: JSON has no infinity, and no NaN.
[[noreturn]] void refuse_to_format(double value);

/// Writes what format_number does if `value` is a multiple of 1/1024 of usual size; else returns null.
inline char* format_dyadic(char* out, double value) {
    // A multiple of 1/1024 is written from tables. In scientific notation it would only be shorter
    // if it ended in zeros before the point, as 100000 does (1e+05).
    constexpr double table_limit = 4.0e9;
    if (-table_limit < value && value < table_limit) {
        const double scaled = value * 1024;
        const auto units = static_cast<std::int64_t>(scaled);
        if (static_cast<double>(units) == scaled) {
            const auto magnitude = static_cast<std::uint64_t>(units < 0 ? -units : units);
            const std::uint64_t whole = magnitude / 1024;
            const auto& fraction = digit_tables::dyadic_fractions[magnitude % 1024];
            if (fraction.length > 0 || whole < 100'000) {
                if (units < 0)
                    *out++ = '-';
                out = format_number(out, whole);
                if (fraction.length > 0) {
                    *out++ = '.';
                    std::memcpy(out, fraction.digits.data(), fraction.digits.size());
                    out += fraction.length;
                }
                return out;
            }
        }
    }
    return nullptr;
}

/// The shortest text that reads back to the same bits, as std::to_chars gives it; -0 is written 0.
/// Throws a Problem if `value` is not finite: no infinity can reach a file.
inline char* format_number(char* out, double value) {
    if (char* const end = format_dyadic(out, value))
        return end;
    if (!std::isfinite(value)) [[unlikely]]
        refuse_to_format(value);
    return std::to_chars(out, out + 32, value).ptr;
}

/// The shortest text that reads back to the same float; -0 is written 0. Throws as above.
inline char* format_number(char* out, float value) {
    if (!std::isfinite(value)) [[unlikely]]
        refuse_to_format(value);
    return std::to_chars(out, out + 32, value == 0 ? 0 : value).ptr;
}

/// An exact number in lowest terms: "25/8", or "3" if it is whole.
inline char* format_number(char* out, const Fraction64& value) {
    const std::int64_t divisor = std::gcd(value.numerator, value.denominator);
    *out++ = '"';
    out = format_number(out, value.numerator / divisor);
    if (value.denominator != divisor) {
        *out++ = '/';
        out = format_number(out, value.denominator / divisor);
    }
    *out++ = '"';
    return out;
}

inline char* format_number(char* out, const Rational& value);

/// The double nearest to a fraction; the fraction itself where that is beyond all doubles.
inline char* format_as_double(char* out, const Rational& value) {
    const double near = nearest_double(value);
    return std::isfinite(near) ? format_number(out, near) : format_number(out, value);
}

/// The longest fraction that is written where its nearest double would do for most readers, in digits
/// of numerator and denominator together.
inline constexpr std::size_t most_digits_told = 200;

/// True if a fraction has no more digits than that.
inline bool is_short(const Rational& value) {
    return mpz_sizeinbase(value.get_num_mpz_t(), 10) + mpz_sizeinbase(value.get_den_mpz_t(), 10) <=
           most_digits_told;
}

/// True if a positive whole number is a power of two.
inline bool is_power_of_two(const mpz_class& whole) {
    return (mpz_class(1) << (mpz_sizeinbase(whole.get_mpz_t(), 2) - 1)) == whole;
}

/// A double where that is the number itself, else the fraction, unless that is too long.
inline char* format_exactly(char* out, const Rational& value, bool however_long = false) {
    const bool is_told = however_long || is_short(value);
    // Only a denominator that is a power of two can make a double.
    if (is_told && !is_power_of_two(value.get_den()))
        return format_number(out, value);
    const double near = nearest_double(value);
    if (std::isfinite(near) && (!is_told || Rational(near) == value))
        return format_number(out, near);
    return format_number(out, value);
}

/// A fraction between a number and the whole number or half that its nearest double is: what is rounded,
/// or asked for its sign, is decided alike. It is no longer than the number, but for a few digits.
Rational bound_beside(const Rational& value, double near);

/// The nearest double, unless that is a whole number or a half and not the number itself: then the number,
/// or, of one with too many digits, a bound that decides the same.
inline char* format_deciding(char* out, const Rational& value) {
    const double near = nearest_double(value);
    if (!std::isfinite(near))
        return format_number(out, value);
    if (std::abs(near) > static_cast<double>(farthest_index) || std::floor(2 * near) != 2 * near ||
        Rational(near) == value)
        return format_number(out, near);
    return format_number(out, is_short(value) ? value : bound_beside(value, near));
}
template <typename Integer> char* format_deciding(char* out, const Fraction<Integer>& value) {
    const double near = to_double(value);
    if (std::floor(2 * near) != 2 * near)
        return format_number(out, near);
    return format_deciding(out, exact(value));
}

/// A filtered double; its bound is not written.
inline char* format_number(char* out, const Adaptive& value) {
    return format_number(out, value.value());
}

inline char* format_number(char* out, const Rational& value) {
    const std::string text = value.get_str();
    *out++ = '"';
    std::memcpy(out, text.data(), text.size());
    out += text.size();
    *out++ = '"';
    return out;
}

} // namespace rastertrace
