// SPDX-License-Identifier: MIT
#pragma once

// The names of the stages of drawing, in the order in which they run. stages.h says what each does
// and when it is needed.
//
//     StageSet keep;
//     keep.add(Stage::depth);

#include <bitset>
#include <cstddef>

namespace rastertrace {

enum class Stage {
    model,
    view,
    clip,
    divide,
    order,
    cull,
    light,
    canvas,
    depth,
    perspective,
    colors
};
inline constexpr std::size_t stage_count = 11;

/// Some of the stages.
class StageSet {
public:
    bool has(Stage stage) const { return bits_[static_cast<std::size_t>(stage)]; }
    void add(Stage stage) { bits_[static_cast<std::size_t>(stage)] = true; }
    static StageSet all() {
        StageSet every;
        every.bits_.set();
        return every;
    }
    friend bool operator==(const StageSet&, const StageSet&) = default;

private:
    std::bitset<stage_count> bits_;
};

} // namespace rastertrace
