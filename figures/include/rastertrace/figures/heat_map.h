// SPDX-License-Identifier: MIT
#pragma once

// A number for each pixel of a canvas, from the steps of a trace, one after the other: none of them is kept.
//
//     overdraw       how often the pixel was written
//     tests          how many depth tests it had
//     depth-fights   in how many digits the two nearest depths that were tested there agree
//
//     HeatMap map(Heat::overdraw, trace.canvas);
//     for (std::size_t n = 1; n <= trace.size(); ++n)
//         map.add(trace.step(n), trace.kind_of(n));
//     map.at(trace.canvas.offset_of({3, 2}));  // 2

#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/trace/record/trace.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

enum class Heat : std::uint8_t { overdraw, tests, depth_fights };

/// overdraw, tests, depth-fights
std::vector<std::string_view> heat_names();
std::string_view name_of(Heat heat);
std::optional<Heat> heat_named(std::string_view name);

/// The steps that tell it.
StepKind steps_for(Heat heat);

/// The number of depth-fights where both depths are equal. Less than that, k: they differ by at most 10^-k of the larger
/// one, k being at most 15, the digits that a double has.
inline constexpr std::uint32_t equal_depths = 16;

class HeatMap {
public:
    HeatMap(Heat heat, const Canvas& canvas)
        : heat_(heat), canvas_(canvas), levels_(static_cast<std::size_t>(canvas.width) *
                                                static_cast<std::size_t>(canvas.height)) {}

    /// Takes a step, in its turn. Only those of steps_for() count, on the canvas.
    void add(const StepView& step, std::optional<StepKind> kind);

    /// Takes what another map of the same heat and canvas has: numbers are added up; of depth-fights, the closest counts.
    void add(const HeatMap& other);

    Heat heat() const { return heat_; }

    /// How many steps have counted.
    std::uint64_t steps() const { return steps_; }

    /// The number of a pixel, by its offset on the canvas; nothing for one that has none, or not two depths.
    std::optional<std::uint32_t> at(std::size_t offset) const {
        const std::uint32_t level = levels_[offset];
        return level < least_told() ? std::nullopt : std::optional(level - not_told());
    }

    /// The numbers that the scale reaches from and to, whatever part of the canvas is shown.
    std::uint32_t least() const { return least_told() - not_told(); }
    std::uint32_t most() const;

    /// What is written in a pixel with that number.
    std::string text_of(std::uint32_t number) const;

    /// The color of a number, on a scale whose lightness falls evenly from the least to the most: as gray, it says the same.
    Color color_of(std::uint32_t number, bool in_grays) const;

private:
    bool is_of_two() const { return heat_ == Heat::depth_fights; }
    std::uint32_t least_told() const { return is_of_two() ? 2 : 1; }
    std::uint32_t not_told() const { return is_of_two() ? 2 : 0; }

    Heat heat_;
    Canvas canvas_;
    /// Of each pixel the count. Of depth-fights: 0 before a depth is stored, 1 with one depth, else 2 more than the number.
    BlankVector<std::uint32_t> levels_;
    std::uint64_t steps_ = 0;
    mutable std::optional<std::uint32_t> most_; ///< once someone has asked
};

} // namespace rastertrace
