// SPDX-License-Identifier: MIT
#pragma once

// Steps of one trace that have not been found in the other one yet, first come first.
//
//     waiting.add(line, place);
//     const auto found = waiting.take(other.key);

#include "step_lines.h"

#include <cstddef>
#include <deque>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace rastertrace {

class WaitingSteps {
public:
    struct Step {
        StepLine line{};
        std::size_t place = 0; ///< in the order of the comparison
        bool is_waiting = true;
    };

    void add(StepLine line, std::size_t place) {
        bytes_ += line.json.size();
        by_key_[line.key].push_back(steps_.size());
        steps_.push_back(Step{.line = std::move(line), .place = place});
    }

    /// Takes the first step of a key out, if there is one.
    bool take(const std::string& key, Step& into) {
        const auto found = by_key_.find(key);
        if (found == by_key_.end())
            return false;
        Step& step = steps_[found->second.front()];
        found->second.pop_front();
        if (found->second.empty())
            by_key_.erase(found);
        bytes_ -= step.line.json.size();
        into = std::move(step);
        step.is_waiting = false;
        return true;
    }

    bool is_empty() const { return by_key_.empty(); }
    std::size_t bytes() const { return bytes_; }

    /// Calls `use` with all that are left, and forgets them.
    template <typename Use> void take_all(const Use& use) {
        for (const Step& step : steps_)
            if (step.is_waiting)
                use(step);
        *this = {};
    }

private:
    std::vector<Step> steps_;
    std::unordered_map<std::string, std::deque<std::size_t>> by_key_;
    std::size_t bytes_ = 0;
};

} // namespace rastertrace
