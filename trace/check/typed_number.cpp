// SPDX-License-Identifier: MIT
#include "typed_number.h"

#include <rastertrace/core/numbers/irrational.h>
#include <rastertrace/trace/tell/step_text.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

using number_text::is_digit;

/// The most operators of a number, and the most brackets in one another: more than anybody writes.
constexpr int most_operators = 64;

/// A number, and whether it is a fraction.
struct Term {
    Rational value;
    bool is_exact = true;
    bool has_pi = false;
    bool is_in_degrees = false;
};

class NumberParser {
public:
    NumberParser(std::string_view text, const NumberSpelling& spelling)
        : text_(text), spelling_(spelling) {}

    std::variant<TypedNumber, NumberFault> read() {
        const bool is_rounded = take("~");
        skip_blanks();
        const std::size_t begin = at_;
        const auto term = sum();
        if (fault_)
            return *fault_;
        if (!term)
            return NumberFault::malformed;
        TypedNumber number{.text = spelled(*term, text_.substr(begin, at_ - begin)),
                           .has_comma = has_comma_,
                           .is_mixed = is_mixed_};
        if (is_rounded)
            number.text.insert(0, "~");
        if (take_dots())
            number.text += "..";
        take_unit();
        number.length = at_;
        return number;
    }

    /// The value of the whole text.
    std::optional<Term> value() {
        auto term = sum();
        return term && !fault_ && at_ == text_.size() ? term : std::nullopt;
    }

private:
    char peek(std::size_t ahead = 0) const {
        return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
    }
    bool take(std::string_view what) {
        const bool is_next = text_.substr(at_).starts_with(what);
        at_ += is_next ? what.size() : 0;
        return is_next;
    }
    bool skip_blanks() {
        const std::size_t from = at_;
        while (peek() == ' ' || peek() == '\t')
            ++at_;
        return at_ > from;
    }
    /// Takes a word that is not the beginning of a longer one.
    bool take_word(std::string_view word) {
        const std::size_t from = at_;
        if (take(word) && std::isalpha(static_cast<unsigned char>(peek())) == 0)
            return true;
        at_ = from;
        return false;
    }

    std::optional<Term> sum() {
        auto left = product();
        while (left && !fault_) {
            const std::size_t from = at_;
            const bool has_blank = skip_blanks();
            const bool is_minus = peek() == '-';
            const bool is_sign = is_minus || peek() == '+';
            at_ += is_sign ? 1 : 0;
            // -1 3 -3 are three numbers.
            const bool is_operator = is_sign && ((skip_blanks() && has_blank) || depth_ > 0);
            const auto right = is_operator ? product() : std::nullopt;
            if (!right) {
                at_ = from;
                break;
            }
            count_operator();
            left = Term{.value = is_minus ? Rational(left->value - right->value)
                                          : Rational(left->value + right->value),
                        .is_exact = left->is_exact && right->is_exact,
                        .has_pi = left->has_pi || right->has_pi};
        }
        return left;
    }

    std::optional<Term> product() {
        auto left = factor();
        while (left && !fault_) {
            const std::size_t from = at_;
            skip_blanks();
            const bool divides = peek() == '/';
            const bool multiplies = !divides && (take("*") || is_at_multiplied());
            at_ += divides ? 1 : 0;
            skip_blanks();
            const int operators_before = operators_;
            const std::size_t literals_before = literals_.size();
            const bool has_bracket = peek() == '(';
            is_divisor_ = divides;
            const auto right = divides || multiplies ? factor() : std::nullopt;
            is_divisor_ = false;
            // A number in brackets behind another is no factor: 2 (5).
            const bool is_apart =
                has_bracket && !divides && text_[at_ - 1] == ')' && operators_ == operators_before;
            if (!right || is_apart) {
                at_ = from;
                literals_.resize(literals_before);
                break;
            }
            count_operator();
            if (divides && sgn(right->value) == 0) {
                fault_ = NumberFault::zero_denominator;
                break;
            }
            left = Term{.value = divides ? Rational(left->value / right->value)
                                         : Rational(left->value * right->value),
                        .is_exact = left->is_exact && right->is_exact,
                        .has_pi = left->has_pi || right->has_pi,
                        .is_in_degrees = left->is_in_degrees || right->is_in_degrees};
        }
        return left;
    }

    /// True of what multiplies the factor before it without a sign between.
    bool is_at_multiplied() const {
        const std::string_view rest = text_.substr(at_);
        return rest.starts_with('(') || rest.starts_with("sqrt") || rest.starts_with("pi") ||
               rest.starts_with("sin") || rest.starts_with("cos") || rest.starts_with("tan");
    }

