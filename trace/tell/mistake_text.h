// SPDX-License-Identifier: MIT
#pragma once

// What is said of a step that a known mistake has changed: the mistake's formula, with the numbers put in.
//
//     height-plus-one: x = 20 + (23 - 20)/(10 - 2 + 1) (y - 2) on the short edges

#include <rastertrace/trace/record/replay.h>

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace rastertrace {

/// What letters of a formula stand for: `x1` is 20.
using Letters = std::map<std::string, std::string, std::less<>>;

/// A formula with the numbers in the place of its letters; what is below 0, or a fraction, in brackets. What stands left
/// of the first `=` stays.
std::string put_in(std::string_view formula, const Letters& letters);

/// What is said behind the sentence of a replay's current step if it does not tell what its numbers give
/// (Trace::numbers_give), and the trace was drawn with a mistake; "" of any other.
std::string formula_of_mistake(const Replay& replay);

} // namespace rastertrace
