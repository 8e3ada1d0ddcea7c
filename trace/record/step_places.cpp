// SPDX-License-Identifier: MIT
#include "step_places.h"

#include "step_decoder.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <iterator>

namespace rastertrace {

namespace {

constexpr std::size_t steps_in_block = 64;
constexpr std::size_t blocks_found = 256;

/// Takes a number and the blank or the end behind it from the front of a line.
int take_number(std::string_view& line) {
    int number = 0;
    const char* const end = std::from_chars(line.data(), line.data() + line.size(), number).ptr;
    line.remove_prefix(std::min(static_cast<std::size_t>(end - line.data()) + 1, line.size()));
    return number;
}

/// Adds the steps of a line, of which the first stands at `offset` of the text.
void add_steps_of(std::string_view line, std::size_t offset, std::vector<StepPlace>& places) {
    if (line.starts_with('{')) {
        line.remove_suffix(line.ends_with(',') ? 1 : 0);
        places.push_back({.offset = offset,
                          .length = static_cast<std::uint32_t>(line.size()),
                          .kind = kind_of_plain_step(line),
                          .is_plain = true});
        return;
    }
    Pixel pixel;
    pixel.x = take_number(line);
    pixel.y = take_number(line);
    for (int i = take_number(line); i > 0; --i, ++pixel.x)
        places.push_back({.kind = StepKind::pixel, .is_plain = true, .pixel = pixel});
}

} // namespace

void StepPlaces::begin_block(std::size_t begin, bool is_plain) {
    blocks_.push_back({.first = size_ + 1, .begin = begin, .is_plain = is_plain});
}

std::size_t StepPlaces::end_of(std::size_t block) const {
    return block + 1 < blocks_.size() ? blocks_[block + 1].first : size_ + 1;
}

void StepPlaces::add(const StepPlace& step) {
    const auto has_room = [&] {
        return !blocks_.empty() && size_ + 1 - blocks_.back().first < steps_in_block;
    };
    if (step.is_plain) {
        // Steps that stand alone between others that are kept are kept, too.
        const bool goes_on =
            has_room() && (!blocks_.back().is_plain || step.offset - end_of_line_ <= 2);
        if (!goes_on)
            begin_block(step.offset, true);
        end_of_line_ = step.offset + step.length;
    } else if (!has_room() || blocks_.back().is_plain) {
        begin_block(kept_.size(), false);
    }
    if (!blocks_.back().is_plain) {
        kept_.push_back(step);
        at_hand_.count = 0;
    }
    ++size_;
}

void StepPlaces::add_run(std::string& text, Pixel first, std::size_t count) {
    const std::string line = fmt::format("{} {} {}", first.x, first.y, count);
    add({.offset = text.size(),
         .length = static_cast<std::uint32_t>(line.size()),
         .kind = StepKind::pixel,
         .is_plain = true});
    size_ += count - 1;
    text.append(line) += '\n';
}

const StepPlace& StepPlaces::found(std::size_t n, std::string_view text) const {
    const auto behind =
        std::upper_bound(blocks_.begin(), blocks_.end(), n,
                         [](std::size_t step, const Block& block) { return step < block.first; });
    const auto place = static_cast<std::size_t>(behind - blocks_.begin()) - 1;
    const Block& block = blocks_[place];
    if (!block.is_plain)
        return take_to_hand(place, kept_.data() + block.begin, n);

    const std::size_t count = end_of(place) - block.first;
    found_.resize(blocks_found);
    FoundBlock& known = found_[place % blocks_found];
    if (known.block != place || known.places.size() < count) {
        known.block = place;
        known.places.clear();
        std::size_t offset = block.begin;
        while (known.places.size() < count) {
            while (text[offset] == '\n' || text[offset] == ',')
                ++offset;
            const std::size_t end = std::min(text.find('\n', offset), text.size());
            add_steps_of(text.substr(offset, end - offset), offset, known.places);
            offset = end;
        }
    }
    return take_to_hand(place, known.places.data(), n);
}

const StepPlace& StepPlaces::take_to_hand(std::size_t block, const StepPlace* places,
                                          std::size_t n) const {
    at_hand_.first = blocks_[block].first;
    at_hand_.count = end_of(block) - at_hand_.first;
    at_hand_.places = places;
    return places[n - at_hand_.first];
}

} // namespace rastertrace