    std::optional<Term> factor() {
        const std::size_t from = at_;
        const bool is_negative = peek() == '-';
        if (is_negative || peek() == '+') {
            ++at_;
            skip_blanks();
        }
        auto term = primary();
        if (!term)
            at_ = from;
        else if (is_negative)
            term->value = -term->value;
        return term;
    }

    std::optional<Term> primary() {
        if (is_digit(peek()) || (peek() == '.' && is_digit(peek(1))))
            return decimal();
        if (depth_ == most_operators)
            return std::nullopt;
        ++depth_;
        auto term = take("(")           ? bracket()
                    : take_word("frac") ? fraction()
                    : take_word("sqrt") ? root()
                    : take_word("pi")
                        ? std::optional(Term{.value = pi(), .is_exact = false, .has_pi = true})
                        : ratio_of_circle();
        --depth_;
        return term;
    }

    /// LaTeX's \frac{25}{8} and \frac14, which are read as frac (25)/(8) and frac 14.
    std::optional<Term> fraction() {
        skip_blanks();
        const bool has_brackets = peek() == '(';
        const auto part = [&] { return has_brackets && take("(") ? bracket() : digit(); };
        const auto above = part();
        const bool has_bar = !has_brackets || take("/");
        const auto below = above && has_bar ? part() : std::nullopt;
        if (!below)
            return std::nullopt;
        count_operator();
        if (sgn(below->value) == 0) {
            fault_ = NumberFault::zero_denominator;
            return std::nullopt;
        }
        return Term{.value = above->value / below->value,
                    .is_exact = above->is_exact && below->is_exact};
    }

    std::optional<Term> digit() {
        if (!is_digit(peek()))
            return std::nullopt;
        literals_.emplace_back(1, peek());
        return Term{.value = Rational(text_[at_++] - '0')};
    }

    std::optional<Term> bracket() {
        skip_blanks();
        auto inner = sum();
        skip_blanks();
        return inner && take(")") ? inner : std::nullopt;
    }

    std::optional<Term> root() {
        skip_blanks();
        const auto square = primary();
        if (!square || sgn(square->value) < 0)
            return std::nullopt;
        count_operator();
        const bool is_fraction = square->is_exact && has_rational_root(square->value);
        return Term{.value = square_root(square->value, RootDigits::many), .is_exact = is_fraction};
    }

    /// sin, cos or tan of an angle that says what it is in: degrees, or parts of pi.
    std::optional<Term> ratio_of_circle() {
        const bool is_sine = take_word("sin");
        const bool is_cosine = !is_sine && take_word("cos");
        if (!is_sine && !is_cosine && !take_word("tan"))
            return std::nullopt;
        skip_blanks();
        const auto angle = primary();
        if (!angle || angle->is_in_degrees == angle->has_pi)
            return std::nullopt;
        count_operator();
        const Rational degrees = angle->has_pi ? Rational(angle->value * 180 / pi()) : angle->value;
        const Rational sine = sine_of_degrees(degrees, RootDigits::many);
        const Rational cosine = cosine_of_degrees(degrees, RootDigits::many);
        if (!is_sine && !is_cosine && sgn(cosine) == 0)
            return std::nullopt;
        return Term{.value = is_sine     ? sine
                             : is_cosine ? cosine
                                         : Rational(sine / cosine),
                    .is_exact = false};
    }

    /// Digits, a point or a comma among them, an exponent; or a whole number and a fraction.
    std::optional<Term> decimal() {
        const std::size_t from = at_;
        const auto skip_digits = [this] {
            while (is_digit(peek()))
                ++at_;
        };
        skip_digits();
        const std::size_t point = at_;
        const bool has_comma = peek() == ',' && spelling_.has_decimal_comma && at_ > from;
        if ((peek() == '.' || has_comma) && is_digit(peek(1))) {
            ++at_;
            skip_digits();
            has_comma_ = has_comma_ || has_comma;
            if (has_comma && peek() == ',' && is_digit(peek(1))) // 1,2,3
                return std::nullopt;
        }
        const bool is_whole = at_ == point;
        const std::size_t sign = peek(1) == '-' || peek(1) == '+' ? 1 : 0;
        if ((peek() == 'e' || peek() == 'E') && is_digit(peek(1 + sign))) {
            at_ += 1 + sign;
            skip_digits();
        }
        std::string literal(text_.substr(from, at_ - from));
        std::replace(literal.begin(), literal.end(), ',', '.');
        if (literal.front() == '.')
            literal.insert(0, "0");
        const auto number = parse_number(literal);
        if (const auto* const fault = std::get_if<NumberFault>(&number)) {
            fault_ = *fault;
            return std::nullopt;
        }
        Term term{.value = std::get<Number>(number).exact()};
        if (const auto part = is_whole && spelling_.has_mixed && !is_divisor_ ? fraction_behind()
                                                                              : std::nullopt) {
            term.value += *part;
            is_mixed_ = true;
            count_operator();
        }
        literals_.push_back(std::move(literal));
        term.is_in_degrees = take_degrees();
        return term;
    }

