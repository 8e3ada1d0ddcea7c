// SPDX-License-Identifier: MIT
// Writes the player as an element of any page to standard output: raster-trace.js.

#include <rastertrace/figures/page.h>

#include <iostream>

int main() {
    std::cout << rastertrace::page_element();
    return std::cout.flush() ? 0 : 1;
}
