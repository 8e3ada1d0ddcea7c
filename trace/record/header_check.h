// SPDX-License-Identifier: MIT
#pragma once

// The header and the end record of a trace, held against the tables of their keys (trace_keys.h).
//
//     wrong_forms(header, header_keys);  // {12, "expected a string, found 5"}

#include "trace_keys.h"

#include <rastertrace/trace/text/json_document.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace rastertrace {

/// Something that is not as the format says, at a byte of the source.
struct WrongForm {
    std::size_t offset = 0;
    std::string message;
};

/// The known keys whose values have another form than the table says, and those that are missing. Unknown keys are
/// allowed, and so are the values that the reader refuses anyway.
std::vector<WrongForm> wrong_forms(const JsonValue& object, std::span<const HeaderKey> keys);

} // namespace rastertrace
