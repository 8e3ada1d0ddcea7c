// SPDX-License-Identifier: MIT
#pragma once

#include "problem.h"

#include <optional>

namespace rastertrace {

/// The first zero byte of a source is a problem: text has none, and what follows it could go unseen.
std::optional<Problem> zero_byte_in(const Source& source);

} // namespace rastertrace
