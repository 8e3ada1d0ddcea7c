// SPDX-License-Identifier: MIT
#include "number_fault.h"

#include <fmt/core.h>

namespace rastertrace {

std::string expected_instead_of(NumberFault fault) {
    switch (fault) {
    case NumberFault::zero_denominator:
        return "a denominator other than 0";
    case NumberFault::too_large:
        return "a number up to 1.797e308";
    case NumberFault::too_small:
        return "0 or a number from 4.941e-324 on";
    case NumberFault::too_long:
        return fmt::format("a number of at most {} characters", longest_number);
    case NumberFault::malformed:
        break;
    }
    return "a number";
}

} // namespace rastertrace
