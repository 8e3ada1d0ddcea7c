// SPDX-License-Identifier: MIT
#pragma once

// Numbers as a trace writes them, straight into a buffer: integers from a table of digit pairs,
// doubles in their shortest form, exact numbers as "25/8" in lowest terms and in quotes.
//
//     char buffer[32];
//     char* const end = format_number(buffer, 0.25);   // 0.25

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

inline char* format_number(char* out, const Rational& value) {
    const std::string text = value.get_str();
    *out++ = '"';
    std::memcpy(out, text.data(), text.size());
    out += text.size();
    *out++ = '"';
    return out;
}

} // namespace rastertrace
