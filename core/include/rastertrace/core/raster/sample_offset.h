// SPDX-License-Identifier: MIT
#pragma once

// Where the samples of pixels lie (canvas.h), as the algorithms ask for it. Which pixel is nearest to a
// point, and which rows and columns a row or an edge meets, is asked in columns and rows: there the samples
// are the whole numbers.
//
//     const SampleOffset<double> center(0.5, 0.5);
//     center.x_of(3);          // 3.5, the x of the samples of column 3
//     center.in_columns(3.5);  // 3

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/canvas.h>

namespace rastertrace {

/// From the integer point of a pixel to its sample, in the scene's x and y. Where that is 0, numbers keep
/// their form, and cost nothing.
template <typename Scalar> class SampleOffset {
public:
    /// Samples at integer points.
    SampleOffset() : SampleOffset(scalar_from<Scalar>(0), scalar_from<Scalar>(0)) {}
    SampleOffset(const Scalar& x, const Scalar& y)
        : x_(x), y_(y), moves_x_(x != scalar_from<Scalar>(0)),
          moves_y_(y != scalar_from<Scalar>(0)) {}

    const Scalar& x() const { return x_; }
    const Scalar& y() const { return y_; }

    /// The x of the samples of a column, and the y of those of a row.
    Scalar x_of(Index column) const { return sum(scalar_from<Scalar>(column), x_, moves_x_); }
    Scalar y_of(Index row) const { return sum(scalar_from<Scalar>(row), y_, moves_y_); }

    /// A coordinate in columns, or in rows.
    Scalar in_columns(const Scalar& x) const { return difference(x, x_, moves_x_); }
    Scalar in_rows(const Scalar& y) const { return difference(y, y_, moves_y_); }

    /// The sample of a pixel.
    Vec<Scalar, 2> sample_of(Pixel pixel) const {
        return {Scalar(scalar_from<Scalar>(pixel.x) + x_),
                Scalar(scalar_from<Scalar>(pixel.y) + y_)};
    }

private:
    static Scalar sum(const Scalar& a, const Scalar& b, bool moves) {
        return moves ? Scalar(a + b) : a;
    }
    static Scalar difference(const Scalar& a, const Scalar& b, bool moves) {
        return moves ? Scalar(a - b) : a;
    }

    Scalar x_;
    Scalar y_;
    bool moves_x_;
    bool moves_y_;
};

} // namespace rastertrace
