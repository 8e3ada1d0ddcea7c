// SPDX-License-Identifier: MIT
#pragma once

// The module for pages: core and trace, compiled to WebAssembly, as the text of one JavaScript file. A page that
// holds it draws a scene again by itself, with the arithmetic of the program.
//
//     if (!wasm_module().empty())
//         page += "<script>" + std::string(wasm_module()) + "</script>";
//
// src/module.js tells what it can be asked for.

#include <string_view>

namespace rastertrace {

/// The module; empty in a program that is built without RASTERTRACE_WASM. It holds no `</script`.
std::string_view wasm_module();

} // namespace rastertrace
