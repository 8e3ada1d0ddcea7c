// SPDX-License-Identifier: MIT
#include "number_word.h"

#include <rastertrace/core/numbers/number.h>

namespace rastertrace {

std::optional<std::string> usual_form(std::string_view word) {
    std::string usual;
    if (word.starts_with('-'))
        usual = "-";
    if (word.starts_with('-') || word.starts_with('+'))
        word.remove_prefix(1);

    const std::string_view whole = number_text::take_digits(word);
    const bool has_point = number_text::take(word, '.');
    const std::string_view fraction = number_text::take_digits(word);
    const bool exponent_follows = word.starts_with('e') || word.starts_with('E');
    if ((whole.empty() && fraction.empty()) || !(word.empty() || exponent_follows))
        return std::nullopt;

    usual += whole.empty() ? "0" : whole;
    if (has_point)
        usual.append(".").append(fraction.empty() ? "0" : fraction);
    return usual.append(word);
}

} // namespace rastertrace
