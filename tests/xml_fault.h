// SPDX-License-Identifier: MIT
#pragma once

// Whether a document is XML, as far as what we write can fail to be.

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace rastertrace {

/// What is wrong with a document as XML, or "": tags that do not match, a raw & or <, control
/// characters, attributes without quotes.
inline std::string xml_fault(const std::string& xml) {
    std::vector<std::string> open;
    for (std::size_t i = 0; i < xml.size();) {
        const char c = xml[i];
        if (static_cast<unsigned char>(c) < 0x20 && c != '\n')
            return "a control character";
        if (c == '&') {
            const std::size_t end = xml.find(';', i);
            const std::string name = xml.substr(i + 1, end - i - 1);
            if (end == std::string::npos ||
                (name != "amp" && name != "lt" && name != "gt" && name != "quot" && name != "#39"))
                return "an entity that is none: " + xml.substr(i, 10);
            i = end + 1;
            continue;
        }
        if (c != '<') {
            ++i;
            continue;
        }
        const std::size_t end = xml.find('>', i);
        if (end == std::string::npos)
            return "a tag without an end";
        std::string tag = xml.substr(i + 1, end - i - 1);
        i = end + 1;
        if (tag.find('<') != std::string::npos)
            return "a < in a tag";
        if (tag.starts_with('/')) {
            if (open.empty() || open.back() != tag.substr(1))
                return "an end tag of something else: " + tag;
            open.pop_back();
            continue;
        }
        const bool is_empty = tag.ends_with('/');
        if (std::count(tag.begin(), tag.end(), '"') % 2 != 0)
            return "a quote too many: " + tag;
        if (!is_empty)
            open.push_back(tag.substr(0, tag.find_first_of(" \n")));
    }
    return open.empty() ? "" : "a tag left open: " + open.back();
}

} // namespace rastertrace