    /// The fraction below 1 that stands behind a whole number: 1/8 of 3 1/8.
    std::optional<Rational> fraction_behind() {
        const std::size_t from = at_;
        const auto digits = [this] {
            const std::size_t first = at_;
            while (is_digit(peek()))
                ++at_;
            return std::string(text_.substr(first, at_ - first));
        };
        if (skip_blanks())
            if (const std::string above = digits(); !above.empty() && take("/"))
                if (const std::string below = digits(); !below.empty() && peek() != '.')
                    if (above.size() + below.size() < longest_number)
                        if (const mpz_class under(below, 10); mpz_class(above, 10) < under)
                            return quotient_of(mpz_class(above, 10), under);
        at_ = from;
        return std::nullopt;
    }

    bool take_degrees() {
        const std::size_t from = at_;
        skip_blanks();
        if (take_word("deg") || take_word("degrees") || take_word("degree"))
            return true;
        at_ = from;
        return false;
    }

    /// The dots of a number that goes on: 0.33.. and not 1..3.
    bool take_dots() {
        const std::size_t from = at_;
        const bool has_dots = literals_.size() == 1 &&
                              literals_[0].find('.') != std::string::npos && operators_ == 0 &&
                              take("..");
        const char next = peek();
        if (has_dots && !is_digit(next) && next != '-' && next != '?')
            return true;
        at_ = from;
        return false;
    }

    void take_unit() {
        const std::size_t from = at_;
        skip_blanks();
        for (const std::string_view unit : {"px", "pixels", "pixel", "units", "unit"})
            if (take_word(unit))
                return;
        at_ = from;
    }

    void count_operator() {
        if (++operators_ > most_operators)
            fault_ = NumberFault::malformed;
    }

    /// The number as scenes spell it, if they can.
    std::string spelled(const Term& term, std::string_view typed) const {
        if (!term.is_exact)
            return std::string(typed);
        const std::string sign = typed.starts_with('-') ? "-" : "";
        const std::string as_typed = operators_ == 0 && literals_.size() == 1 ? sign + literals_[0]
                                     : operators_ == 1 && literals_.size() == 2
                                         ? sign + literals_[0] + "/" + literals_[1]
                                         : "";
        return number_in(as_typed) == term.value ? as_typed : term.value.get_str();
    }

    std::string_view text_;
    const NumberSpelling spelling_;
    std::size_t at_ = 0;
    int depth_ = 0;
    int operators_ = 0;
    std::vector<std::string> literals_;
    bool has_comma_ = false;
    bool is_mixed_ = false;
    bool is_divisor_ = false; ///< 1/2 1/4 are two numbers, and not 1 over 2 1/4
    std::optional<NumberFault> fault_;
};

/// The digits behind the point of a decimal, less those that its exponent takes away: five of 1.25e-3.
std::optional<int> places_of(std::string_view decimal) {
    const std::size_t point = decimal.find('.');
    if (point == std::string_view::npos)
        return std::nullopt;
    const std::size_t mark = std::min(decimal.find_first_of("eE"), decimal.size());
    int exponent = 0;
    const std::string_view power = decimal.substr(std::min(mark + 1, decimal.size()));
    const std::size_t sign = power.starts_with('+') ? 1 : 0;
    std::from_chars(power.data() + sign, power.data() + power.size(), exponent);
    return static_cast<int>(mark - point - 1) - exponent;
}

} // namespace

std::variant<TypedNumber, NumberFault> number_at(std::string_view text,
                                                 const NumberSpelling& spelling) {
    return NumberParser(text, spelling).read();
}

std::string typed_quotient(const std::string& above, const std::string& below) {
    const auto quotient = number_at("(" + above + ")/(" + below + ")", {});
    const auto* const number = std::get_if<TypedNumber>(&quotient);
    return number == nullptr ? "" : number->text;
}

std::optional<TypedValue> typed_value(std::string_view text) {
    TypedValue typed;
    if (text.starts_with('~')) {
        typed.is_rounded = true;
        text.remove_prefix(1);
    }
    if (text.ends_with("..")) {
        typed.goes_on = true;
        text.remove_suffix(2);
    }
    if (const auto number = number_in(text)) {
        typed.value = *number;
        typed.places = places_of(text);
    } else if (const auto term = NumberParser(text, {}).value()) {
        typed.value = term->value;
        typed.is_exact = term->is_exact;
    } else {
        return std::nullopt;
    }
    if (typed.is_rounded && !typed.places && text.find('/') == std::string_view::npos)
        typed.places = 0;
    return typed;
}

} // namespace rastertrace
