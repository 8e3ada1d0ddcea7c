// SPDX-License-Identifier: MIT
#pragma once

// Claims in the columns of a table: CSV with `,` or `;`, tabs, Markdown, or a LaTeX tabular. The words over the columns
// say what stands in them.
//
//     AB                      y;left;right            | vertex | x | y |
//     k | p_k | (x, y)        2;-0,25;3,125           |--------|---|---|
//     0 | 4   | (-4, -3)      1;-1;3,5                | A      | 2 | 5 |

#include "claim_line.h"
#include "claims.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

class ClaimColumns {
public:
    /// The columns of the line from `begin` to `end`; nothing if it is not the head of a table. `title` is what stands
    /// over it: the name of the primitive that it is about, or "". Throws a Problem that points at a head nobody knows.
    static std::optional<ClaimColumns> headed(const Source& source, std::size_t begin,
                                              std::size_t end, const std::string& title);

    /// Reads a table that lies on its side: heads in the first column, behind each the numbers. `end` becomes that of its
    /// last line. Nothing if the line from `begin` does not begin one.
    static std::optional<ClaimColumns> turned(const Source& source, std::size_t begin,
                                              std::size_t& end, std::size_t line, CommaUse& commas,
                                              std::vector<Claim>& claims);

    /// Adds what a row claims. False if the line is no row: the table ends before it.
    bool read_row(const Source& source, std::size_t begin, std::size_t end, std::size_t line,
                  CommaUse& commas, std::vector<Claim>& claims);

private:
    /// Where a cell stands in the source.
    struct Cell {
        std::size_t begin;
        std::size_t end;
    };

    std::vector<Cell> cells_of(std::string_view text, std::size_t begin, std::size_t end) const;
    void read_cells(const Source& source, const std::vector<Cell>& cells, std::size_t offset_of_row,
                    std::size_t line, CommaUse& commas, std::vector<Claim>& claims);
    void count_step(Claim& claim, std::size_t row);
    bool has(std::string_view field) const;
    std::string_view step_of_columns() const;

    char separator_ = ',';
    bool is_latex_ = false;
    std::vector<std::string_view>
        columns_; ///< the field in each: "" is not claimed, "place" is (x, y)
    std::string title_;
    std::string_view step_;
    bool is_printed_ = false; ///< the heads are the fields of a step, as `show` prints them
    std::size_t rows_ = 0;    ///< that were read
    int first_step_ = 0;      ///< what k of the first step is
};

} // namespace rastertrace
