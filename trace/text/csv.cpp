// SPDX-License-Identifier: MIT
#include "csv.h"

#include "text.h"

#include <rastertrace/core/numbers/number.h>

#include <string_view>
#include <variant>

namespace rastertrace {

namespace {

/// A number or a fraction.
bool is_number(std::string_view text) {
    return std::holds_alternative<Number>(parse_number(text, NumberSize::any));
}

std::string csv_field(std::string_view text) {
    std::string field = printable(text);
    if (!field.empty() && std::string_view("=+-@").find(field.front()) != std::string_view::npos &&
        !is_number(field))
        field.insert(0, "'");
    if (field.find_first_of(",\"\r\n") == std::string::npos)
        return field;
    std::string quoted = "\"";
    for (const char c : field) {
        if (c == '"')
            quoted += c;
        quoted += c;
    }
    return quoted + '"';
}

} // namespace

void put_csv_line(std::string& text, const std::vector<std::string>& fields) {
    std::string_view separator;
    for (const std::string& field : fields) {
        text += separator;
        text += csv_field(field);
        separator = ",";
    }
    text += "\r\n";
}

} // namespace rastertrace
