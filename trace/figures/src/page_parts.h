// SPDX-License-Identifier: MIT
#pragma once

// The files of trace/figures/page, as the build has put them into the program (cmake/embed.cmake).

#include <string>

namespace rastertrace {

std::string page_html();
std::string element_html();
std::string element_css();
std::string element_js();
std::string player_js();
std::string words_json();

} // namespace rastertrace
