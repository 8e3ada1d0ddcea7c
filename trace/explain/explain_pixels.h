// SPDX-License-Identifier: MIT
#pragma once

// Why pixels are as they are, of many pixels of one trace: what explain() answers of each, without the steps that tried
// to write it.
//
//     PixelExplainer pixels(trace);
//     pixels.explain({4, 2}).why_not[0].sentence;  // "AC ends row y=2 at x = 25/8 -> floor -> 3; ..."

#include "explain.h"

#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/trace/record/trace.h>

#include <optional>
#include <string>
#include <vector>

namespace rastertrace {

class PixelExplainer {
public:
    /// The trace must outlive the explainer.
    explicit PixelExplainer(const Trace& trace);

    /// The answer, and of each primitive that has not drawn the pixel, why: as explain() has them, but without tries
    /// and workings. Fastest row by row. The pixel is one of the canvas.
    Explanation explain(Pixel pixel);

private:
    const Trace& trace_;
    std::vector<std::string> sentences_; ///< of the steps that answers quote, by their numbers
    std::optional<Trace> row_;           ///< the steps that matter to the pixels of a row ...
    int y_ = 0;                          ///< ... this one
};

} // namespace rastertrace
