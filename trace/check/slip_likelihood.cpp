// SPDX-License-Identifier: MIT
#include "slip_likelihood.h"

#include "claim_comparison.h"
#include "typed_number.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>

namespace rastertrace {

namespace {

/// Chance makes three things, each as often: another digit, a number ten times as large or as small, another number.
constexpr double share_of_each = 1.0 / 3;

/// Another number is a whole one as often as not, and not far from 0.
constexpr double usual_whole_numbers = 41;
constexpr double usual_denominators = 8;

/// Most verdicts that are wrong come of a rule that was taken for another.
constexpr double chance_of_other_verdict = 1.0 / 4;

/// Of all colors, few are likely.
constexpr double chance_of_other_color = 1e-3;

double chance_of_other_number(const TypedValue& typed) {
    double numbers = std::max(usual_whole_numbers, 2 * std::abs(typed.value.get_d()));
    if (typed.places)
        numbers *= std::pow(10.0, std::max(0, *typed.places));
    else if (typed.value.get_den() != 1)
        numbers *= usual_denominators;
    return share_of_each / 2 / numbers;
}

/// That one digit of `right` became another.
double chance_of_other_digit(std::string_view text, std::string_view right) {
    if (text.size() != right.size())
        return 0;
    std::size_t digits = 0;
    std::size_t others = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool is_digit = std::isdigit(static_cast<unsigned char>(right[i])) != 0;
        digits += is_digit ? 1 : 0;
        if (text[i] != right[i] &&
            !(is_digit && std::isdigit(static_cast<unsigned char>(text[i])) != 0))
            return 0;
        others += text[i] != right[i] ? 1 : 0;
    }
    return others == 1 ? share_of_each / (9.0 * static_cast<double>(digits)) : 0;
}

double chance_of(const std::string& text, const Rational& right) {
    const auto typed = typed_value(text);
    if (!typed)
        return levels_in(text).empty() ? chance_of_other_verdict : chance_of_other_color;
    const bool is_tenfold = typed->value == 10 * right || 10 * typed->value == right;
    return chance_of_other_number(*typed) + chance_of_other_digit(text, right.get_str()) +
           (is_tenfold ? share_of_each / 2 : 0);
}

} // namespace

double evidence_for(const std::vector<SlipResult>& results, const ClaimedField& field,
                    const Values& right) {
    std::set<Values> different;
    for (const SlipResult& result : results)
        different.insert(result.values);
    double chance = 0;
    for (std::size_t i = 0; i < std::min(field.values.size(), right.size()); ++i) {
        const auto typed = typed_value(field.values[i]);
        if (field.values[i] != open_value && (!typed || typed->value != right[i]))
            chance += std::log(chance_of(field.values[i], right[i]));
    }
    return -std::log(static_cast<double>(std::max<std::size_t>(different.size(), 1))) - chance;
}

double habit_of(const HowOften& often) {
    constexpr double always = 0.9;
    constexpr double now_and_then = 0.05;
    const auto likelihood = [&often](double share) {
        return std::pow(share, static_cast<double>(often.made)) *
               std::pow(1 - share, static_cast<double>(often.not_made));
    };
    return std::log(likelihood(always) + likelihood(now_and_then));
}

double prior_of(std::string_view slip) {
    const Slip* const known = find_slip(slip);
    return known != nullptr ? std::log(known->in_thousand / 1000.0) : prior_of_mistake();
}

double prior_of_mistake() {
    constexpr double in_thousand = 3; // each; about a hundred are known
    return std::log(in_thousand / 1000.0);
}

double prior_of_chance() {
    // More than a share: the name of a wrong slip leads astray, no name does not. With 2.2, of wrong numbers made by
    // chance in small scenes of whole numbers less than 3 % get a name; of those made by a slip in random scenes 97 %.
    return std::log(2.2);
}

} // namespace rastertrace
