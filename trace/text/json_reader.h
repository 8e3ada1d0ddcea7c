// SPDX-License-Identifier: MIT
#pragma once

// What the readers of scene files ask of JSON values: the wanted kind of value, or a problem that
// points at it.
//
//     const JsonReader json{source};
//     const Number width = json.number_in(value);  // throws a Problem

#include "json_document.h"
#include "problem.h"

#include <rastertrace/core/draw/scene/transforms.h>
#include <rastertrace/core/numbers/number.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// What may help with a key that is none of `known`: where it belongs, or one that is near.
std::string hint_for_key(std::string_view key, const std::vector<std::string_view>& known);

/// Reads values of one source. What is wrong is thrown as a Problem.
struct JsonReader {
    const Source& source;

    [[noreturn]] void fail(std::size_t offset, std::string message, std::string hint = {}) const;
    [[noreturn]] void fail(const JsonValue& value, std::string message,
                           std::string hint = {}) const {
        fail(value.begin, std::move(message), std::move(hint));
    }

    /// "expected ..., found ...".
    [[noreturn]] void fail_expecting(const JsonValue& value, std::string_view expected,
                                     std::string hint = {}) const;

    /// Fails unless the value is an object that has no other keys. "$schema", if it is one, is a text, and is not told
    /// among the others.
    void allow_keys(const JsonValue& value, std::span<const std::string_view> keys) const;

    /// The value under a key that must be there.
    JsonValue member(const JsonValue& object, std::string_view key) const;

    /// A string that is not empty.
    std::string string_in(const JsonValue& value, std::string_view expected) const;

    JsonElements array_in(const JsonValue& value, std::string_view expected) const;

    /// A JSON number, or a fraction in quotes.
    Number number_in(const JsonValue& value) const;

    /// [x, y, z].
    Numbers3 numbers3_in(const JsonValue& value, std::string_view expected) const;
};

} // namespace rastertrace
