// SPDX-License-Identifier: MIT
#pragma once

// How many steps of each kind there are: what the end record of a trace tells.
//
//     StepCounts counts;
//     counts.add(step, kind);
//     counts.of("scanline");

#include "step_kind.h"
#include "trace.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace rastertrace {

struct StepCounts {
    std::array<std::uint64_t, step_kinds> known{};
    std::map<std::string, std::uint64_t, std::less<>> others = {}; ///< of kinds that we do not know

    void add(StepKind kind) { ++known[static_cast<std::size_t>(kind)]; }
    void add(const StepView& step, std::optional<StepKind> kind) {
        if (kind)
            add(*kind);
        else
            ++others[step.kind_name()];
    }

    StepCounts& operator+=(const StepCounts& more) {
        for (std::size_t kind = 0; kind < step_kinds; ++kind)
            known[kind] += more.known[kind];
        for (const auto& [name, count] : more.others)
            others[name] += count;
        return *this;
    }

    /// How many there are of a kind, known or not.
    std::uint64_t of(std::string_view name) const {
        if (const auto kind = step_kind_named(name))
            return known[static_cast<std::size_t>(*kind)];
        const auto other = others.find(name);
        return other == others.end() ? 0 : other->second;
    }
};

} // namespace rastertrace
