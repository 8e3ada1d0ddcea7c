// SPDX-License-Identifier: MIT
#pragma once

// JSON with a memory of where everything stood, so that a wrong value can be pointed at.
// nlohmann-json reads the grammar and checks the UTF-8; this adds the places, keeps numbers as
// typed, and refuses what it would let pass in silence: repeated keys, and nesting without end.

#include <rastertrace/trace/problem.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// A JSON value and the bytes of the source that it was read from.
struct JsonValue {
    enum class Kind { null, boolean, number, string, array, object };

    Kind kind = Kind::null;
    std::size_t begin = 0; ///< offset of its first byte in the source
    std::size_t end = 0;   ///< offset behind its last byte
    std::string text; ///< of a string: decoded; of a number: as typed; of a boolean: true, false
    std::vector<JsonValue> keys;  ///< of an object, in order: strings
    std::vector<JsonValue> items; ///< of an array: its elements; of an object: one value per key

    /// The value under a key of an object, or nullptr.
    const JsonValue* find(std::string_view key) const;
};

/// How deep arrays and objects may be nested.
inline constexpr std::size_t deepest_json = 64;

/// Reads the whole of a source as one JSON value. `begin` and `size` choose a part of it instead;
/// places are still those of the whole source.
Result<JsonValue> parse_json(const Source& source, std::size_t begin = 0,
                             std::size_t size = std::string_view::npos);

/// What a value is, in words: `number 5`, `"five"`, `an array`.
std::string described(const JsonValue& value);

} // namespace rastertrace
