// SPDX-License-Identifier: MIT
#pragma once

// Which rule accounts for the pictures that a renderer has drawn of some scenes.
//
//     const Diagnosis found = diagnose({{scene, cells_of(picture, scene)}}, {});
//     name_of(found.answer.front().rule);  // "height-plus-one"

#include "rule.h"

#include <rastertrace/trace/picture/picture.h>
#include <rastertrace/trace/record/trace.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rastertrace {

/// What is known of the pixels of a picture, row by row from the top.
struct SeenCells {
    int width = 0;
    int height = 0;
    std::vector<Color> colors{}; ///< `no_color` where nothing is drawn
    bool has_colors = true;      ///< else it is only known where something is drawn
    std::uint64_t between =
        0; ///< pixels of an anti-aliased picture whose color lay between two that are known
};

/// A scene, and what a renderer has drawn of it.
struct DrawnPair {
    Source scene;
    SeenCells seen;
};

/// The cells of a picture. What has the color of most pixels that the scene does not draw is not drawn. Of a scene
/// whose colors are not mixed, a color between two of the scene's becomes the nearer one.
SeenCells cells_of(const Picture& picture, const Source& scene);

/// The cells of a trace's last frame.
SeenCells cells_of(const Trace& trace);

struct DiagnoseOptions {
    bool any_convention = false; ///< nobody knows which one was meant
    std::size_t jobs = 1;        ///< threads; the answer does not depend on them
};

/// A rule of an answer, and the known mistakes that always draw the same as far as random scenes tell.
struct AnsweredRule {
    Rule rule{};
    std::vector<const Mistake*> same{};
};

struct Diagnosis {
    std::uint64_t drawn = 0;     ///< pixels that are drawn, in the pictures or as the scenes ask
    std::uint64_t differing = 0; ///< pixels that the scenes' own rules draw otherwise
    std::vector<AnsweredRule>
        answer{}; ///< the best one, and those that draw the same here; none: nothing known
    std::uint64_t unexplained =
        0; ///< pixels that the best rule draws otherwise; of nothing known, the least bad one

    std::optional<Rule> runner_up{}; ///< the next best that draws something else
    std::uint64_t runner_up_unexplained = 0;
    std::size_t pair = 0; ///< of the scenes: that with the pixel which tells both apart
    std::optional<Pixel>
        pixel; ///< on the canvas of that scene: as the best rule draws it, and not as is asked

    bool is_as_asked() const { return differing == 0; }

    /// How much of what differs is explained, 0 to 1.
    double score() const {
        return differing == 0
                   ? 1
                   : 1 - static_cast<double>(unexplained) / static_cast<double>(differing);
    }
};

/// Finds the rule that accounts for the most. A setting is preferred to a mistake that explains no more, and one rule to
/// two of them; what draws the same by two changes more is not told. Nothing is answered if more than a third of what differs, or more than a twentieth of what is drawn,
/// stays unexplained. Throws a Problem if a scene cannot be drawn.
Diagnosis diagnose(std::span<const DrawnPair> pairs, const DiagnoseOptions& options);

} // namespace rastertrace
