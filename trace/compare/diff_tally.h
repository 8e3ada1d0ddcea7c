// SPDX-License-Identifier: MIT
#pragma once

// What has been found to differ between two traces so far: how often, and the first of it.
//
//     tally.begin_section({.json_a = ..., .json_b = ...});
//     tally.add_changed(gap, a, b, fields);
//     tally.kinds();

#include "diff.h"
#include "steps_ahead.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {

/// The steps of a primitive, or those in front of the first one.
struct DiffSection {
    std::size_t a = 0; ///< its `primitive` step; 0 in front of the first, and where a has none
    std::size_t b = 0;
};

/// The first step that differs, with where its primitive begins.
struct FirstDifference {
    std::size_t gap = 0;
    std::optional<KeyedStep> a{};
    std::optional<KeyedStep> b{};
    std::vector<FieldDifference> fields{};
    bool is_moved = false;
    DiffSection section{};
};

/// Counts differences. Each comes with its gap: the two traces are gone through together, and whenever they are not
/// alike a gap begins, which ends where they are alike again. Gaps are numbered in the order of the traces. If a gap
/// has a step of a alone and one of b alone, one stands in place of the other.
class DiffTally {
public:
    /// Without `counts_moved` steps that stand elsewhere are none.
    explicit DiffTally(bool counts_moved) : counts_moved_(counts_moved) {}

    void begin_section(const DiffSection& section) { section_ = section; }

    void add_changed(std::size_t gap, const KeyedStep& a, const KeyedStep& b,
                     std::vector<FieldDifference> fields);
    void add_alone(std::size_t gap, bool is_in_a, const KeyedStep& step);
    void add_moved(std::size_t gap, const KeyedStep& a, const KeyedStep& b);

    bool is_empty() const { return kinds_.empty(); }
    const std::optional<FirstDifference>& first() const { return first_; }

    /// In the order of step_kind.h; those that we do not know come last.
    std::vector<KindDifference> kinds() const;

private:
    KindDifference& of_kind(const KeyedStep& step);
    void note_first(std::size_t gap, const KeyedStep* a, const KeyedStep* b,
                    std::vector<FieldDifference> fields, bool is_moved);

    bool counts_moved_;
    DiffSection section_;
    std::map<std::string, KindDifference> kinds_;
    std::optional<FirstDifference> first_;
};

} // namespace rastertrace
