// SPDX-License-Identifier: MIT
#include <rastertrace/wasm/module.h>

namespace rastertrace {

std::string_view wasm_module() {
    return {};
}

} // namespace rastertrace
