// SPDX-License-Identifier: MIT
#include "app/installed_files.h"

#include <rastertrace/trace/text/problem.h>

#include <system_error>

namespace rastertrace {

namespace {

/// Where the program lies; empty if that is not known.
std::filesystem::path program_folder() {
    std::error_code error;
    return std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
}

} // namespace

std::filesystem::path installed_module() {
    std::error_code error;
    const auto program = program_folder();
    const auto file = (program / RASTERTRACE_SHARE "/rastertrace.js").lexically_normal();
    return !program.empty() && std::filesystem::is_regular_file(file, error)
               ? file
               : std::filesystem::path();
}

std::filesystem::path examples_folder() {
    std::error_code error;
    const auto program = program_folder();
    if (program.empty())
        throw problem_of("",
                         "expected /proc/self/exe, which says where the program lies, found none",
                         "mount -t proc proc /proc");
    const bool is_built_here = std::filesystem::exists(program / "../CMakeCache.txt", error);
    for (const auto* const place :
         {RASTERTRACE_SHARE "/examples", "../../../examples", "../../examples"}) {
        auto folder = (program / place).lexically_normal();
        if (std::filesystem::exists(folder / "t0-fill/first-triangle.json", error))
            return folder;
        if (!is_built_here)
            break;
    }
    throw problem_of("",
                     "expected the examples in " +
                         (program / RASTERTRACE_SHARE "/examples").lexically_normal().string() +
                         ", found none",
                     "cmake --install and the packages put them there");
}

} // namespace rastertrace
