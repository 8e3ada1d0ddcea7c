// SPDX-License-Identifier: MIT
#pragma once

// Primitives drawn again by the book, from their corners in the trace. What is told of each is held against that, field
// by field (traced_steps.h).
//
//     DrawnAgain drawn(trace, findings);
//     drawn.redo(n, last);  // the primitive that begins with step n, and its steps up to `last`

#include "redo_findings.h"

#include <rastertrace/core/draw/plan/stages.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/draw/tell/listener.h>
#include <rastertrace/core/raster/depth_buffer.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rastertrace {

/// The depths of a larger picture are not done again: they would take more than 100 MB.
inline constexpr std::size_t most_depths_redone = std::size_t{1} << 22;

/// How far a number that is worked out in another order may be off, of its largest summand. (`adaptive`: or in other
/// numbers.)
inline constexpr double largest_rounding = 0x1p-36;

/// A primitive as it is told, and what else its drawing needs.
struct ToldPiece {
    PrimitiveStep step;
    PrimitiveKind kind;
    std::size_t primitive = 0; ///< in the scene
    std::vector<std::string> names;
    std::vector<std::size_t> vertices = {};
    std::vector<Color> colors = {};
    std::vector<TracedNumber> w = {}; ///< of the vertices, in a perspective
    PixelStages stages = {};
};

class Steps;

class DrawnAgain {
public:
    DrawnAgain(const Trace& trace, Findings& findings);

    /// False, and nothing is done, if the trace does not tell a number or a rule that the primitive is drawn by.
    bool redo(std::size_t first, std::size_t last);

    /// Takes the w of a vertex.
    void see(const VertexStep& step);

private:
    void find_depths();
    bool tells_rules(PrimitiveKind kind) const;
    bool tests_faces() const;
    ToldPiece piece_at(std::size_t n);
    bool draw(const ToldPiece& piece, Steps& steps);
    void compare(const Steps& again, std::size_t first, std::size_t last);
    bool compare_kind(const std::vector<StepView>& drawn, const std::vector<std::size_t>& told,
                      StepKind kind);
    bool adds_up(StepKind kind) const;
    bool compare_steps(const StepView& again, std::size_t n, StepKind kind);
    bool are_alike(std::string_view again, std::string_view told, const StepField& field) const;

    /// Draws in one kind of number.
    using Draw = std::function<bool(const ToldPiece&, const Listener&)>;
    template <typename Scalar> Draw drawing_in();

    const Trace& trace_;
    const ToldMethod& rules_;
    Findings& findings_;
    Scene scene_;
    DepthRegion region_;
    bool larger_passes_ = false;
    std::optional<TracedNumber> cleared_; ///< the depth that nothing has drawn
    Draw draw_;
    Draw draw_in_fractions_; ///< `adaptive`: primitives that are told so
    std::map<std::string, std::size_t> vertices_;
    std::map<std::string, TracedNumber> w_;
    std::string color_;          ///< of the primitive, as JSON
    bool depths_differ_ = false; ///< of a primitive that was drawn: those behind it hang on that
    bool mixes_numbers_ = false; ///< `adaptive` tells some depths in numbers, and some in fractions
    bool is_open_ = false;       ///< then fractions that are not told may have decided a test,
    bool is_thin_open_ = false;  ///< or any, of a point or line
};

} // namespace rastertrace
