// SPDX-License-Identifier: MIT
#include "run_self.h"

#include "environment.h"

#include <fmt/core.h>

#include <signal.h>
#include <sys/prctl.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace rastertrace {

namespace {

/// Tell a run its FileRules, and that it is one.
constexpr const char* files_below = "RASTERTRACE_FILES_BELOW";
constexpr const char* files_to = "RASTERTRACE_FILES_TO";

/// This program's environment, but for what its output depends on; and rules for files.
std::vector<std::string> environment(const FileRules& rules) {
    const std::vector<std::string> fixed{"COLUMNS=",
                                         "LINES=",
                                         "NO_COLOR=",
                                         "TERM=",
                                         "COLORTERM=",
                                         "RASTERTRACE_LANGUAGE=",
                                         fmt::format("{}=", files_below),
                                         fmt::format("{}=", files_to)};
    std::vector<std::string> variables{"COLUMNS=80", "NO_COLOR=1", "TERM=dumb",
                                       fmt::format("{}={}", files_below, rules.below),
                                       fmt::format("{}={}", files_to, rules.outputs)};
    for (std::string& variable : own_environment())
        if (std::none_of(fixed.begin(), fixed.end(), [&variable](const std::string& name) {
                return variable.starts_with(name);
            }))
            variables.push_back(std::move(variable));
    return variables;
}

} // namespace

FinishedRun run_self(const std::vector<std::string>& arguments, const RunLimits& limits) {
    ProgramRun program{.path = "/proc/self/exe",
                       .words = {"rastertrace"},
                       .environment = environment(limits.files),
                       .most_output = most_output,
                       .time = limits.time};
    program.words.insert(program.words.end(), arguments.begin(), arguments.end());
    return run_program(std::move(program));
}

void take_limits_of_run() {
    if (std::getenv(files_below) == nullptr)
        return;
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    set_file_rules({.below = std::string(environment_variable(files_below)),
                    .outputs = std::string(environment_variable(files_to))});
}

bool runs_for_page() {
    return !file_rules().below.empty();
}

} // namespace rastertrace
