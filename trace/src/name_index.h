// SPDX-License-Identifier: MIT
#pragma once

// Finds names that are kept elsewhere: of each it holds only the number, in a hash table with open
// addressing (Knuth, volume 3, 6.4, algorithm L), so that millions of names cost a few bytes each.
//
//     NameIndex index;
//     index.insert(7, [&](std::uint32_t n) { return names[n]; });

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

class NameIndex {
public:
    /// Adds a number whose name is name_of(number). False if another one has that name already.
    template <typename NameOf> bool insert(std::uint32_t number, const NameOf& name_of) {
        if (2 * (count_ + 1) > slots_.size())
            grow(name_of);
        const auto& name = name_of(number);
        std::uint32_t& slot = slots_[place_of(name, name_of)];
        if (slot != free_slot)
            return false;
        slot = number;
        ++count_;
        return true;
    }

    /// The number that has this name.
    template <typename NameOf>
    std::optional<std::uint32_t> find(std::string_view name, const NameOf& name_of) const {
        if (slots_.empty())
            return std::nullopt;
        const std::uint32_t number = slots_[place_of(name, name_of)];
        return number == free_slot ? std::nullopt : std::optional(number);
    }

    /// All numbers, in no order.
    std::vector<std::uint32_t> numbers() const {
        std::vector<std::uint32_t> all;
        for (const std::uint32_t number : slots_)
            if (number != free_slot)
                all.push_back(number);
        return all;
    }

private:
    static constexpr std::uint32_t free_slot = 0xFFFFFFFF;

    /// The slot of a name, or the free one where it belongs.
    template <typename NameOf>
    std::size_t place_of(std::string_view name, const NameOf& name_of) const {
        const std::size_t mask = slots_.size() - 1;
        std::size_t place = std::hash<std::string_view>{}(name)&mask;
        while (slots_[place] != free_slot && std::string_view(name_of(slots_[place])) != name)
            place = (place + 1) & mask;
        return place;
    }

    template <typename NameOf> void grow(const NameOf& name_of) {
        constexpr std::size_t smallest = 16;
        const std::vector<std::uint32_t> before = std::exchange(
            slots_,
            std::vector<std::uint32_t>(slots_.empty() ? smallest : 2 * slots_.size(), free_slot));
        for (const std::uint32_t number : before)
            if (number != free_slot)
                slots_[place_of(name_of(number), name_of)] = number;
    }

    std::vector<std::uint32_t> slots_; ///< as many as a power of two; at most half are in use
    std::size_t count_ = 0;
};

} // namespace rastertrace
