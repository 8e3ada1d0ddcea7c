// SPDX-License-Identifier: MIT
#include "schema.h"

#include "schema_claims.h"
#include "schema_trace.h"

#include <rastertrace/trace/scene/schema_scene.h>

namespace rastertrace {

std::string_view name_of(SchemaKind kind) {
    switch (kind) {
    case SchemaKind::scene:
        return "scene";
    case SchemaKind::trace:
        return "trace";
    case SchemaKind::claims:
        break;
    }
    return "claims";
}

std::optional<SchemaKind> schema_kind_named(std::string_view name) {
    for (const SchemaKind kind : schema_kinds)
        if (name_of(kind) == name)
            return kind;
    return std::nullopt;
}

std::vector<std::string_view> schema_kind_names() {
    std::vector<std::string_view> names;
    for (const SchemaKind kind : schema_kinds)
        names.push_back(name_of(kind));
    return names;
}

std::string schema_of(SchemaKind kind) {
    switch (kind) {
    case SchemaKind::scene:
        return scene_schema();
    case SchemaKind::trace:
        return trace_schema();
    case SchemaKind::claims:
        break;
    }
    return claims_schema();
}

} // namespace rastertrace
