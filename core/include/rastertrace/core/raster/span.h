// SPDX-License-Identifier: MIT
#pragma once

// The rows of a triangle, cut to the canvas, and the pixels of each row from one edge to the other.
// A fill finds them, a painter paints them.
//
//     const auto rows = rows_on_canvas(first_row, last_row, misses_sides, canvas, sink);

#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/steps.h>

#include <algorithm>

namespace rastertrace {

/// Rows of a canvas, counted from the top of the picture.
struct RowRange {
    int begin = 0;
    int end = 0; ///< behind the last one

    bool is_empty() const { return begin == end; }
};

/// Emits the rows above and below the canvas.
template <typename Sink>
requires SinkFor<Sink, PixelsRejected<>>
void tell_rejected_rows(Index first_row, Index last_row, Canvas canvas, Sink&& sink) {
    if (!takes<PixelsRejected<>>(sink))
        return;
    if (first_row < 0)
        sink(rows_off_canvas(canvas.y_of(first_row), canvas.y_of(Index{-1})));
    if (last_row >= canvas.height)
        sink(rows_off_canvas(canvas.y_of(Index{canvas.height}), canvas.y_of(last_row)));
}

/// The rows from `first_row` to `last_row` that are on the canvas. Emits the others. A triangle
/// that lies between two rows, or off the canvas, has none and is skipped. `misses_sides()` is true
/// if all of the triangle lies left of the canvas, or all of it right.
template <typename MissesSides, typename Sink>
requires SinkFor<Sink, PixelsRejected<>, PrimitiveSkipped<>>
[[gnu::always_inline]] inline RowRange rows_on_canvas(Index first_row, Index last_row,
                                                      MissesSides&& misses_sides, Canvas canvas,
                                                      Sink&& sink) {
    if (last_row < first_row) {
        sink(PrimitiveSkipped<>{.why = SkipReason::between_rows});
        return {};
    }
    if (last_row < 0 || first_row >= canvas.height || misses_sides()) {
        sink(PrimitiveSkipped<>{.why = SkipReason::off_canvas});
        return {};
    }
    tell_rejected_rows(first_row, last_row, canvas, sink);
    return {static_cast<int>(std::max<Index>(first_row, 0)),
            static_cast<int>(std::min<Index>(last_row + 1, canvas.height))};
}

/// Pixels of a row, from x = `first` to x = `last`; none if last < first.
struct PixelSpan {
    int first;
    int last;
};

/// The pixels from x = `from` to x = `to` that are on the canvas. `tests_canvas` is false if all of
/// them are known to be.
[[gnu::always_inline]] inline PixelSpan span_on_canvas(const ImageRow& row, Index from, Index to,
                                                       bool tests_canvas) {
    if (!tests_canvas)
        return {static_cast<int>(from), static_cast<int>(to)};
    const Index left = row.left;
    const Index right = row.right;
    return {static_cast<int>(std::clamp(from, left, right + 1)),
            static_cast<int>(std::clamp(to, left - 1, right))};
}

/// Emits the pixels left of the canvas. Called before the row is painted.
template <typename Sink>
requires SinkFor<Sink, PixelsRejected<>>
[[gnu::always_inline]] inline void tell_rejected_left(const ImageRow& row, Index from, Index to,
                                                      Sink&& sink) {
    if (from <= to && from < row.left)
        sink(pixels_off_canvas(from, row.y, std::min<Index>(to, row.left - 1), row.y));
}

/// Emits the pixels right of the canvas. Called after the row is painted.
template <typename Sink>
requires SinkFor<Sink, PixelsRejected<>>
[[gnu::always_inline]] inline void tell_rejected_right(const ImageRow& row, Index from, Index to,
                                                       Sink&& sink) {
    if (from <= to && to > row.right)
        sink(pixels_off_canvas(std::max<Index>(from, row.right + 1), row.y, to, row.y));
}

} // namespace rastertrace
