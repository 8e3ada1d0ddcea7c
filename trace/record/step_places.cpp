// SPDX-License-Identifier: MIT
#include "step_places.h"

#include "step_decoder.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <charconv>

namespace rastertrace {

namespace {

constexpr std::size_t blocks_found = 256;

/// Of so many steps kinds and lengths are kept. Those of the lines behind them are found again in the text: memory is
/// bounded, for whatever a pipe may have.
constexpr std::size_t most_measured = std::size_t{1} << 23U;

/// So many bytes of a mapped file may be in memory.
constexpr std::size_t most_in_memory = std::size_t{8} << 20U;

/// Who looks at one byte of a mapped file may get so many.
constexpr std::size_t mapped_at_once = std::size_t{64} << 10U;

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

void StepPlaces::begin_block(std::size_t begin, Block::Form form) {
    blocks_.push_back(
        {.first = size_ + 1, .begin = begin, .form = form, .kinds = {}, .measured = kinds_.size()});
}

std::size_t StepPlaces::end_of(std::size_t block) const {
    return block + 1 < blocks_.size() ? blocks_[block + 1].first : size_ + 1;
}

void StepPlaces::add(const StepPlace& step) {
    using enum Block::Form;
    const auto has_room = [&] {
        return !blocks_.empty() && size_ + 1 - blocks_.back().first < steps_in_block &&
               blocks_.back().form != measured;
    };
    if (step.is_plain) {
        // Steps that stand alone between others that are kept are kept, too.
        const bool goes_on =
            has_room() && (blocks_.back().form == kept || step.offset - end_of_line_ <= 2);
        if (!goes_on)
            begin_block(step.offset, plain);
        end_of_line_ = step.offset + step.length;
    } else if (!has_room() || blocks_.back().form == plain) {
        begin_block(kept_.size(), kept);
    }
    if (step.kind)
        blocks_.back().kinds.add(*step.kind);
    if (blocks_.back().form == kept) {
        kept_.push_back(step);
        forget_found();
    }
    ++size_;
}

void StepPlaces::add_lines(const MeasuredLines& lines) {
    const bool are_measured = kinds_.size() + lines.kinds.size() <= most_measured;
    std::size_t offset = lines.begin;
    for (std::size_t i = 0; i < lines.kinds.size(); i += steps_in_block) {
        const std::size_t count = std::min(steps_in_block, lines.kinds.size() - i);
        begin_block(offset, are_measured ? Block::Form::measured : Block::Form::plain);
        blocks_.back().measured += i;
        size_ += count;
        for (std::size_t line = i; line < i + count; ++line) {
            offset += lines.sizes[line];
            blocks_.back().kinds.add(static_cast<StepKind>(lines.kinds[line]));
        }
    }
    forget_found();
    if (!are_measured) {
        end_of_line_ = lines.end - 1;
        return;
    }
    kinds_.insert(kinds_.end(), lines.kinds.begin(), lines.kinds.end());
    sizes_.insert(sizes_.end(), lines.sizes.begin(), lines.sizes.end());
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

std::size_t StepPlaces::block_of(std::size_t n) const {
    const auto behind =
        std::upper_bound(blocks_.begin(), blocks_.end(), n,
                         [](std::size_t step, const Block& block) { return step < block.first; });
    return static_cast<std::size_t>(behind - blocks_.begin()) - 1;
}

void StepPlaces::find_lines(const Block& block, std::size_t count, std::string_view text,
                            std::vector<StepPlace>& places) const {
    std::size_t offset = block.begin;
    if (block.form == Block::Form::measured) {
        for (std::size_t i = block.measured; i < block.measured + count; ++i) {
            const std::size_t end = offset + sizes_[i] - 1;
            places.push_back({.offset = offset,
                              .length = static_cast<std::uint32_t>(end - offset -
                                                                   (text[end - 1] == ',' ? 1 : 0)),
                              .kind = static_cast<StepKind>(kinds_[i]),
                              .is_plain = true});
            offset = end + 1;
        }
        return;
    }
    while (places.size() < count) {
        while (text[offset] == '\n' || text[offset] == ',')
            ++offset;
        const std::size_t end = std::min(text.find('\n', offset), text.size());
        add_steps_of(text.substr(offset, end - offset), offset, places);
        offset = end;
    }
}

/// The same, of the blocks that were asked of last without a search.
std::size_t StepPlaces::block_asked_for(std::size_t n) const {
    return found_.has(n) ? found_.block : measured_.has(n) ? measured_.block : block_of(n);
}

void StepPlaces::find(std::size_t block, std::string_view text) const {
    const Block& wanted = blocks_[block];
    const std::size_t count = end_of(block) - wanted.first;
    const StepPlace* places = nullptr;
    if (wanted.form == Block::Form::kept) {
        places = kept_.data() + wanted.begin;
    } else {
        known_.resize(blocks_found);
        KnownBlock& known = known_[block % blocks_found];
        if (known.block != block || known.places.size() < count) {
            found_.count = 0; // its places may be those that are replaced
            known.block = block;
            known.places.clear();
            find_lines(wanted, count, text, known.places);
        }
        places = known.places.data();
    }
    found_ = {.block = block, .first = wanted.first, .count = count, .places = places};
    forget_text(places[0].offset, places[count - 1].offset + places[count - 1].length);
}

/// Takes the kinds of a block, if its lines have been measured.
bool StepPlaces::take_measured(std::size_t block) const {
    const Block& wanted = blocks_[block];
    if (wanted.form != Block::Form::measured)
        return false;
    measured_ = {.block = block,
                 .first = wanted.first,
                 .count = end_of(block) - wanted.first,
                 .kinds = kinds_.data() + wanted.measured};
    return true;
}

std::size_t StepPlaces::next_of(StepKindSet kinds, std::size_t n, std::size_t last,
                                std::string_view text) const {
    assert(n > 0 && last <= size());
    if (n > last)
        return last + 1;
    for (std::size_t block = block_asked_for(n); n <= last; ++block) {
        const std::size_t end = std::min(end_of(block), last + 1);
        if (blocks_[block].kinds.has_any_of(kinds)) {
            if (!found_.has(n) && !take_measured(block))
                find(block, text);
            for (; n < end; ++n)
                if (const auto its = kind(n, text); its && kinds.has(*its))
                    return n;
        }
        n = end;
    }
    return n;
}

/// The text from `begin` to `end` is looked at: what was looked at before is forgotten, if it has become too much.
void StepPlaces::forget_text(std::size_t begin, std::size_t end) const {
    if (!file_)
        return;
    if (in_memory_ > most_in_memory) {
        file_->forget();
        in_memory_ = 0;
    }
    // The lines of an excerpt may stand far from each other, in any order.
    const bool goes_on = begin - last_end_ < mapped_at_once;
    in_memory_ += std::min(end - begin, steps_in_block * mapped_at_once);
    in_memory_ += goes_on ? 0 : mapped_at_once;
    last_end_ = end;
}

} // namespace rastertrace
