// SPDX-License-Identifier: MIT
#include <rastertrace/trace/format_number.h>

#include <rastertrace/trace/problem.h>

#include <fmt/format.h>

namespace rastertrace {

void refuse_to_format(double value) {
    throw problem_of("", fmt::format("expected a finite number to write, found {}", value),
                     "this is a fault of rastertrace, please report it with the scene");
}

} // namespace rastertrace
