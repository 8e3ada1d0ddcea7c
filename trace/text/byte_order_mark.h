// SPDX-License-Identifier: MIT
#pragma once

// What a text file may begin with before it says anything.

#include <cstddef>
#include <string_view>

namespace rastertrace {

/// The mark that some editors put in front of UTF-8.
inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// White space, and the bytes of the mark.
inline constexpr std::string_view blanks_and_mark = "\xEF\xBB\xBF \t\r\n";

/// The mark's size if a text begins with it, otherwise 0.
inline std::size_t size_of_mark(std::string_view text) {
    return text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
}

} // namespace rastertrace
