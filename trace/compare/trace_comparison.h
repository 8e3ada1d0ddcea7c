// SPDX-License-Identifier: MIT
#pragma once

// Two traces gone through together: primitive by primitive, and within each step by step. Where steps are not the same,
// they are found by their keys, a little way ahead.
//
//     TraceComparison comparison(a, b, options);
//     comparison.run();
//     comparison.tally().kinds();

#include "compared_steps.h"
#include "diff.h"
#include "diff_fields.h"
#include "diff_picture.h"
#include "diff_tally.h"
#include "primitive_pairs.h"
#include "steps_ahead.h"
#include "waiting_steps.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {

/// One of the two traces, as far as it has been gone through.
struct DiffSide {
    const Trace& trace;
    bool is_a; ///< the first of the two
    StepsAhead steps;
    std::optional<OwnedPicture> picture{};  ///< nothing: it is drawn elsewhere
    std::vector<std::size_t> primitives{};  ///< by number of their steps
    std::size_t primitive_step = 0;         ///< of the current one; 0 in front of the first
    bool tells_colors = false;              ///< so far
    bool breaks_off = false;                ///< the trace ends within what is gone through
    std::set<std::string> whole_in_other{}; ///< primitives that are in parts here and not there

    /// The whole trace, with its picture.
    DiffSide(const Trace& of, bool is_first, const StepKeys& keys)
        : trace(of), is_a(is_first), steps(of, 1, of.size(), keys), picture(of.canvas),
          breaks_off(of.cut_short.has_value()) {}

    /// A part of it.
    DiffSide(const DiffSide& of, const PrimitivePlace& part, bool is_broken, const StepKeys& keys)
        : trace(of.trace), is_a(of.is_a), steps(of.trace, part.begin, part.end - 1, keys),
          breaks_off(is_broken), whole_in_other(of.whole_in_other) {}

    /// True if step n begins a part, or tells a new corner, of what the other trace has whole: its steps are the whole's.
    bool tells_part(std::size_t n) const;

    /// Goes on by the next step.
    void pass();

    /// The n-th primitive, from 1; one without a name for 0.
    OwnerOfPixels primitive(std::uint32_t number) const;
};

/// Where both traces are when a gap begins, see DiffTally.
struct DiffGap {
    std::size_t number = 0;
    std::size_t a = 0; ///< the next step of each
    std::size_t b = 0;
};

class TraceComparison {
public:
    TraceComparison(const Trace& a, const Trace& b, const DiffOptions& options);

    void run();

    const DiffTally& tally() const { return tally_; }
    const std::vector<std::string>& remarks() const { return remarks_; }
    const std::optional<DiffGap>& first_gap() const { return first_gap_; }

    /// How the pictures differ, and what of it comes of the first difference; nothing if the traces do not tell.
    std::optional<std::pair<PictureDifference, Consequences>> picture() const;

    /// Where each trace breaks off, if it does.
    std::vector<Problem> damage() const;
    bool is_cut_off() const { return a_.trace.cut_short || b_.trace.cut_short; }

private:
    bool compare_in_order();
    void compare_pairs();
    void compare_section(DiffSide& a, DiffSide& b);
    void compare_primitives(const PrimitivePlace& of_a, const PrimitivePlace& of_b, bool has_moved,
                            bool breaks_off);
    void begin_primitive(DiffSide& a, DiffSide& b);
    void begin_section();
    void compare(const KeyedStep& a, const KeyedStep& b);
    void add_primitive(const DiffSide& side, const PrimitivePlace& primitive);

    const KeyedStep* next_compared(DiffSide& side);
    const KeyedStep* ahead(DiffSide& side, std::size_t i) const;
    bool begins_section(const DiffSide& side, std::size_t n) const {
        return has_primitives_ && side.trace.kind_of(n) == StepKind::primitive &&
               !side.tells_part(n);
    }
    bool has(const DiffSide& side, const KeyedStep& step) const {
        return compared_.has(step) && !side.tells_part(step.number);
    }

    void realign(DiffSide& a, DiffSide& b);
    void begin_gap(const DiffSide& a, const DiffSide& b);
    bool pass_gap(DiffSide& side, DiffSide& other);
    void put_aside(DiffSide& side, std::size_t steps);
    bool finds_elsewhere(const DiffSide& side, const KeyedStep& step);
    void give_up_waiting(bool breaks_off = false);
    void pass_equal_steps(DiffSide& a, DiffSide& b);

    std::uint32_t b_of_a(std::uint32_t of_a) const;

    const DiffOptions& options_;
    ComparedSteps compared_;
    bool has_primitives_;
    FieldComparison fields_;
    DiffSide a_;
    DiffSide b_;
    DiffTally tally_;
    WaitingSteps waiting_a_;
    WaitingSteps waiting_b_;
    std::optional<DiffGap> first_gap_;
    std::size_t gap_ = 0;         ///< the number of the last one
    std::size_t steps_to_search_; ///< for what stands behind a gap: in all as many as both have
    bool is_compared_ = true;     ///< the steps of the current primitive are
    std::uint32_t common_primitives_ = 0; ///< so many come in the same order in both
    std::vector<std::uint32_t> partner_;  ///< of those behind them in a: the one in b; 0: none
    std::vector<std::string> remarks_;
};

} // namespace rastertrace
