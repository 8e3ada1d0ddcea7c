// SPDX-License-Identifier: MIT
#pragma once

#include <rastertrace/core/numbers/index.h>

#include <cstdint>
#include <string_view>

namespace rastertrace {

/// Random numbers that are the same everywhere: SplitMix64 (Steele, Lea and Flood 2014), from the FNV-1a hash of an ID.
class RandomNumbers {
public:
    explicit RandomNumbers(std::string_view id) {
        for (const char c : id)
            state_ = (state_ ^ static_cast<unsigned char>(c)) * 0x100000001B3;
    }

    /// From 0 to `count` - 1.
    std::uint64_t below(std::uint64_t count) {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EB;
        return (z ^ (z >> 31U)) % count;
    }

    /// Both included.
    Index between(Index first, Index last) {
        return first + static_cast<Index>(below(static_cast<std::uint64_t>(last - first) + 1));
    }

private:
    std::uint64_t state_ = 0xCBF29CE484222325;
};

} // namespace rastertrace
