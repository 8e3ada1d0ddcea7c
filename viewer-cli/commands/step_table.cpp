// SPDX-License-Identifier: MIT
#include "commands/step_table.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/text/csv.h>
#include <rastertrace/trace/text/json_scanner.h>
#include <rastertrace/trace/text/named_value.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <array>
#include <cstddef>

namespace rastertrace {

namespace {

constexpr std::array<std::string_view, 4> table_formats{"table", "markdown", "csv", "json"};

/// A value as a text; a list as (1, 2), one of lists as ((1, 2), (3, 4)).
std::string text_of(std::string_view json) {
    if (!json.starts_with('['))
        return plain_text(json);
    std::vector<std::string> texts;
    for (const TracedValue& value : TracedList<TracedValue>(json).values())
        texts.push_back(text_of(value.json()));
    return fmt::format("({})", joined(texts, ", "));
}

/// The text of a cell in Markdown: printable, on one line; a bar would end the cell.
std::string in_markdown(const std::string& text) {
    std::string escaped;
    for (const char c : printable(text))
        escaped += c == '|' ? "\\|" : std::string(1, c);
    return escaped;
}

std::string csv_line(const std::vector<std::string>& cells) {
    std::string line;
    put_csv_line(line, cells);
    return line;
}

} // namespace

std::vector<std::string_view> table_format_names() {
    return {table_formats.begin(), table_formats.end()};
}

std::optional<TableFormat> table_format_named(std::string_view name) {
    return value_named<TableFormat>(table_formats, name);
}

bool is_told_as_table(StepKind kind) {
    switch (kind) {
    case StepKind::vertex:
    case StepKind::face:
    case StepKind::light:
    case StepKind::depth:
    case StepKind::sample:
    case StepKind::decide:
        return true;
    default:
        return false;
    }
}

std::string StepTable::head() const {
    std::vector<std::string> columns{"step"};
    for (const StepField& field : fields_of(row_.kind))
        columns.emplace_back(field.name);
    switch (format_) {
    case TableFormat::markdown: {
        std::string rule = "|";
        for (std::size_t i = 0; i < columns.size(); ++i)
            rule += "---|";
        return fmt::format("| {} |\n{}\n", joined(columns, " | "), rule);
    }
    case TableFormat::csv:
        return csv_line(columns);
    case TableFormat::json:
        return "[";
    case TableFormat::table:
        break;
    }
    return {};
}

std::string StepTable::line(const Replay& replay) {
    const StepView step = replay.trace().step(replay.step());
    std::vector<std::string> cells{std::to_string(replay.step())};
    for (const StepField& field : fields_of(row_.kind))
        cells.push_back(text_of(step.field(field.name).value_or("")));
    const bool is_first = is_first_;
    is_first_ = false;
    switch (format_) {
    case TableFormat::markdown:
        std::transform(cells.begin(), cells.end(), cells.begin(), in_markdown);
        return fmt::format("| {} |\n", joined(cells, " | "));
    case TableFormat::csv:
        return csv_line(cells);
    case TableFormat::json:
        return fmt::format("{}{}", is_first ? "\n" : ",\n", step.json());
    case TableFormat::table:
        break;
    }
    return fmt::format("{:>4}  {}\n", replay.step(), describe_step(replay));
}

std::string StepTable::end() const {
    return format_ == TableFormat::json ? "\n]\n" : "";
}

} // namespace rastertrace
