// SPDX-License-Identifier: MIT
#pragma once

// The options that say what an exercise is like: --like, --kind.

#include "command.h"

#include <rastertrace/trace/text/input.h>

#include <string>

namespace rastertrace {

class ExerciseOptions {
public:
    void add_to(OptionList& options, bool is_required);

    /// Throws a Problem for a kind that there is not.
    void read() const;

    bool are_given() const { return !like_.empty() || !kind_.empty(); }

    /// The scene that exercises are like. Throws a Problem.
    Source scene() const;

private:
    std::string like_;
    std::string kind_;
};

} // namespace rastertrace
