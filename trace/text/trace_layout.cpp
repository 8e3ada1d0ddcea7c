// SPDX-License-Identifier: MIT
#include "trace_layout.h"

#include "byte_order_mark.h"
#include "json_scanner.h"

#include <algorithm>
#include <array>
#include <string>

namespace rastertrace {

namespace {

/// True for an object that has the trace's version, and whose last key is `last_key`; for one without steps if
/// that is "".
bool is_header(std::string_view line, std::string_view last_key) {
    JsonScanner fields(line);
    bool has_version = false;
    bool has_steps = false;
    while (fields.next_field()) {
        has_version = has_version || fields.key() == "rastertrace";
        has_steps = has_steps || fields.key() == "steps";
    }
    return !fields.failed() && has_version &&
           (last_key.empty() ? !has_steps : fields.key() == last_key);
}

} // namespace

LineLayout layout_of(std::string_view first_line) {
    // A document's first line ends where its steps begin; that of JSON Lines is an object by itself.
    if (first_line.ends_with('[') && is_header(std::string(first_line) + "]}", "steps"))
        return LineLayout::document;
    return is_header(first_line, "") ? LineLayout::lines : LineLayout::other;
}

bool is_end_line(std::string_view line) {
    JsonScanner fields(line);
    return fields.next_field() && fields.key() == "end";
}

std::string_view first_statement(const Source& source) {
    std::string_view rest = source.view();
    for (;;) {
        rest.remove_prefix(
            std::min(rest.find_first_not_of("\xEF\xBB\xBF \t\r\n\v\f"), rest.size()));
        if (!rest.starts_with('#'))
            break;
        rest.remove_prefix(std::min(rest.find('\n'), rest.size()));
    }
    const std::string_view word = rest.substr(0, std::min<std::size_t>(rest.size(), 64));
    return word.substr(0, word.find_first_of(" \t\r\n\v\f#{[\""));
}

bool begins_obj(std::string_view statement) {
    constexpr std::array<std::string_view, 6> statements{"v", "o", "g", "s", "mtllib", "usemtl"};
    return std::find(statements.begin(), statements.end(), statement) != statements.end();
}

bool is_foreign_scene(const Source& source) {
    const std::string_view first = first_statement(source);
    if (first == "canvas")
        return true;
    // A claim about a vertex v has a colon: `v screen: 2, 5`.
    const std::string_view text = source.view();
    const std::string_view rest = text.substr(static_cast<std::size_t>(first.data() - text.data()));
    const std::string_view line = rest.substr(0, rest.find('\n'));
    return begins_obj(first) && line.find(": ") == std::string_view::npos;
}

bool is_trace(const Source& source) {
    // The key is in the header's first line, whole or cut short; else anywhere in the document.
    std::string_view document = source.view();
    document.remove_prefix(std::min(document.find_first_not_of(blanks_and_mark), document.size()));
    if (!document.starts_with('{'))
        return false;
    if (document.substr(1).starts_with("\"rastertrace\""))
        return true;
    JsonScanner fields(document);
    while (fields.next_field())
        if (fields.key() == "rastertrace")
            return true;
    return false;
}

} // namespace rastertrace
