// SPDX-License-Identifier: MIT
#pragma once

// What is installed beside the program, found from where the program lies: a package may be unpacked anywhere.

#include <filesystem>

namespace rastertrace {

/// The folder with the examples: PREFIX/share/rastertrace/examples of PREFIX/bin/rastertrace; of a program in its build
/// folder, that of the sources. Throws a Problem if there is none.
std::filesystem::path examples_folder();

/// PREFIX/share/rastertrace/rastertrace.js, the module for pages; empty if it is not there.
std::filesystem::path installed_module();

} // namespace rastertrace
