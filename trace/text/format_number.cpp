// SPDX-License-Identifier: MIT
#include "format_number.h"

#include "problem.h"

#include <fmt/core.h>

namespace rastertrace {

void refuse_to_format(double value) {
    throw problem_of("", fmt::format("expected a finite number to write, found {}", value),
                     "this is a fault of rastertrace, please report it with the scene");
}

} // namespace rastertrace
