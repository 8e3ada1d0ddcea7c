// SPDX-License-Identifier: MIT
#pragma once

// Random choices, the same on every machine.
//
//     Random random(17);
//     random.pick({8, 16, 24});

#include <cstdint>
#include <initializer_list>
#include <random>

namespace rastertrace {

class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    /// `low` to `high`, both included.
    int whole(int low, int high) {
        return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
    }
    /// True once in `of` times.
    bool chance(int of) { return whole(1, of) == 1; }
    template <typename T> T pick(std::initializer_list<T> values) {
        return values.begin()[whole(0, static_cast<int>(values.size()) - 1)];
    }

private:
    std::mt19937_64 engine_;
};

} // namespace rastertrace
