// SPDX-License-Identifier: MIT
#include "row_check.h"

#include <algorithm>
#include <cstdint>

namespace rastertrace {

void RowCheck::begin(const ScanlineStep& row, std::size_t n, const std::string& primitive) {
    close();
    row_ = {.step = n, .primitive = primitive, .y = row.y, .from = row.from, .to = row.to};
}

void RowCheck::add(const PixelStep& plotted) {
    note(plotted.y, plotted.x, plotted.x);
}

void RowCheck::add(const DepthStep& test) {
    // A depth test that is passed is followed by its pixel.
    if (!test.pass.is_true())
        note(test.y, test.x, test.x);
}

void RowCheck::add(const RejectStep& dropped) {
    if (dropped.x && dropped.y && !dropped.to_y)
        note(*dropped.y, *dropped.x, dropped.to_x.value_or(*dropped.x));
    else
        close(); // whole rows, or a part of a line
}

void RowCheck::note(Index y, Index from, Index to) {
    if (!row_)
        return;
    if (y == row_->y && from <= to)
        spans_.emplace_back(from, to);
    else
        ++elsewhere_;
}

void RowCheck::close() {
    if (!row_)
        return;

    // Of the pixels that were told, from left to right, each that is due counts once.
    if (!std::is_sorted(spans_.begin(), spans_.end()))
        std::sort(spans_.begin(), spans_.end());
    std::uint64_t told = elsewhere_;
    std::uint64_t due = 0;
    Index next = row_->from;
    for (const auto& [first, last] : spans_) {
        told += static_cast<std::uint64_t>(last - first + 1);
        const Index begin = std::max(first, next);
        const Index end = std::min(last, row_->to);
        if (begin <= end) {
            due += static_cast<std::uint64_t>(end - begin + 1);
            next = end + 1;
        }
    }
    const auto all = static_cast<std::uint64_t>(std::max<Index>(row_->to - row_->from + 1, 0));
    row_->missing = all - due;
    row_->others = told - due;
    if (row_->missing > 0 || row_->others > 0)
        wrong_.push_back(std::move(*row_));

    row_.reset();
    spans_.clear();
    elsewhere_ = 0;
}

} // namespace rastertrace
