// SPDX-License-Identifier: MIT
#include "primitive_order.h"

#include <algorithm>
#include <deque>
#include <string_view>
#include <unordered_map>

namespace rastertrace {

std::vector<std::size_t> find_by_name(const std::vector<PrimitivePlace>& a,
                                      const std::vector<PrimitivePlace>& b) {
    std::unordered_map<std::string_view, std::deque<std::size_t>> places;
    for (std::size_t i = 0; i < b.size(); ++i)
        places[b[i].name].push_back(i);
    std::vector<std::size_t> found;
    for (const PrimitivePlace& one : a) {
        const auto place = places.find(one.name);
        const bool is_there = place != places.end() && !place->second.empty();
        found.push_back(is_there ? place->second.front() : nowhere);
        if (is_there)
            place->second.pop_front();
    }
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
