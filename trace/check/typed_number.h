// SPDX-License-Identifier: MIT
#pragma once

// A number as people write it by hand: 3 1/8, -1 / 4, .25, +2, 0,25, sqrt(2)/2, 3/4 (2 - 5), ~0.33, 0.33..
//
//     std::get<TypedNumber>(number_at("3 1/8, 4", {})).text;  // "25/8"
//
// sum     = product { ("+" | "-") product }            on the outside with blanks around the sign
// product = factor { ("*" | "/") factor | factor }     the latter with a root, pi or a bracket: 2 sqrt(3)
// factor  = [ "+" | "-" ] primary
// primary = decimal [ "deg" ] | whole fraction | "(" sum ")" | "sqrt" primary | "pi" | ("sin" | "cos" | "tan") primary
//         | "frac" ( "(" sum ")/(" sum ")" | digit digit )

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/core/numbers/rational.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace rastertrace {

/// A value that is left open: nobody has worked it out yet.
inline constexpr std::string_view open_value = "?";

/// What stands for the slope of a horizontal edge.
inline constexpr std::string_view no_slope = "none";

/// How numbers are spelled where one is read.
struct NumberSpelling {
    bool has_decimal_comma = false; ///< 0,25 is 1/4
    bool has_mixed = true;          ///< 3 1/8 is 25/8, and not two numbers
};

/// A number that was read.
struct TypedNumber {
    /// As scenes spell it: "25/8", "-0.25". Of one with a root in it as it was typed: "sqrt(2)/2". Before it `~`, if the
    /// author says that it is rounded; behind it `..`, if it goes on.
    std::string text;
    std::size_t length = 0; ///< bytes that were read
    bool has_comma = false; ///< a decimal comma is in it
    bool is_mixed = false;  ///< a whole number and a fraction
};

/// The number that `text` begins with; or what is wrong with it, `malformed` where there is none.
std::variant<TypedNumber, NumberFault> number_at(std::string_view text,
                                                 const NumberSpelling& spelling);

/// What a TypedNumber's text says.
struct TypedValue {
    Rational value;
    bool is_exact = true;           ///< no root or sine in it, which are held with many digits
    std::optional<int> places = {}; ///< digits behind the point, of a decimal
    bool is_rounded = false;        ///< `~`
    bool goes_on = false;           ///< `..`
};

/// above : below, as 3/4 is spelled; empty if `below` is 0.
std::string typed_quotient(const std::string& above, const std::string& below);

/// Nothing of a text that is no number.
std::optional<TypedValue> typed_value(std::string_view text);

} // namespace rastertrace
