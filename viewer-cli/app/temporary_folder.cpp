// SPDX-License-Identifier: MIT
#include "app/temporary_folder.h"

#include <rastertrace/trace/text/problem.h>
#include <rastertrace/trace/text/unfinished_list.h>

#include <fcntl.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

namespace rastertrace {

TemporaryFolder::TemporaryFolder(const std::string& name) {
    std::error_code error;
    const std::filesystem::path temporary = std::filesystem::temp_directory_path(error);
    std::string pattern = (temporary / (name + "-XXXXXX")).string();
    if (error)
        throw problem_of_system("TMPDIR", "no folder for temporary files", error.value());
    parent_ = Descriptor(::open(temporary.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    if (!parent_.is_open() || ::mkdtemp(pattern.data()) == nullptr)
        throw problem_of_system(pattern, "the folder could not be made", errno);
    path_ = pattern;
    note_unfinished(parent_.number(), path_.filename().string());
}

TemporaryFolder::~TemporaryFolder() {
    remove_unfinished(parent_.number(), path_.filename().string());
}

} // namespace rastertrace
