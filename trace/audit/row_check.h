// SPDX-License-Identifier: MIT
#pragma once

// Holds each scanline step against the steps that belong to it: the pixels from `from` to `to`, and no
// others, were plotted, hidden or rejected, each once.
//
//     RowCheck rows;
//     rows.begin(trace.step(3).as<ScanlineStep>(), 3, "ABC");
//     rows.add(trace.step(4).as<PixelStep>());
//     rows.close();
//     rows.wrong();

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
    /// Takes step n, a row of a primitive of that name.
    void begin(const ScanlineStep& row, std::size_t n, const std::string& primitive);

    /// Takes the next step, of one of the kinds that rows have.
    void add(const PixelStep& plotted);
    void add(const DepthStep& test);
    void add(const RejectStep& dropped);

    /// Judges the row that is open, if one is: in front of a step of any other kind, and at the end of a whole trace.
    void close();

    /// The rows so far that are wrong.
    const std::vector<WrongRow>& wrong() const { return wrong_; }

private:
    /// Notes pixels that a step of the row is about.
    void note(Index y, Index from, Index to);

    std::vector<WrongRow> wrong_;
    std::optional<WrongRow> row_;                ///< the one that is open
    std::vector<std::pair<Index, Index>> spans_; ///< from x to x, of its own row
    std::uint64_t elsewhere_ = 0;                ///< pixels of another y
};

} // namespace rastertrace
