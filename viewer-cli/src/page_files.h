// SPDX-License-Identifier: MIT
#pragma once

// The files that a page's command writes: a page that is checked leaves them alone, and tells which of them are stale.
//
//     const OutputElsewhere elsewhere({"figure", "scene.json", "-o", "docs/a.svg"});
//     run_self(elsewhere.words());          // writes a file of that name in a folder of its own
//     elsewhere.stale_files();              // {"docs/a.svg"} if that is not the same

#include <filesystem>
#include <string>
#include <vector>

namespace rastertrace {

/// A command whose output goes to a folder that is removed in the end.
class OutputElsewhere {
public:
    /// `words` has -o, see writes_file. Throws a Problem if there can be no folder.
    explicit OutputElsewhere(std::vector<std::string> words);
    OutputElsewhere(const OutputElsewhere&) = delete;
    OutputElsewhere& operator=(const OutputElsewhere&) = delete;
    ~OutputElsewhere();

    const std::vector<std::string>& words() const { return words_; }

    /// The files that the command would have written, in the order of their names.
    std::vector<std::string> written_files() const;

    /// Those of an earlier run that it writes no more: the one file where it now writes a sequence, and what is left of a
    /// whole sequence, from number 1 on.
    std::vector<std::string> left_over_files() const;

    /// The files that the command would have written, and that have other bytes or are not there, in the order of their
    /// names.
    std::vector<std::string> stale_files() const;

private:
    std::vector<std::string> words_;
    std::filesystem::path folder_;
    std::filesystem::path final_folder_;
    std::filesystem::path name_; ///< of the output
};

/// True if a command writes a file that is the same each time: a figure or a trace with -o.
bool writes_file(const std::vector<std::string>& words);

} // namespace rastertrace
