// SPDX-License-Identifier: MIT
// Writes what libunistring says of all characters as tables in C++: at which character each answer begins.
// This program is compiled for the machine that builds the module, where the library is.
//
//     character_tables > character_tables.h

#include <unictype.h>
#include <uniwidth.h>

#include <cstdint>
#include <cstdio>

namespace {

template <typename Answer> void write_table(const char* name, Answer answer) {
    std::printf("inline constexpr Beginning %s[] = {", name);
    int last = 0;
    for (std::uint32_t character = 0; character <= 0x10FFFF; ++character) {
        const int value = answer(character);
        if (character == 0 || value != last)
            std::printf("{0x%X, %d},\n", static_cast<unsigned>(character), value);
        last = value;
    }
    std::printf("};\n");
}

} // namespace

int main() {
    write_table("widths", [](std::uint32_t c) { return uc_width(c, "UTF-8"); });
    write_table("ignorable", [](std::uint32_t c) {
        return uc_is_property_default_ignorable_code_point(c) ? 1 : 0;
    });
    write_table("no_characters",
                [](std::uint32_t c) { return uc_is_property_not_a_character(c) ? 1 : 0; });
    return 0;
}
