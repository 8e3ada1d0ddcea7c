// SPDX-License-Identifier: MIT
#pragma once

// Holds each scanline step against the steps that belong to it: the pixels from `from` to `to`, and no
// others, were plotted, hidden or rejected, each once.
//
//     RowCheck rows(stats.wrong_rows);
//     for (std::size_t n = 1; n <= trace.size(); ++n)
//         rows.add(any_step(trace.step(n), *trace.kind_of(n)), n, "ABC");

#include "stats.h"

#include <rastertrace/trace/record/traced_steps.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {

class RowCheck {
public:
    /// Rows that are wrong are added to `wrong`.
    explicit RowCheck(std::vector<WrongRow>& wrong) : wrong_(wrong) {}

    /// Takes step n, which belongs to a primitive of that name. Steps come in order.
    void add(const AnyStep& step, std::size_t n, const std::string& primitive);

    /// Judges the last row: behind a step of another kind than ours, too. Not called if the trace may have been cut off
    /// within it.
    void close();

private:
    /// Notes what a step did to pixels, if it belongs to a row.
    bool belongs(const AnyStep& step);

    /// Notes pixels that a step of the row is about.
    void note(Index y, Index from, Index to);

    std::vector<WrongRow>& wrong_;
    std::optional<WrongRow> row_;                ///< the one that is open
    std::vector<std::pair<Index, Index>> spans_; ///< from x to x, of its own row
    std::uint64_t elsewhere_ = 0;                ///< pixels of another y
};

} // namespace rastertrace
