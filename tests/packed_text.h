// SPDX-License-Identifier: MIT
#pragma once

// A text as gzip or Zstandard packs it.
//
//     packed("{}", Packing::gzip);

#include "random_choice.h"

#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/packed.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace rastertrace {

inline std::string packed(const std::string& text, Packing packing) {
    std::string bytes;
    StringOutput output(bytes);
    PackedOutput packed(output, packing);
    Random random(1);
    for (std::size_t at = 0; at < text.size();) { // in pieces of any size
        const auto size = static_cast<std::size_t>(random.whole(1, 300'000));
        packed.write(std::string_view(text).substr(at, size));
        at += size;
    }
    packed.finish();
    return bytes;
}

} // namespace rastertrace
