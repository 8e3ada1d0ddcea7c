// SPDX-License-Identifier: MIT
#pragma once

// Steps of one trace that have not been found in the other one yet, first come first.
//
//     waiting.add(step, gap);
//     if (const auto found = waiting.take(other.key)) ...

#include "steps_ahead.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace rastertrace {

class WaitingSteps {
public:
    struct Step {
        KeyedStep step{};
        std::size_t gap = 0; ///< where the two traces went apart, see DiffTally
    };

    void add(KeyedStep step, std::size_t gap) {
        places_[step.key].push_back(count_);
        steps_.emplace(count_++, Step{std::move(step), gap});
    }

    /// Takes the first step of a key out, if there is one.
    std::optional<Step> take(const std::string& key) {
        const auto places = places_.find(key);
        if (places == places_.end())
            return std::nullopt;
        auto step = steps_.extract(places->second.front());
        places->second.pop_front();
        if (places->second.empty())
            places_.erase(places);
        return std::move(step.mapped());
    }

    bool is_empty() const { return steps_.empty(); }

    /// Calls `use` with all that are left, and forgets them.
    template <typename Use> void take_all(const Use& use) {
        for (const auto& [place, step] : steps_)
            use(step);
        *this = {};
    }

private:
    std::map<std::size_t, Step> steps_; ///< by the order in which they came
    std::unordered_map<std::string, std::deque<std::size_t>> places_; ///< of a key
    std::size_t count_ = 0;
};

} // namespace rastertrace
