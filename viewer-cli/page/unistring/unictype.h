// SPDX-License-Identifier: MIT
#pragma once

// The part of libunistring's <unictype.h> that rastertrace uses, for the WebAssembly module.
// character_tables.cpp writes the answers of the library down when the module is built.

#include <cstdint>

bool uc_is_property_default_ignorable_code_point(std::uint32_t character);
bool uc_is_property_not_a_character(std::uint32_t character);
