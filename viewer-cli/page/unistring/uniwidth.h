// SPDX-License-Identifier: MIT
#pragma once

// The part of libunistring's <uniwidth.h> that rastertrace uses, for the WebAssembly module.
// character_tables.cpp writes the answers of the library down when the module is built.

#include <cstdint>

/// How many columns of a terminal a character takes, with UTF-8 as `encoding`; -1 for a control character.
int uc_width(std::uint32_t character, const char* encoding);
