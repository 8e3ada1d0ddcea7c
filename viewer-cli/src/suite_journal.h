// SPDX-License-Identifier: MIT
#pragma once

// The journal of a suite: a line for each case as soon as it has been run, with all files that it read. A run that was
// ended goes on from there, and a case whose files are as they were is not run again.
//
//     SuiteJournal journal("suite.journal", "--only pixel");  // throws a Problem
//     if (!journal.find(one))
//         journal.add(one, paths, result_of(one, rules));

#include "suite_cases.h"
#include "suite_results.h"

#include <rastertrace/trace/text/descriptor.h>

#include <cstddef>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

class SuiteJournal {
public:
    /// Opens the journal at a path, or begins one. `asked` is all that results depend on besides files. Throws a Problem
    /// for another file, and for a journal that another run has open.
    SuiteJournal(const std::string& path, const std::string& asked);

    /// The result of a case, if it has been run, was asked for the same, and no file that it read has changed since.
    std::optional<SuiteResult> find(const SuiteCase& one) const;

    /// Adds a result, and the files that were read for it. May be called by several threads. Throws a Problem.
    void add(const SuiteCase& one, const std::vector<std::string>& read, const SuiteResult& result);

private:
    /// A result, and the hash of each file that it depends on.
    struct Entry {
        std::map<std::string, std::string> files{};
        SuiteResult result{};
    };

    void read(const Source& source);
    void write(std::string_view line);
    void cut() const;

    std::string path_;
    std::string asked_; ///< as a hash
    Descriptor file_;
    std::size_t size_ = 0; ///< of its whole lines, in bytes
    std::mutex mutex_;
    std::map<std::string, Entry> entries_; ///< by the names of the cases
};

} // namespace rastertrace
