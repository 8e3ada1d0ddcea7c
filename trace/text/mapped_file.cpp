// SPDX-License-Identifier: MIT
#include "mapped_file.h"

#include "problem.h"

#include <sys/mman.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>

namespace rastertrace {

std::shared_ptr<const MappedFile> MappedFile::of(int descriptor, const std::string& name) {
    struct stat status {};
    if (::fstat(descriptor, &status) != 0)
        throw problem_of_system(name, "could not be read", errno);
    const auto size = static_cast<std::size_t>(status.st_size);
    void* const begin =
        ::mmap(nullptr, std::max<std::size_t>(size, 1), PROT_READ, MAP_SHARED, descriptor, 0);
    if (begin == MAP_FAILED)
        throw problem_of_system(name, "could not be read", errno);
    return std::shared_ptr<const MappedFile>(new MappedFile(static_cast<const char*>(begin), size));
}

void MappedFile::forget() const {
    ::madvise(const_cast<char*>(begin_), size_, MADV_DONTNEED); // of a file, it changes no byte
}

MappedFile::~MappedFile() {
    ::munmap(const_cast<char*>(begin_),
             std::max<std::size_t>(size_, 1)); // it only lets go of the bytes
}

} // namespace rastertrace
