// SPDX-License-Identifier: MIT
#pragma once

// What has been found to differ between two traces so far: how often, the first of it, and the pixels that it led to.
//
//     tally.begin_section({.id = 1, .name = "ABC", ...});
//     tally.add_changed(place, a, b, fields);
//     tally.end_section();

#include "diff_fields.h"
#include "step_lines.h"

#include <rastertrace/trace/diff.h>

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {

/// The steps of a primitive, or those in front of the first one.
struct DiffSection {
    std::size_t id = 0;
    std::string
        json_a{}; ///< of the `primitive` step; "" in front of the first, and where a has none
    std::string json_b{};
    LinePlace begin_a{};
    LinePlace begin_b{};
};

/// The first step that differs, with where its primitive begins.
struct FirstDifference {
    std::size_t place = 0; ///< in the order of the comparison
    std::optional<StepLine> a{};
    std::optional<StepLine> b{};
    std::vector<FieldDifference> fields{};
    bool is_moved = false;
    DiffSection section{};
};

class DiffTally {
public:
    void begin_section(DiffSection section) { section_ = std::move(section); }

    /// Steps come with their place in the order of the comparison: what differs at one place belongs together.
    void add_changed(std::size_t place, const StepLine& a, const StepLine& b,
                     std::vector<FieldDifference> fields);
    void add_only_a(std::size_t place, const StepLine& a);
    void add_only_b(std::size_t place, const StepLine& b);
    void add_moved(std::size_t place, const StepLine& a, const StepLine& b);

    /// The steps of a primitive have come to their end: says which pixels came of the first difference.
    void end_section();

    bool is_empty() const { return kinds_.empty(); }
    const std::optional<FirstDifference>& first() const { return first_; }
    const Consequences& led_to() const { return led_to_; }

    /// In the order of step_kind.h; those that we do not know come last.
    std::vector<KindDifference> kinds() const;

private:
    enum class PixelChange { only_a, only_b, color };
    struct PixelEvent {
        Pixel pixel;
        PixelChange change;
    };

    KindDifference& of_kind(const StepLine& step);
    void note_first(std::size_t place, const StepLine* a, const StepLine* b,
                    std::vector<FieldDifference> fields, bool is_moved);
    void note_pixel(const StepLine& step, PixelChange change);
    bool is_due_to_first(Pixel pixel) const;

    DiffSection section_;
    std::map<std::string, KindDifference> kinds_;
    std::optional<FirstDifference> first_;
    std::vector<PixelEvent> pixels_; ///< of this section
    Consequences led_to_;
    std::set<std::pair<int, int>> due_; ///< x, y of the pixels in led_to_
};

} // namespace rastertrace
