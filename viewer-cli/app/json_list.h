// SPDX-License-Identifier: MIT
#pragma once

// A list as JSON.
//
//     list_json(pixels, pixel_json);  // "[...,...]"

#include <string>
#include <vector>

namespace rastertrace {

/// `items` as a JSON array, each by `item_json`.
template <typename Item, typename ItemJson>
std::string list_json(const std::vector<Item>& items, const ItemJson& item_json) {
    std::string text = "[";
    for (const Item& item : items)
        text += (text.size() > 1 ? "," : "") + item_json(item);
    return text + "]";
}

} // namespace rastertrace
