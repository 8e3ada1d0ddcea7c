// SPDX-License-Identifier: MIT
#pragma once

// The cases of a suite: the scenes, traces and claims in a folder. docs/regression-tests.md has the rules.
//
//     for (const SuiteCase& one : cases_below("tests"))
//         runner.result_of(one).outcome;

#include "commands.h"
#include "driven_program.h"
#include "suite_results.h"

#include <optional>
#include <string>
#include <vector>

namespace rastertrace {

/// A file, and those beside it that say what it should be.
struct SuiteCase {
    std::string name{}; ///< of the file, as a path from the folder
    std::string path{};
    std::string golden{};             ///< the path of its golden; "" if it has none
    std::string scene{};              ///< of a trace: the scene that it is of; "" if there is none
    bool is_trace = false;            ///< by its name
    std::vector<std::string> files{}; ///< that the result depends on, whether they are there or not

    bool has_claims() const; ///< by its name
};

/// The cases in a folder and its folders, by name. Throws a Problem if there are none.
std::vector<SuiteCase> cases_below(const std::string& folder);

/// How cases are run.
struct SuiteRules {
    DiffOptions comparison{};
    MethodOverrides method{};               ///< of scenes; overrides that of rules beside them
    const DrivenProgram* program = nullptr; ///< draws the scenes in our place
};

/// Runs a case. May be called by several threads. What is wrong with a file is its result; throws a Problem if the
/// system, or the program, cannot do what it should.
SuiteResult result_of(const SuiteCase& one, const SuiteRules& rules);

} // namespace rastertrace
