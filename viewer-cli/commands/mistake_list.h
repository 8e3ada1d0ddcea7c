// SPDX-License-Identifier: MIT
#pragma once

// The known mistakes of rasterizers, as `rastertrace diagnose --list` prints them.

#include "app/json_text.h"

#include <rastertrace/core/draw/model/mistakes.h>

#include <string>

namespace rastertrace {

/// A line for each mistake: its name and its symptom.
std::string mistakes_text();

/// All that is known of one.
std::string mistake_text(const Mistake& mistake);

/// All that is known of each.
JsonText mistakes_json();

} // namespace rastertrace
