// SPDX-License-Identifier: MIT
#pragma once

// The kinds of number that vertices are moved in. A kind that is added gets its name in both lists.

#include <rastertrace/core/numbers/interval.h>
#include <rastertrace/core/numbers/rational.h>

#include <variant>

namespace rastertrace {

/// Calls a macro with each of them: to compile a template once, in the library.
#define RASTERTRACE_FOR_EACH_COORDINATE(MACRO)                                                     \
    MACRO(float)                                                                                   \
    MACRO(double)                                                                                  \
    MACRO(Interval)                                                                                \
    MACRO(Rational)

/// An Of<Coordinate> with coordinates of any kind, or something else.
template <typename Else, template <typename> typename Of>
using OfAnyCoordinate = std::variant<Else, Of<float>, Of<double>, Of<Interval>, Of<Rational>>;

} // namespace rastertrace
