// SPDX-License-Identifier: MIT
#pragma once

// Some pixels of a canvas, by their offsets (Canvas::offset_of), in ascending order and each once. Pixels side by side are
// held as runs, of 64 at most: four bytes a run.
//
//     const PixelSet pixels(std::vector<std::uint32_t>{39, 55, 56});
//     pixels.contains(55);                           // true
//     for (const std::uint32_t offset : pixels) ...  // 39, 55, 56

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

namespace rastertrace {

class PixelSet {
public:
    class Iterator {
    public:
        using iterator_concept = std::forward_iterator_tag;
        using iterator_category = std::input_iterator_tag; // what it gives is no reference
        using value_type = std::uint32_t;
        using difference_type = std::ptrdiff_t;
        using pointer = const std::uint32_t*;
        using reference = std::uint32_t;

        Iterator() = default;

        std::uint32_t operator*() const { return first_of(*run_) + place_; }
        Iterator& operator++() {
            if (place_ < more_in(*run_))
                ++place_;
            else
                *this = Iterator(run_ + 1, 0);
            return *this;
        }
        Iterator operator++(int) {
            const Iterator before = *this;
            ++*this;
            return before;
        }
        bool operator==(const Iterator&) const = default;

    private:
        friend class PixelSet;
        Iterator(const std::uint32_t* run, std::uint32_t place) : run_(run), place_(place) {}

        const std::uint32_t* run_ = nullptr;
        std::uint32_t place_ = 0; ///< in the run
    };

    struct Part {
        Iterator from, to;
        Iterator begin() const { return from; }
        Iterator end() const { return to; }
    };

    PixelSet() = default;

    /// Of offsets in any order and however often, each below 2^26, the most pixels of a canvas.
    explicit PixelSet(std::vector<std::uint32_t> offsets);

    bool empty() const { return runs_.empty(); }
    std::size_t size() const;
    std::uint32_t front() const { return first_of(runs_.front()); }
    std::uint32_t back() const { return last_of(runs_.back()); }
    bool contains(std::uint32_t offset) const;

    Iterator begin() const { return {runs_.data(), 0}; }
    Iterator end() const { return {runs_.data() + runs_.size(), 0}; }

    /// The first pixel with an offset that is not smaller than this one.
    Iterator not_before(std::uint32_t offset) const;

    /// Those with an offset from `first` to before `end`.
    Part part(std::uint32_t first, std::uint32_t end) const {
        return {not_before(first), not_before(end)};
    }

private:
    // A run: the offset of its first pixel, and how many follow.
    static constexpr unsigned bits_of_more = 6;
    static constexpr std::uint32_t most_more = (1U << bits_of_more) - 1;

    static constexpr std::uint32_t first_of(std::uint32_t run) { return run >> bits_of_more; }
    static constexpr std::uint32_t more_in(std::uint32_t run) { return run & most_more; }
    static constexpr std::uint32_t last_of(std::uint32_t run) {
        return first_of(run) + more_in(run);
    }

    std::vector<std::uint32_t> runs_;
};

} // namespace rastertrace
