// SPDX-License-Identifier: MIT
#pragma once

// Where each step of a trace stands in its text. Of the steps that are written as StepWriter writes them, a line each,
// only the place of every 64th is kept: with the lengths of the lines behind it, if those have been measured, else they
// are found again when somebody asks for one of them.
//
//     StepPlaces places;
//     places.add({.offset = 70, .length = 31, .kind = StepKind::pixel, .is_plain = true});
//     places.at(1, text).kind;

#include "step_kind.h"

#include <rastertrace/core/raster/image.h>
#include <rastertrace/trace/text/mapped_file.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

/// Of so many plain steps the place of one is kept.
inline constexpr std::size_t steps_in_block = 64;

/// Lines of plain steps.
struct MeasuredLines {
    std::size_t begin = 0;                 ///< of the text: where the first stands
    std::size_t end = 0;                   ///< behind the newline of the last
    std::vector<std::uint8_t> kinds = {};  ///< of the steps
    std::vector<std::uint16_t> sizes = {}; ///< of the lines in bytes, with their newline
};

/// The longest line that can be measured.
inline constexpr std::size_t longest_measured_line = std::numeric_limits<std::uint16_t>::max();

/// One step in a text.
struct StepPlace {
    std::size_t offset = 0;
    std::uint32_t length = 0;
    std::optional<StepKind> kind = {}; ///< none: nobody knows it, or it cannot be used
    bool is_plain = false; ///< a line of its own, as StepWriter writes it; nothing is wrong with it
    std::optional<Pixel> pixel = {}; ///< that a run of pixels has plotted, in the place of a text
};

/// The places, and where the steps were that somebody has asked for last. The pages of a mapped file that it has read are
/// given back from time to time, so that some megabytes at most stay in memory. Not for two threads at once.
class StepPlaces {
public:
    StepPlaces() = default;
    StepPlaces(const StepPlaces&) = delete;
    StepPlaces& operator=(const StepPlaces&) = delete;

    std::size_t size() const { return size_; }

    /// The file that the text is in, if it is mapped.
    void set_file(std::shared_ptr<const MappedFile> file) { file_ = std::move(file); }

    /// The next step.
    void add(const StepPlace& step);

    /// The next steps, plain ones in lines that follow each other. They are kept as measured, if they are not too many.
    void add_lines(const MeasuredLines& lines);

    /// The next steps: pixels of a row, plotted one after the other from left to right. Adds a line for them to the text.
    void add_run(std::string& text, Pixel first, std::size_t count);

    /// Step n, from 1 to size(), in the text that it was added from. The reference is valid until the next call.
    const StepPlace& at(std::size_t n, std::string_view text) const {
        if (!found_.has(n))
            find(block_asked_for(n), text);
        return found_.places[n - found_.first];
    }

    /// The kind of step n.
    std::optional<StepKind> kind(std::size_t n, std::string_view text) const {
        if (measured_.has(n) || (!found_.has(n) && take_measured(block_asked_for(n))))
            return static_cast<StepKind>(measured_.kinds[n - measured_.first]);
        return at(n, text).kind;
    }

    /// True if step n is a plain one. The place of a measured line is not found for that.
    bool is_plain(std::size_t n, std::string_view text) const {
        return measured_.has(n) || (!found_.has(n) && take_measured(block_asked_for(n))) ||
               at(n, text).is_plain;
    }

    /// The first step from n to `last` of one of these kinds; last + 1 if there is none.
    std::size_t next_of(StepKindSet kinds, std::size_t n, std::size_t last,
                        std::string_view text) const;

private:
    /// Steps one behind the other: all of them of one form.
    struct Block {
        enum class Form : std::uint8_t { kept, plain, measured };
        std::size_t first; ///< its first step
        std::size_t begin; ///< where that stands: in the text, or in kept_
        Form form;
        StepKindSet kinds;    ///< of its steps
        std::size_t measured; ///< where its lines are in kinds_ and sizes_
    };

    /// A block whose lines have been found.
    struct KnownBlock {
        std::size_t block = 0;
        std::vector<StepPlace> places = {};
    };

    /// The block that was asked of last.
    struct FoundBlock {
        std::size_t block = 0;
        std::size_t first = 0;
        std::size_t count = 0;
        const StepPlace* places = nullptr;

        bool has(std::size_t n) const { return n - first < count; }
    };

    /// The block of measured lines whose kinds were asked of last.
    struct MeasuredBlock {
        std::size_t block = 0;
        std::size_t first = 0;
        std::size_t count = 0;
        const std::uint8_t* kinds = nullptr;

        bool has(std::size_t n) const { return n - first < count; }
    };

    void begin_block(std::size_t begin, Block::Form form);
    std::size_t end_of(std::size_t block) const;
    std::size_t block_of(std::size_t n) const;
    std::size_t block_asked_for(std::size_t n) const;
    void find(std::size_t block, std::string_view text) const;
    void find_lines(const Block& block, std::size_t count, std::string_view text,
                    std::vector<StepPlace>& places) const;
    bool take_measured(std::size_t block) const;
    void forget_text(std::size_t begin, std::size_t end) const;
    void forget_found() { found_.count = measured_.count = 0; }

    std::shared_ptr<const MappedFile> file_;
    std::vector<Block> blocks_;
    std::vector<StepPlace> kept_;
    std::vector<std::uint8_t> kinds_;  ///< of the measured lines
    std::vector<std::uint16_t> sizes_; ///< the same
    std::size_t size_ = 0;
    std::size_t end_of_line_ = 0; ///< behind the last plain step

    mutable std::vector<KnownBlock> known_; ///< a block has one place here, whatever is there
    mutable FoundBlock found_ = {};
    mutable MeasuredBlock measured_ = {};
    mutable std::size_t in_memory_ = 0; ///< bytes of a mapped file, since they were last forgotten
    mutable std::size_t last_end_ = 0;  ///< of the text that was looked at last
};

} // namespace rastertrace
