// SPDX-License-Identifier: MIT
#include "primitive_order.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace rastertrace {

std::vector<std::size_t> find_by_name(const std::vector<PrimitivePlace>& a,
                                      const std::vector<PrimitivePlace>& b) {
    // The first one of each name in b that has not been found yet, and the next of the same name behind each.
    std::unordered_map<std::string_view, std::size_t> first;
    std::vector<std::size_t> next(b.size(), nowhere);
    for (std::size_t i = b.size(); i > 0; --i) {
        const auto [place, is_new] = first.emplace(b[i - 1].name, i - 1);
        if (!is_new)
            next[i - 1] = std::exchange(place->second, i - 1);
    }
    std::vector<std::size_t> found(a.size(), nowhere);
    for (std::size_t i = 0; i < a.size(); ++i)
        if (const auto place = first.find(a[i].name);
            place != first.end() && place->second != nowhere)
            found[i] = std::exchange(place->second, next[place->second]);
    return found;
}

std::vector<bool> in_common_order(const std::vector<std::size_t>& places) {
    // The last element of the best sequence of each length so far, and what comes before each element.
    std::vector<std::size_t> ends;
    std::vector<std::size_t> before(places.size(), nowhere);
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i] == nowhere)
            continue;
        const auto longer = std::lower_bound(
            ends.begin(), ends.end(), places[i],
            [&places](std::size_t end, std::size_t place) { return places[end] < place; });
        before[i] = longer == ends.begin() ? nowhere : *(longer - 1);
        if (longer == ends.end())
            ends.push_back(i);
        else
            *longer = i;
    }
    std::vector<bool> stays(places.size(), false);
    for (std::size_t i = ends.empty() ? nowhere : ends.back(); i != nowhere; i = before[i])
        stays[i] = true;
    return stays;
}

} // namespace rastertrace
