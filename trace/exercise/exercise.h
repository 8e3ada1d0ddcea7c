// SPDX-License-Identifier: MIT
#pragma once

// Exercises: a scene with its vertices drawn anew, as much work as it was, in which every slip that can be made gives an
// answer of its own. The same ID gives the same exercise everywhere.
//
//     ExerciseMaker like(scene);
//     like.exercise("1:anna").scene.text;  // {"canvas": ..., "vertices": {"A": [1, 6], ...

#include <rastertrace/trace/text/problem.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

struct Exercise {
    std::string id{};
    Source scene{};
    std::vector<std::vector<std::string_view>>
        slips{}; ///< that can be made in it; those in one group give the same answers with any numbers
};

/// Draws the numbers of a scene's vertices anew. Numbers of one axis that were equal stay equal, and smaller ones stay
/// smaller; denominators are at most 8; vertices lie on the canvas, or, of a projected scene, within the box of the old
/// ones; the facts (facts.h) stay.
class ExerciseMaker {
public:
    /// Throws a Problem if the scene cannot be drawn, if it has no vertices of its own, or if no other numbers have its
    /// facts, and says then which fact changed most often.
    explicit ExerciseMaker(const Source& scene);
    ExerciseMaker(ExerciseMaker&&) noexcept;
    ~ExerciseMaker();

    /// Throws a Problem if no numbers are found with which each slip gives an answer of its own.
    Exercise exercise(std::string_view id);

private:
    class Redrawing;
    std::unique_ptr<Redrawing> like_;
};

} // namespace rastertrace
