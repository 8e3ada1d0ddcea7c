// SPDX-License-Identifier: MIT
#pragma once

// The steps of a trace as rows of one table, for databases and data frames: a column for each field that a step may
// have, each column of one type. docs/big-traces.md tells the columns.
//
//     FlatSteps flat(output, FlatForm::lines);
//     write_trace(scene, {.layout = TraceLayout::jsonl}, flat);
//     flat.finish();
//
// Memory does not grow with the steps.

#include <rastertrace/trace/text/output.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// The version of the columns, which each row tells. It grows when a column is renamed, gets another type or ends; a
/// new column is none of these.
inline constexpr int flat_version = 1;

/// How rows are written.
enum class FlatForm : std::uint8_t {
    lines, ///< JSON Lines: an object a row, without the columns that it has no value in
    csv,   ///< RFC 4180, with a row of names in front
};

/// What a column holds.
enum class FlatType : std::uint8_t {
    whole,   ///< whole numbers within +-2^53
    number,  ///< doubles
    boolean, ///< true or false
    text,
};

/// The type in the words of SQL: BIGINT, DOUBLE, BOOLEAN, VARCHAR.
std::string_view sql_name(FlatType type);

struct FlatColumn {
    std::string name;
    FlatType type;
    std::vector<std::string_view>
        kinds; ///< of steps that may have a value; none: steps of any kind
};

/// All columns, in their order: those of every row, those of the fields in traced_steps.h, and two for what a foreign
/// rasterizer has added.
const std::vector<FlatColumn>& flat_columns();

/// Takes a trace in JSON Lines, and writes its steps to another output.
class FlatSteps final : public Output {
public:
    FlatSteps(Output& to, FlatForm form);
    ~FlatSteps() override;

    /// Takes the next bytes of the trace, which need not end with a line.
    void write(std::string_view bytes) override;

    /// Writes what is left: to be called behind the last byte.
    void finish();

private:
    class Row;

    void take_line(std::string_view line);

    Output& to_;
    FlatForm form_;
    std::unique_ptr<Row> row_;
    std::string line_; ///< the beginning of a line whose end is not there yet
    std::string text_; ///< of rows that are not written yet
    std::int64_t steps_ = 0;
    bool is_behind_header_ = false;
};

} // namespace rastertrace
