// SPDX-License-Identifier: MIT
#pragma once

// Many steps of one kind as a table, one line for each.
//
//     StepTable table(TableFormat::csv, StepKind::light);
//     table.head(); table.line(replay); table.line(replay); table.end();

#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/step_kind.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

enum class TableFormat : std::uint8_t {
    table,    ///< the step's number and its sentence
    markdown, ///< a column for each field
    csv,      ///< the same: RFC 4180
    json,     ///< an array of the steps as the trace has them
};

/// table, markdown, csv, json
std::vector<std::string_view> table_format_names();
std::optional<TableFormat> table_format_named(std::string_view name);

/// True of the kinds that a trace has so many of that a frame for each would be too long.
bool is_told_as_table(StepKind kind);

class StepTable {
public:
    StepTable(TableFormat format, StepKind kind) : format_(format), row_(row_of(kind)) {}

    /// What stands before the first line, and behind the last one.
    std::string head() const;
    std::string end() const;

    /// The step that a replay has reached.
    std::string line(const Replay& replay);

private:
    TableFormat format_;
    const StepRow& row_;
    bool is_first_ = true;
};

} // namespace rastertrace
