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
            grow();
        const auto& name = name_of(number);
        const std::uint32_t hash = hash_of(name);
        Slot& slot = slots_[place_of(name, hash, name_of)];
        if (slot.number != no_number)
            return false;
        slot = {number, hash};
        ++count_;
        return true;
    }

    /// The number that has this name.
    template <typename NameOf>
    std::optional<std::uint32_t> find(std::string_view name, const NameOf& name_of) const {
        if (slots_.empty())
            return std::nullopt;
        const std::uint32_t number = slots_[place_of(name, hash_of(name), name_of)].number;
        return number == no_number ? std::nullopt : std::optional(number);
    }

    /// All numbers, in no order.
    std::vector<std::uint32_t> numbers() const {
        std::vector<std::uint32_t> all;
        for (const Slot& slot : slots_)
            if (slot.number != no_number)
                all.push_back(slot.number);
        return all;
    }

private:
    static constexpr std::uint32_t no_number = 0xFFFFFFFF;

    struct Slot {
        std::uint32_t number = no_number;
        std::uint32_t hash = 0; ///< of its name: other names need not be looked at
    };

    static std::uint32_t hash_of(std::string_view name) {
        return static_cast<std::uint32_t>(std::hash<std::string_view>{}(name));
    }

    /// The slot of a name, or the free one where it belongs.
    template <typename NameOf>
    std::size_t place_of(std::string_view name, std::uint32_t hash, const NameOf& name_of) const {
        const std::size_t mask = slots_.size() - 1;
        std::size_t place = hash & mask;
        while (
            slots_[place].number != no_number &&
            (slots_[place].hash != hash || std::string_view(name_of(slots_[place].number)) != name))
            place = (place + 1) & mask;
        return place;
    }

    void grow() {
        constexpr std::size_t smallest = 16;
        const std::vector<Slot> before =
            std::exchange(slots_, std::vector<Slot>(slots_.empty() ? smallest : 2 * slots_.size()));
        const std::size_t mask = slots_.size() - 1;
        for (const Slot& slot : before) {
            if (slot.number == no_number)
                continue;
            std::size_t place = slot.hash & mask;
            while (slots_[place].number != no_number)
                place = (place + 1) & mask;
            slots_[place] = slot;
        }
    }

    std::vector<Slot> slots_; ///< as many as a power of two; at most half are in use
    std::size_t count_ = 0;
};

} // namespace rastertrace
