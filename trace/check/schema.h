// SPDX-License-Identifier: MIT
#pragma once

// JSON Schemas (draft 07) of the files that people write: what an editor needs to complete keys, to say what they
// mean, and to mark what is wrong. They stand in docs.
//
//     schema_of(SchemaKind::scene);  // {"$schema": "http://json-schema.org/draft-07/schema#", ...
//
// A schema knows less than a reader: not which names there are, and nothing that hangs on the size of two numbers.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// The files that have a schema.
enum class SchemaKind {
    scene,
    trace,  ///< a whole document, or one line of JSON Lines
    claims, ///< those in JSON
};

inline constexpr std::array schema_kinds{SchemaKind::scene, SchemaKind::trace, SchemaKind::claims};

/// scene, trace or claims.
std::string_view name_of(SchemaKind kind);

/// The kind of that name, if there is one.
std::optional<SchemaKind> schema_kind_named(std::string_view name);

/// All three names.
std::vector<std::string_view> schema_kind_names();

/// The schema of one kind of file, as indented text with a newline at its end.
std::string schema_of(SchemaKind kind);

} // namespace rastertrace
