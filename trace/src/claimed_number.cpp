// SPDX-License-Identifier: MIT
#include "claimed_number.h"

#include "step_text.h"

#include <rastertrace/core/numbers/number.h>

#include <algorithm>
#include <charconv>

namespace rastertrace {

std::optional<ClaimedNumber> claimed_number(std::string_view text) {
    const auto value = number_in(text);
    if (!value)
        return std::nullopt;
    const std::size_t point = text.find('.');
    if (point == std::string_view::npos)
        return ClaimedNumber{*value};
    // 1.25e-3 has five digits behind the point.
    const std::size_t mark = std::min(text.find_first_of("eE"), text.size());
    int exponent = 0;
    const std::string_view power = text.substr(std::min(mark + 1, text.size()));
    const std::size_t sign = power.starts_with('+') ? 1 : 0;
    std::from_chars(power.data() + sign, power.data() + power.size(), exponent);
    return ClaimedNumber{*value, static_cast<int>(mark - point - 1) - exponent};
}

Fit fit_of(const ClaimedNumber& claimed, const Rational& truth) {
    if (claimed.value == truth)
        return Fit::exact;
    constexpr int most_places = 30;
    const int places = claimed.places.value_or(0);
    if (!claimed.places || places < 0 || places > most_places)
        return Fit::none;
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(places));
    if (2 * abs(claimed.value - truth) * power <= 1)
        return Fit::rounded;
    const Rational scaled = truth * power;
    const mpz_class cut = scaled.get_num() / scaled.get_den(); // toward 0
    return claimed.value * power == cut ? Fit::truncated : Fit::none;
}

} // namespace rastertrace
