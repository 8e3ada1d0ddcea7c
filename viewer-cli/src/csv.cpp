// SPDX-License-Identifier: MIT
#include "csv.h"

#include <rastertrace/trace/text.h>

#include <charconv>
#include <string_view>
#include <system_error>

namespace rastertrace {

namespace {

bool is_number(std::string_view text) {
    double value = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    return read.ec == std::errc{} && read.ptr == text.data() + text.size();
}

/// A field of a CSV file: in quotes if it has to be. A spreadsheet would take a name like "=1+1" for
/// a formula and run it; behind an apostrophe it is text.
std::string csv_field(std::string_view text) {
    std::string field = printable(text);
    if (!field.empty() && std::string_view("=+-@").find(field.front()) != std::string_view::npos &&
        !is_number(field))
        field.insert(0, "'");
    if (field.find_first_of(",\"\r\n") == std::string::npos)
        return field;
    std::string quoted = "\"";
    for (const char c : field)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
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
