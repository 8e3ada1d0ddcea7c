// SPDX-License-Identifier: MIT
#include "nameless_file.h"

#include "problem.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

namespace rastertrace {

NamelessFile nameless_file(const std::string& for_name) {
    const char* const folder = std::getenv("TMPDIR");
    std::string path =
        std::string(folder == nullptr || *folder == '\0' ? "/tmp" : folder) + "/rastertrace-XXXXXX";
    NamelessFile file;
    file.to_write = Descriptor(::mkstemp(path.data()));
    if (file.to_write.is_open())
        file.to_read = Descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file.to_read.is_open() || ::unlink(path.c_str()) != 0)
        throw problem_of_system(for_name, "could not be kept in a temporary file", errno);
    return file;
}

} // namespace rastertrace
