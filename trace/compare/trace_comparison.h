// SPDX-License-Identifier: MIT
#pragma once

// Two traces gone through together: primitive by primitive, and within each step by step. Lines that are the same are
// passed as bytes; where lines differ, steps are found by their keys, a little way ahead.
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
#include "waiting_steps.h"

#include <rastertrace/trace/record/step_lines.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

/// One of the two traces, as far as it has been gone through.
struct DiffSide {
    const TraceText& text;
    bool is_a; ///< the first of the two
    StepLines lines;
    std::optional<OwnedPicture> picture{};  ///< nothing: it is drawn elsewhere
    std::vector<LinePlace> primitives{};    ///< where the step of each begins
    LinePlace begin{};                      ///< of the current primitive
    std::string json{};                     ///< of its step
    bool tells_colors = false;              ///< so far
    bool breaks_off = false;                ///< of a part: the trace ends within it
    std::set<std::string> whole_in_other{}; ///< primitives that are in parts here and not there

    /// The whole trace, with its picture.
    DiffSide(const TraceText& of, bool is_first, const StepKeys& keys)
        : text(of), is_a(is_first), lines(of, {}, nowhere, keys), picture(of.header().canvas) {}

    /// A part of it.
    DiffSide(const DiffSide& of, const PrimitivePlace& part, const StepKeys& keys)
        : text(of.text), is_a(of.is_a), lines(of.text, part.begin, part.end.offset, keys),
          whole_in_other(of.whole_in_other) {}

    /// True if a step begins a part, or tells a new corner, of what the other trace has whole: its steps are the whole's.
    bool tells_part(std::string_view line) const;

    /// Goes on by a step, of which so much has been seen.
    void see(const SeenStep& step, std::string_view line, LinePlace place);

    /// Goes on by the next step.
    void pass(const StepLine& line);

    /// The JSON of the step at a place, in front of an offset; "" if there is none.
    std::string step_at(LinePlace place, std::size_t end) const;

    /// The n-th primitive, from 1; one without a name for 0.
    OwnerOfPixels primitive(std::uint32_t number) const;
};

/// Where both traces are when a gap begins, see DiffTally.
struct DiffGap {
    std::size_t number = 0;
    LinePlace a{};
    LinePlace b{};
};

class TraceComparison {
public:
    TraceComparison(const TraceText& a, const TraceText& b, const DiffOptions& options);

    void run();

    const DiffTally& tally() const { return tally_; }
    const std::vector<std::string>& remarks() const { return remarks_; }
    const std::optional<DiffGap>& first_gap() const { return first_gap_; }

    /// How the pictures differ, and what of it comes of the first difference; nothing if the traces do not tell.
    std::optional<std::pair<PictureDifference, Consequences>> picture() const;

    /// Where each trace breaks off, if it does.
    std::vector<Problem> damage() const;
    bool is_cut_off() const { return a_.lines.is_cut_off() || b_.lines.is_cut_off(); }

    /// Where the steps of each trace end.
    LinePlace end_of_a() const { return a_.lines.place(); }
    LinePlace end_of_b() const { return b_.lines.place(); }

private:
    bool compare_in_order();
    void compare_pairs();
    void compare_section(DiffSide& a, DiffSide& b);
    void compare_primitives(const PrimitivePlace& of_a, const PrimitivePlace& of_b, bool has_moved,
                            bool breaks_off);
    void begin_primitive(DiffSide& a, DiffSide& b);
    void begin_section();
    void compare(const StepLine& a, const StepLine& b);
    void add_primitive(const TraceText& text, const PrimitivePlace& primitive, bool is_in_a);

    const StepLine* next_compared(DiffSide& side);
    const StepLine* ahead(DiffSide& side, std::size_t i) const;
    bool begins_section(const DiffSide& side, const StepLine& step) const {
        return has_primitives_ && step.kind == StepKind::primitive && !side.tells_part(step.json);
    }
    bool has(const DiffSide& side, const StepLine& step) const {
        return compared_.has(step) && !side.tells_part(step.json);
    }

    void realign(DiffSide& a, DiffSide& b);
    void begin_gap(const DiffSide& a, const DiffSide& b);
    bool pass_gap(DiffSide& side, DiffSide& other);
    void put_aside(DiffSide& side, std::size_t steps);
    bool finds_elsewhere(const DiffSide& side, const StepLine& step);
    void give_up_waiting(bool breaks_off = false);

    void pass_equal_lines(DiffSide& a, DiffSide& b);
    std::size_t pass_lines(DiffSide& a, DiffSide& b, std::string_view text);

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
    std::size_t gap_ = 0; ///< the number of the last one
    std::size_t
        bytes_to_search_;     ///< for what stands behind a gap: in all as much as both texts have
    bool is_compared_ = true; ///< the steps of the current primitive are
    std::uint32_t common_primitives_ = 0; ///< so many come in the same order in both
    std::vector<std::uint32_t> partner_;  ///< of those behind them in a: the one in b; 0: none
    std::vector<std::string> remarks_;
};

} // namespace rastertrace
