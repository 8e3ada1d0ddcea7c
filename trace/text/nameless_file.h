// SPDX-License-Identifier: MIT
#pragma once

// What comes from a pipe and is needed more than once is kept in a file without a name meanwhile.

#include "descriptor.h"

#include <string>

namespace rastertrace {

/// A file that has no name, to be written at one end and read at the other. It is gone when both are closed.
struct NamelessFile {
    Descriptor to_write;
    Descriptor to_read;
};

/// Makes one. `for_name` is what messages call it that is kept there. Throws a Problem.
NamelessFile nameless_file(const std::string& for_name);

} // namespace rastertrace
