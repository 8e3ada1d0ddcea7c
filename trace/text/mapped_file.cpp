// SPDX-License-Identifier: MIT
#include "mapped_file.h"

#include "problem.h"

#include <sys/mman.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <limits>

namespace rastertrace {

std::shared_ptr<const MappedFile> MappedFile::of(int descriptor, const std::string& name,
                                                 bool may_grow) {
    struct stat status {};
    if (::fstat(descriptor, &status) != 0)
        throw problem_of_system(name, "could not be read", errno);
    const auto size = static_cast<std::size_t>(status.st_size);
    // 2^40 bytes with addresses of 64 bits, 2^20 with those of 32 bits.
    constexpr std::size_t most_room = std::size_t{1}
                                      << std::numeric_limits<std::size_t>::digits * 5 / 8;
    const std::size_t least_room = std::max<std::size_t>(size, 1);
    for (std::size_t room = may_grow ? std::max(most_room, least_room) : least_room;;
         room = std::max(room / 2, least_room)) {
        void* const begin = ::mmap(nullptr, room, PROT_READ, MAP_SHARED, descriptor, 0);
        if (begin != MAP_FAILED)
            return std::shared_ptr<const MappedFile>(
                new MappedFile(static_cast<const char*>(begin), size, room));
        if (room == least_room)
            throw problem_of_system(name, "could not be read", errno);
    }
}

void MappedFile::forget() const {
    ::madvise(const_cast<char*>(begin_), room_, MADV_DONTNEED); // of a file, it changes no byte
}

MappedFile::~MappedFile() {
    ::munmap(const_cast<char*>(begin_), room_); // it only lets go of the bytes
}

} // namespace rastertrace
