// SPDX-License-Identifier: MIT
#pragma once

// The shortest decimal text of a double or a float, as std::to_chars of the GNU library writes it. Which digits
// these are is what the package fmt finds out (dragonbox); here they get their point or their exponent.
//
//     char text[32];
//     char* const end = write_shortest(text, 0.1);   // 0.1

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace rastertrace {

/// Writes at most 32 characters; returns the place behind them. `value` must be finite.
template <typename Floating> char* write_shortest(char* out, Floating value) {
    if (std::signbit(value))
        *out++ = '-';
    if (value == 0) {
        *out++ = '0';
        return out;
    }
    const auto decimal = fmt::detail::dragonbox::to_decimal(std::abs(value));
    std::uint64_t significand = decimal.significand;
    int exponent = decimal.exponent;
    for (; significand % 10 == 0; significand /= 10)
        ++exponent;
    const std::string digits = std::to_string(significand);
    const auto count = static_cast<int>(digits.size());

    // 12345 with an exponent has a point, and four characters for e+05. Written without, the fewest
    // characters are as many where the point stands up to five places away from the digits.
    const int point = count == 1 ? 0 : 1;
    const bool has_exponent = exponent < -count - 2 - point || exponent > 4 + point;
    const auto put = [&out](std::string_view text) {
        out = std::copy(text.begin(), text.end(), out);
    };
    if (has_exponent) {
        put(digits.substr(0, 1));
        if (count > 1)
            put("." + digits.substr(1));
        const int power = exponent + count - 1;
        put(power < 0 ? "e-" : "e+");
        if (std::abs(power) < 10)
            put("0");
        put(std::to_string(std::abs(power)));
    } else if (exponent > 0) {
        // A whole number is written as it is, not with zeros for what the digits leave open.
        out += std::snprintf(out, 32, "%.0f", std::abs(static_cast<double>(value)));
    } else if (exponent == 0) {
        put(digits);
    } else if (-exponent < count) {
        put(digits.substr(0, digits.size() + exponent));
        put("." + digits.substr(digits.size() + exponent));
    } else {
        put("0." + std::string(static_cast<std::size_t>(-exponent - count), '0') + digits);
    }
    return out;
}

} // namespace rastertrace
