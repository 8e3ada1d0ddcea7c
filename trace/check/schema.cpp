// SPDX-License-Identifier: MIT
#include "schema.h"

#include <cstddef>

namespace rastertrace {

// The files docs/*.schema.json, as the build has put them into the program (cmake/embed.cmake).
std::string scene_schema_json();
std::string trace_schema_json();
std::string claims_schema_json();

namespace {

struct SchemaRow {
    std::string_view name;
    std::string (*text)();
};
constexpr std::array<SchemaRow, schema_kinds.size()> rows{
    {{"scene", scene_schema_json}, {"trace", trace_schema_json}, {"claims", claims_schema_json}}};

const SchemaRow& row_of(SchemaKind kind) {
    return rows[static_cast<std::size_t>(kind)];
}

} // namespace

std::string_view name_of(SchemaKind kind) {
    return row_of(kind).name;
}

std::optional<SchemaKind> schema_kind_named(std::string_view name) {
    for (const SchemaKind kind : schema_kinds)
        if (name_of(kind) == name)
            return kind;
    return std::nullopt;
}

std::vector<std::string_view> schema_kind_names() {
    std::vector<std::string_view> names;
    for (const SchemaRow& row : rows)
        names.push_back(row.name);
    return names;
}

std::string schema_of(SchemaKind kind) {
    return row_of(kind).text();
}

} // namespace rastertrace
