// SPDX-License-Identifier: MIT
#include "run_self.h"

#include "environment.h"

#include <rastertrace/trace/text/process_files.h>

#include <fmt/core.h>

#include <signal.h>
#include <sys/prctl.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

namespace rastertrace {

namespace {

/// Tells a run the folder that it shares with others, and that it is one.
constexpr const char* folder_variable = "RASTERTRACE_RUN";

/// This program's environment, but for what its output depends on.
std::vector<std::string> environment(const std::string& folder) {
    const std::vector<std::string> fixed{"COLUMNS=",
                                         "LINES=",
                                         "NO_COLOR=",
                                         "TERM=",
                                         "COLORTERM=",
                                         "RASTERTRACE_LANGUAGE=",
                                         fmt::format("{}=", folder_variable)};
    std::vector<std::string> variables{"COLUMNS=80", "NO_COLOR=1", "TERM=dumb",
                                       fmt::format("{}={}", folder_variable, folder)};
    for (std::string& variable : own_environment())
        if (std::none_of(fixed.begin(), fixed.end(), [&variable](const std::string& name) {
                return variable.starts_with(name);
            }))
            variables.push_back(std::move(variable));
    return variables;
}

} // namespace

FinishedRun run_self(const std::vector<std::string>& arguments, const std::string& folder) {
    ProgramRun program{.path = "/proc/self/exe",
                       .words = {"rastertrace"},
                       .environment = environment(folder),
                       .most_output = most_output,
                       .time = time_of_run};
    program.words.insert(program.words.end(), arguments.begin(), arguments.end());
    return run_program(std::move(program));
}

void take_folder_of_runs(const std::string& folder) {
    share_opened_files(folder + "/opened");
}

void take_folder_of_caller() {
    if (std::getenv(folder_variable) == nullptr)
        return;
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    const std::string folder(environment_variable(folder_variable));
    take_folder_of_runs(folder);
    const std::string files = fmt::format("{}/{}", folder, folder_of_files);
    std::error_code error;
    if (std::filesystem::is_directory(files, error))
        write_files_below(files);
}

} // namespace rastertrace
