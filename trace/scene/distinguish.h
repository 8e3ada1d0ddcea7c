// SPDX-License-Identifier: MIT
#pragma once

// Scenes that tell candidates apart: the slips that somebody makes, or the rules that a renderer follows. Each candidate
// gives an answer in a scene; those that give the same in all scenes are one class.
//
//     Classes classes(2);
//     classes.split({"-1/4", "-1/4"});  // 1
//     classes.split({"0", "1/2"});      // 2

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace rastertrace {

/// What each candidate gives in one scene; none where it cannot be made, or nothing can be drawn.
using Answers = std::vector<std::optional<std::string>>;

/// True if every candidate gives an answer, and no two the same.
bool tells_all_apart(const Answers& answers);

/// Candidates in classes: one class at first, split by each scene's answers.
class Classes {
public:
    explicit Classes(std::size_t candidates) : classes_(candidates, 0) {}

    /// Splits by the answers in one more scene. How many classes there are then.
    std::size_t split(const Answers& answers);

    /// The same by classes that other scenes made.
    std::size_t split(const Classes& others);

    /// The candidates of each class: a class stands where its first one does.
    std::vector<std::vector<std::size_t>> members() const;

private:
    std::vector<std::size_t>
        classes_; ///< of each candidate, numbered in the order in which they occur
};

/// The first scene that tells all candidates apart, of those that `next()` gives until it gives `nullopt`.
/// `answers_in(scene)` is what the candidates give.
template <typename NextScene, typename AnswersIn>
auto first_to_tell_apart(NextScene&& next, const AnswersIn& answers_in) -> decltype(next()) {
    for (auto scene = next(); scene; scene = next())
        if (tells_all_apart(answers_in(*scene)))
            return scene;
    return std::nullopt;
}

} // namespace rastertrace
