// SPDX-License-Identifier: MIT
#pragma once

// What schemas are put together from. The form of a key (json_key.h) is the name of a definition in its schema.
//
//     definitions["rotate"] = object_with(rotate_keys);
//     definitions["origin"] = one_of(origin_words());

#include "json_key.h"

#include <nlohmann/json.hpp>

#include <span>
#include <string>
#include <string_view>

namespace rastertrace {

using Json = nlohmann::ordered_json; ///< keys stay in the order in which they are added

/// An object that has these keys and no others.
Json object_with(std::span<const JsonKey> keys);

/// The same, but other keys may have any values.
Json open_object_with(std::span<const JsonKey> keys);

/// What a definition says, with a line for people if there is one.
Json reference_to(std::string_view form, std::string_view meaning = {});

/// One of some words. Editors tell what each means beside it, by "enumDescriptions", which JSON Schema passes over.
Json one_of(std::span<const JsonWord> words);

/// A list whose elements a definition describes, of so many at least.
Json list_of(std::string_view form, std::size_t least = 0);

/// An object in which every value is of a form, whatever its key is.
Json map_to(std::string_view form);

/// A text of at least one character.
Json text_schema();

/// A number in quotes, as parse_number (number.h) takes it: a regular expression.
std::string_view number_pattern();

/// A JSON number in the range of double, or one in quotes.
Json number_schema();

/// #rgb, #rrggbb, #rrggbbaa, or a name of CSS 2.1. `with_alpha` describes the two digits of alpha.
Json color_schema(std::string_view with_alpha);
inline constexpr std::string_view any_alpha = "[0-9a-fA-F]{2}";
inline constexpr std::string_view visible_alpha = "(?!00)[0-9a-fA-F]{2}"; ///< not 00

/// {"width", "height", "origin"}, with the definitions that it needs.
void define_canvas(Json& definitions);

/// The beginning of a schema: what it is for.
Json schema_titled(std::string_view title, std::string_view description);

/// A schema as indented text with a newline at its end.
std::string schema_text(const Json& schema);

} // namespace rastertrace
