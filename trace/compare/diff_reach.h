// SPDX-License-Identifier: MIT
#pragma once

// Which pixels of the final pictures differ because of the first step that does.
//
//     const DiffReach reach(first);
//     reach.has({3, 2}, owner);

#include "diff_tally.h"

#include <rastertrace/core/raster/canvas.h>

#include <string>
#include <vector>

namespace rastertrace {

/// A primitive that owns pixels.
struct OwnerOfPixels {
    std::string name{};
    std::string face{};                  ///< "ABC" of a part "ABC/1"
    std::vector<std::string> vertices{}; ///< of the face
};

/// The owner that step n, a `primitive`, begins, if it is no part; one without a name for 0.
OwnerOfPixels owner_in(const Trace& trace, std::size_t n);

class DiffReach {
public:
    /// The first difference of two traces.
    DiffReach(const FirstDifference& first, const Trace& a, const Trace& b);

    /// True if a pixel that is an owner's, in one of the traces, differs because of the first difference: one of the
    /// same row, pixel or primitive; of a vertex, one of its primitives; of a matrix or the painter's order, any.
    bool has(Pixel pixel, const OwnerOfPixels& owner) const;

private:
    bool reaches(const KeyedStep& step, Pixel pixel, const OwnerOfPixels& owner) const;

    const FirstDifference& first_;
    std::vector<std::string> faces_; ///< of the first difference, in a and in b
};

} // namespace rastertrace
