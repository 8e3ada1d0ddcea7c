// SPDX-License-Identifier: MIT
#include "line_equation.h"

#include "typed_number.h"

#include <rastertrace/trace/text/text.h>

#include <algorithm>
#include <array>
#include <variant>
#include <vector>

namespace rastertrace {

namespace {

/// Coefficients of x, y and 1.
struct Sum {
    std::array<Rational, 3> of{};
    std::array<std::vector<std::string>, 3> typed{}; ///< those that were added up
};

/// The terms of a sum, each with its sign.
std::vector<std::string> terms_of(std::string_view text) {
    std::vector<std::string> terms{""};
    int depth = 0;
    for (const char c : text) {
        depth += c == '(' ? 1 : c == ')' ? -1 : 0;
        if ((c == '+' || c == '-') && depth == 0) {
            const std::string_view before = without_blanks(terms.back());
            const bool goes_on = !before.empty() && (before.back() == '*' || before.back() == '/');
            if (!before.empty() && !goes_on)
                terms.emplace_back();
        }
        terms.back() += c;
    }
    return terms;
}

std::optional<TypedNumber> whole_number_of(std::string_view text) {
    const auto read = number_at(text, {});
    const auto* const number = std::get_if<TypedNumber>(&read);
    return number != nullptr && number->length == text.size() ? std::optional(*number)
                                                              : std::nullopt;
}

std::optional<Sum> sum_of(std::string_view text, int depth = 0);

/// Adds 5/8 (x - 1), 4/3 x, 5x/8 or 7/3.
bool add_term(Sum& sum, std::string_view text, int depth) {
    std::string term(without_blanks(text));
    const bool is_negative = term.starts_with('-');
    if (is_negative || term.starts_with('+'))
        term = without_blanks(term.substr(1));
    const std::size_t letter = term.find_first_of("xy");
    const std::size_t bracket = term.rfind('(', letter);
    const bool is_product = letter != std::string::npos && bracket != std::string::npos;
    const std::size_t begin = is_product ? bracket : letter;
    const std::size_t end = is_product ? term.find(')', begin) : letter;
    if (letter != std::string::npos && end == std::string::npos)
        return false;
    // 5x/8 is 5/8 x.
    std::string factor =
        letter == std::string::npos ? term : std::string(without_blanks(term.substr(0, begin)));
    if (factor.ends_with('*'))
        factor = without_blanks(factor.substr(0, factor.size() - 1));
    if (letter != std::string::npos)
        factor =
            (factor.empty() ? "1" : factor) + std::string(without_blanks(term.substr(end + 1)));
    const auto number = whole_number_of((is_negative ? "-" : "") + factor);
    const auto value = number ? typed_value(number->text) : std::nullopt;
    if (!value)
        return false;
    Sum inner;
    if (is_product) {
        const auto read = sum_of(term.substr(begin + 1, end - begin - 1), depth + 1);
        if (!read)
            return false;
        inner = *read;
        for (std::size_t i = 0; i < inner.of.size(); ++i)
            if (sgn(inner.of[i]) != 0)
                inner.typed[i] = {"", ""}; // as no one has typed it
    } else {
        const std::size_t of = letter == std::string::npos ? 2 : term[letter] == 'x' ? 0 : 1;
        inner.of[of] = 1;
        inner.typed[of] = {number->text};
    }
    for (std::size_t i = 0; i < inner.of.size(); ++i) {
        sum.of[i] += value->value * inner.of[i];
        sum.typed[i].insert(sum.typed[i].end(), inner.typed[i].begin(), inner.typed[i].end());
    }
    return true;
}

std::optional<Sum> sum_of(std::string_view text, int depth) {
    constexpr int most_brackets = 8;
    Sum sum;
    const auto terms = terms_of(text);
    const bool are_read = depth < most_brackets &&
                          std::all_of(terms.begin(), terms.end(), [&](const std::string& term) {
                              return add_term(sum, term, depth);
                          });
    return are_read ? std::optional(sum) : std::nullopt;
}

} // namespace

std::optional<LineEquation> line_equation(std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos)
        return std::nullopt;
    const std::string_view left_text = without_blanks(text.substr(0, equals));
    const std::string_view right_text = without_blanks(text.substr(equals + 1));
    const bool is_solved = left_text == "x" || left_text == "y";
    if (is_solved && right_text == open_value)
        return LineEquation{left_text == "x", std::string(open_value), std::string(open_value)};
    const auto left = sum_of(left_text);
    const auto right = sum_of(right_text);
    if (!left || !right)
        return std::nullopt;
    const auto difference = [&](std::size_t i) { return Rational(right->of[i] - left->of[i]); };
    LineEquation line{.is_of_y = left_text == "x" || sgn(difference(1)) == 0, .m = {}, .b = {}};
    const std::size_t solved = line.is_of_y ? 0 : 1;
    const Rational divisor = -difference(solved);
    if (sgn(divisor) == 0)
        return std::nullopt;
    const auto coefficient = [&](std::size_t i) {
        const bool is_typed = is_solved && right->typed[i].size() == 1 && divisor == 1;
        return is_typed ? right->typed[i].front() : Rational(difference(i) / divisor).get_str();
    };
    line.m = coefficient(1 - solved);
    line.b = coefficient(2);
    return line;
}

} // namespace rastertrace
