// SPDX-License-Identifier: MIT
#include "files_below.h"

#include <rastertrace/trace/text/problem.h>

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace rastertrace {

std::vector<std::string> files_below(const std::string& folder, std::string_view of_what) {
    std::vector<std::string> names;
    std::error_code error;
    for (std::filesystem::recursive_directory_iterator entry(folder, error), end;
         !error && entry != end; entry.increment(error)) {
        if (entry->path().filename().string().starts_with('.'))
            entry.disable_recursion_pending();
        else if (entry->is_regular_file())
            names.push_back(entry->path().lexically_relative(folder).generic_string());
    }
    if (error) {
        Problem problem = problem_of(
            folder, fmt::format("expected a folder of {}, found that it cannot be read: {}",
                                of_what, error.message()));
        problem.cause = cause_of_open_error(error.value());
        throw problem;
    }
    std::ranges::sort(names);
    return names;
}

} // namespace rastertrace
