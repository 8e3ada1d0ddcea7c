// SPDX-License-Identifier: MIT
#pragma once

// The files that a page's command writes: a page that is checked leaves them alone, and tells which of them are stale.
//
//     const OutputsElsewhere elsewhere;
//     run_self(words, {.files = {.below = {}, .outputs = elsewhere.folder()}});
//     elsewhere.stale_files();              // {"docs/a.svg"} if that is not the same

#include "temporary_folder.h"

#include <string>
#include <vector>

namespace rastertrace {

/// A folder for what a command writes, see FileRules::outputs. It is removed in the end.
class OutputsElsewhere {
public:
    /// Throws a Problem if there can be no folder.
    OutputsElsewhere();

    std::string folder() const { return temporary_.path().string(); }

    /// The files that the command would have written, in the order of their names.
    std::vector<std::string> written_files() const;

    /// Those of an earlier run of a command with these words that it writes no more: the one file where it now writes a
    /// sequence, and what is left of a whole sequence, from number 1 on.
    std::vector<std::string> left_over_files(const std::vector<std::string>& words) const;

    /// The files that the command would have written, and that have other bytes or are not there, in the order of their
    /// names.
    std::vector<std::string> stale_files() const;

private:
    TemporaryFolder temporary_;
};

} // namespace rastertrace
