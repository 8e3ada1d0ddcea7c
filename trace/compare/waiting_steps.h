// SPDX-License-Identifier: MIT
#pragma once

// Steps of one trace that have not been found in the other one yet, first come first.
//
//     waiting.add(line, gap);
//     if (WaitingSteps::Step found; waiting.take(other.key, found)) ...

#include <rastertrace/trace/record/step_lines.h>

#include <cstddef>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace rastertrace {

class WaitingSteps {
public:
    struct Step {
        StepLine line{};
        std::size_t gap = 0; ///< where the two traces went apart, see DiffTally
        std::size_t next = none;
        bool is_waiting = true;
    };

    void add(StepLine line, std::size_t gap) {
        bytes_ += size_of(line);
        const std::size_t place = steps_.size();
        const auto [chain, is_new] = by_key_.try_emplace(line.key, Chain{place, place});
        if (!is_new)
            steps_[std::exchange(chain->second.last, place)].next = place;
        steps_.push_back(Step{.line = std::move(line), .gap = gap});
    }

    /// Takes the first step of a key out, if there is one.
    bool take(const std::string& key, Step& into) {
        const auto chain = by_key_.find(key);
        if (chain == by_key_.end())
            return false;
        Step& step = steps_[chain->second.first];
        chain->second.first = step.next;
        if (step.next == none)
            by_key_.erase(chain);
        into = std::move(step);
        step.is_waiting = false;
        return true;
    }

    bool is_empty() const { return by_key_.empty(); }

    /// About as much memory as they take.
    std::size_t bytes() const { return bytes_; }

    /// Calls `use` with all that are left, and forgets them.
    template <typename Use> void take_all(const Use& use) {
        for (const Step& step : steps_)
            if (step.is_waiting)
                use(step);
        *this = {};
    }

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    /// The steps of a key, from the first one that waits.
    struct Chain {
        std::size_t first;
        std::size_t last;
    };

    static std::size_t size_of(const StepLine& line) {
        constexpr std::size_t of_entry = 128; ///< of the hash table and the allocator
        return sizeof(Step) + line.json.size() + 2 * line.key.size() + of_entry;
    }

    std::vector<Step> steps_;
    std::unordered_map<std::string, Chain> by_key_;
    std::size_t bytes_ = 0;
};

} // namespace rastertrace
