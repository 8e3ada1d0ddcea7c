// SPDX-License-Identifier: MIT
#include <rastertrace/trace/primitive_name.h>

namespace rastertrace {

std::string_view name_of(PrimitiveKind kind) {
    switch (kind) {
    case PrimitiveKind::point:
        return "point";
    case PrimitiveKind::line:
        return "line";
    case PrimitiveKind::outline:
        return "outline";
    case PrimitiveKind::triangle:
        break;
    }
    return "triangle";
}

} // namespace rastertrace
