// SPDX-License-Identifier: MIT
#include "temporary_folder.h"

#include <rastertrace/trace/text/problem.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

namespace rastertrace {

TemporaryFolder::TemporaryFolder(const std::string& name) {
    std::error_code error;
    const std::filesystem::path temporary = std::filesystem::temp_directory_path(error);
    std::string pattern = (temporary / (name + "-XXXXXX")).string();
    if (error || ::mkdtemp(pattern.data()) == nullptr) {
        Problem problem =
            problem_of(error ? "TMPDIR" : pattern,
                       error ? error.message() : std::generic_category().message(errno));
        problem.cause = Problem::Cause::system;
        throw problem;
    }
    path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

} // namespace rastertrace
