// SPDX-License-Identifier: MIT
#pragma once

// Where each step of a trace stands in its text. Of the steps that are written as StepWriter writes them, a line each,
// only the place of every 64th is kept; the lines behind it are found again when somebody asks for one of them.
//
//     StepPlaces places;
//     places.add({.offset = 70, .length = 31, .kind = StepKind::pixel, .is_plain = true});
//     places.at(1, text).kind;

#include "step_kind.h"

#include <rastertrace/core/raster/image.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// One step in a text.
struct StepPlace {
    std::size_t offset = 0;
    std::uint32_t length = 0;
    std::optional<StepKind> kind = {}; ///< none: nobody knows it, or it cannot be used
    bool is_plain = false; ///< a line of its own, as StepWriter writes it; nothing is wrong with it
    std::optional<Pixel> pixel = {}; ///< that a run of pixels has plotted, in the place of a text
};

class StepPlaces {
public:
    StepPlaces() = default;
    StepPlaces(const StepPlaces&) = delete;
    StepPlaces& operator=(const StepPlaces&) = delete;

    std::size_t size() const { return size_; }

    /// The next step.
    void add(const StepPlace& step);

    /// The next steps: pixels of a row, plotted one after the other from left to right. Adds a line for them to the text.
    void add_run(std::string& text, Pixel first, std::size_t count);

    /// Step n, from 1 to size(), in the text that it was added from. The reference is valid until the next call. Not for
    /// two threads at once.
    const StepPlace& at(std::size_t n, std::string_view text) const {
        return n - at_hand_.first < at_hand_.count ? at_hand_.places[n - at_hand_.first]
                                                   : found(n, text);
    }

private:
    /// Steps one behind the other: all of them plain, or all of them kept.
    struct Block {
        std::size_t first; ///< its first step
        std::size_t begin; ///< where that stands: in the text, or in kept_
        bool is_plain;
    };

    /// A block whose steps have been found.
    struct FoundBlock {
        std::size_t block = 0;
        std::vector<StepPlace> places = {};
    };

    /// The block that was asked of last.
    struct AtHand {
        std::size_t first = 0;
        std::size_t count = 0;
        const StepPlace* places = nullptr;
    };

    const StepPlace& found(std::size_t n, std::string_view text) const;
    const StepPlace& take_to_hand(std::size_t block, const StepPlace* places, std::size_t n) const;
    void begin_block(std::size_t begin, bool is_plain);
    std::size_t end_of(std::size_t block) const;

    std::vector<Block> blocks_;
    std::vector<StepPlace> kept_;
    std::size_t size_ = 0;
    std::size_t end_of_line_ = 0; ///< behind the last plain step

    mutable std::vector<FoundBlock> found_; ///< a block has one place here, whatever is there
    mutable AtHand at_hand_ = {};
};

} // namespace rastertrace
