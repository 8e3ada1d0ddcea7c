// SPDX-License-Identifier: MIT
#pragma once

// The words of a scene's "method": which keys there are, which values each takes. The scene reader,
// the trace's header and the program's options all read this one table.

#include "problem.h"

#include <rastertrace/core/draw/scene/method.h>

#include <functional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

struct Scene;

/// One choice that a method makes.
struct MethodKey {
    std::string_view name;                  ///< as in a scene, and as an option: `--name`
    std::string_view meaning;               ///< one line for people
    std::vector<std::string_view> values;   ///< the default is the one that Method{} has
    std::string (*get)(const Method&);      ///< what was said; "" where nothing was
    bool (*set)(Method&, std::string_view); ///< false if there is no such value
    std::string (*otherwise)(const Scene&); ///< what holds where nothing was said
    bool (*in_force)(const Scene&);         ///< false if the picture cannot depend on it
    std::string_view told_as = {};          ///< in the place of values that are too many to list

    /// Its values: `up, down`.
    std::string listed() const;

    /// The same as what is expected: `one of up, down`.
    std::string expected() const;

    /// True if the values are whole numbers, which JSON writes without quotes.
    bool is_number() const { return values.front() == "1"; }
};

/// Every key, in the order in which a trace's header writes them.
std::span<const MethodKey> method_keys();

/// What a key says, or what holds where it says nothing. Two values joined by "+" are that of spans
/// and that of lines.
std::string value_in_force(const MethodKey& key, const Scene& scene);

/// The key of that name, or nullptr.
const MethodKey* find_method_key(std::string_view name);

/// What a mistake makes of a method that has it: its setting, whatever the method says, or the exact numbers of the
/// model.
void put_in(const Mistake& mistake, Method& method);

/// The method of a trace, as its header tells it. What that does not say, or in words that are not ours, is as in Method{}.
struct ToldMethod {
    Method triangles;
    Method others;                           ///< of what else is drawn
    std::set<std::string, std::less<>> keys; ///< those that the header says in our words
    std::vector<std::pair<std::string, std::string>> words; ///< key and value, as in the header

    bool says(std::string_view key) const { return keys.contains(key); }

    /// True if it says that lines are drawn by this.
    bool draws_lines_by(LineMethod line) const { return says("line") && others.line == line; }

    /// True if the numbers of the trace stand for floats.
    bool has_floats() const { return triangles.scalar == ScalarKind::single_precision; }

    /// The value of a key, as in the header; "" if it has none.
    std::string word_of(std::string_view key) const;
};

/// Reads the method of a header, whose values may be two, as of value_in_force. Samples that only triangles have are not
/// those of the others.
ToldMethod told_method(std::vector<std::pair<std::string, std::string>> words);

/// Choices made on the command line instead of in the scene: key and value.
using MethodOverrides = std::vector<std::pair<std::string, std::string>>;

/// Reads METHOD, choices in one word: `rounding=truncate` or `fill=top-left,sample=center`. The problem of a text
/// that is none points into it.
Result<MethodOverrides> parse_method(const Source& source);

/// The settings that draw a mistake. It must have some.
MethodOverrides settings_of(const Mistake& mistake);

} // namespace rastertrace
