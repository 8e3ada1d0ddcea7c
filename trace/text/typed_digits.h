// SPDX-License-Identifier: MIT
#pragma once

// How exactly a number was typed.
//
//     unit_of_last_digit("0.333333")  // 1e-6

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace rastertrace {

/// 10^place, what a digit counts that stands so many places before the point, or, below 0, behind it; 0 for a whole
/// number.
inline float unit_of_place(int place) {
    const auto power = [](int of) { return static_cast<float>(std::pow(10.0, of)); };
    static const auto usual = [&power] {
        std::array<float, 20> units{};
        for (int behind = 1; behind < 20; ++behind)
            units[static_cast<std::size_t>(behind)] = power(-behind);
        return units;
    }();
    if (place >= 0)
        return 0.0F;
    return place > -20 ? usual[static_cast<std::size_t>(-place)] : power(place);
}

/// What the last digit of a decimal counts; 0 for a whole number and for a fraction, which nobody
/// has rounded.
inline float unit_of_last_digit(std::string_view typed) {
    const std::size_t end = std::min(typed.find_first_of("eE"), typed.size());
    const std::size_t point = std::min(typed.find('.'), end);
    int last_place = point == end ? 0 : -static_cast<int>(end - point - 1);
    if (end < typed.size()) {
        std::string_view exponent = typed.substr(end + 1);
        if (exponent.starts_with('+'))
            exponent.remove_prefix(1);
        int power = 0;
        std::from_chars(exponent.data(), exponent.data() + exponent.size(), power);
        last_place += power;
    }
    return unit_of_place(last_place);
}

} // namespace rastertrace
