// SPDX-License-Identifier: MIT
#pragma once

// The next step as a question: which pixels a row has, which pixel is drawn, whether a depth test passes, whether a sample
// lies inside, whether a face is culled; in the language of steps. Pages ask the same, in English (figures/page/player.js).
//
//     const auto question = question_about(replay);   // at the step before
//     question->words;            // "ABC, row y=2: which pixels does it have? from x, to x"
//     is_right(*question, "-1 3");

#include <rastertrace/trace/record/frame.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

struct StepQuestion {
    std::size_t step; ///< that is asked about
    std::string kind; ///< of step
    std::string words;
    std::string right;           ///< "-1 3", or a word
    bool is_about_pixel = false; ///< it can be pointed at
};

/// About the step that a replay has reached; nothing of a step that is only shown.
std::optional<StepQuestion> question_about(const Replay& replay);

/// True of the right numbers, whatever stands between them, and of the right word or its first letters.
bool is_right(const StepQuestion& question, std::string_view answer);

/// What was answered, in the order of asking.
struct GivenAnswer {
    StepQuestion question;
    std::string answer;
    bool is_right;
};

/// A table of the answers: RFC 4180, with a head.
std::string csv_of(const std::vector<GivenAnswer>& answers);

} // namespace rastertrace
