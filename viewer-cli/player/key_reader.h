// SPDX-License-Identifier: MIT
#pragma once

// The bytes that a terminal sends, as keys.
//
//     KeyReader reader;
//     reader.take("\x1b[C" "14G");
//     reader.next();  // {"Right"}, then {"1"}, {"4"}, {"G"}
//
// Keys are called as in player_keys.h, and also Escape, Enter, Tab, Backspace, Delete, PageUp, PageDown, Click.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace rastertrace {

struct KeyPress {
    std::string key;        ///< "" of what is no key that we know
    std::size_t column = 0; ///< of a Click, from 0
    std::size_t line = 0;
};

class KeyReader {
public:
    /// Adds what the terminal has sent, in pieces of any size.
    void take(std::string_view bytes) { bytes_ += bytes; }

    /// The next whole key; nothing if there is none yet.
    std::optional<KeyPress> next();

    /// True if there is the beginning of a key: it is the Escape key, if nothing follows soon.
    bool has_part() const { return !bytes_.empty(); }

    /// The same when nothing has followed: what is left is taken as it is.
    std::optional<KeyPress> next_of_rest();

private:
    std::optional<KeyPress> sequence();
    KeyPress take_key(std::size_t bytes, std::string key);

    std::string bytes_; ///< not yet taken as keys
};

} // namespace rastertrace
