// SPDX-License-Identifier: MIT
#include "unictype.h"
#include "uniwidth.h"

#include <algorithm>
#include <iterator>

namespace {

/// Characters from `first` on have this value, up to the next beginning.
struct Beginning {
    std::uint32_t first;
    int value;
};

#include "character_tables.h"

template <std::size_t size> int value_in(const Beginning (&table)[size], std::uint32_t character) {
    return std::prev(
               std::upper_bound(std::begin(table), std::end(table), character,
                                [](std::uint32_t c, const Beginning& b) { return c < b.first; }))
        ->value;
}

} // namespace

bool uc_is_property_default_ignorable_code_point(std::uint32_t character) {
    return value_in(ignorable, character) != 0;
}

bool uc_is_property_not_a_character(std::uint32_t character) {
    return value_in(no_characters, character) != 0;
}

int uc_width(std::uint32_t character, const char*) {
    return value_in(widths, character);
}
