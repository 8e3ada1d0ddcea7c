// SPDX-License-Identifier: MIT
#include "app/run_self.h"

#include "app/environment.h"

#include <rastertrace/trace/text/process_files.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <signal.h>
#include <sys/prctl.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace rastertrace {

namespace {

/// Tells a run where to write its files, and that it is one.
constexpr const char* folder_variable = "RASTERTRACE_FILES_TO";
constexpr const char* pages_variable = "RASTERTRACE_PAGES"; // one a line

/// This program's environment, but for what its output depends on.
std::vector<std::string> environment(const std::string& folder,
                                     const std::vector<std::string>& pages) {
    const std::vector<std::string> fixed{"COLUMNS=",
                                         "LINES=",
                                         "NO_COLOR=",
                                         "TERM=",
                                         "COLORTERM=",
                                         "RASTERTRACE_LANGUAGE=",
                                         fmt::format("{}=", folder_variable),
                                         fmt::format("{}=", pages_variable)};
    std::vector<std::string> variables{"COLUMNS=80", "NO_COLOR=1", "TERM=dumb",
                                       fmt::format("{}={}", folder_variable, folder),
                                       fmt::format("{}={}", pages_variable, joined(pages, "\n"))};
    for (std::string& variable : own_environment())
        if (std::none_of(fixed.begin(), fixed.end(), [&variable](const std::string& name) {
                return variable.starts_with(name);
            }))
            variables.push_back(std::move(variable));
    return variables;
}

} // namespace

FinishedRun run_self(const std::vector<std::string>& arguments, const std::string& folder,
                     const std::vector<std::string>& pages) {
    ProgramRun program{.path = "/proc/self/exe",
                       .words = {"rastertrace"},
                       .environment = environment(folder, pages),
                       .most_output = most_output,
                       .time = time_of_run};
    program.words.insert(program.words.end(), arguments.begin(), arguments.end());
    return run_program(std::move(program));
}

void take_folder_of_run() {
    if (std::getenv(folder_variable) == nullptr)
        return;
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    run_for_page(std::string(environment_variable(folder_variable)),
                 split_at(environment_variable(pages_variable), '\n'));
}

} // namespace rastertrace
