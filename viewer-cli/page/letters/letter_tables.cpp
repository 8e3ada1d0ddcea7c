// SPDX-License-Identifier: MIT
// Writes how wide the letters of figures are as tables in C++, in 2048ths of an em; 0xFFFF: the font has not the character.
// This program is compiled for the machine that builds the module.
//
//     letter_tables > letter_tables.h

#include "font.h"

#include <cmath>
#include <cstdio>

namespace {

/// Latin, Greek, Cyrillic, and signs up to those of mathematics. What is beyond has the width of a box.
constexpr char32_t end = 0x2300;

void write_table(const char* name, rastertrace::Typeface face) {
    std::printf("inline constexpr unsigned short %s[] = {", name);
    for (char32_t character = 0; character < end; ++character)
        if (const auto advance = rastertrace::advance_of(character, face))
            std::printf("%ld,\n", std::lround(2048 * *advance));
        else
            std::printf("0xFFFF,\n");
    std::printf("};\n");
}

} // namespace

int main() {
    write_table("regular_widths", rastertrace::Typeface::regular);
    write_table("bold_widths", rastertrace::Typeface::bold);
    return 0;
}
