// SPDX-License-Identifier: MIT
#pragma once

// The steps of a trace in memory: a list for each kind, and their order. Pixels that a row plots one after the other, in
// the color of their primitive, are held as one.
//
//     Steps steps;
//     steps.take(ScanlineStep{.y = 2, ...});
//     steps.at(1).as<ScanlineStep>().y;  // 2

#include "arena.h"
#include "trace.h"
#include "traced_steps.h"

#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/trace/text/problem.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace rastertrace {

class Steps {
public:
    Steps() = default;
    explicit Steps(Source source) : source_(std::move(source)) {}
    Steps(const Steps&) = delete;
    Steps& operator=(const Steps&) = delete;

    /// What the steps were read from; of those that were drawn, the name of their scene.
    const Source& source() const { return source_; }

    /// For what the values of steps that are added refer to.
    Arena& arena() { return arena_; }

    /// From now on, more steps than that, or steps that take too much memory, are refused (input.h).
    void bound(std::size_t most_steps);

    /// Adds a step. Throws a Problem if there are more than may be held.
    template <typename Step> void take(const Step& step) {
        count_value();
        add(step);
    }
    void take(const PixelStep& step);
    void take(const AnyStep& step) {
        std::visit([this](const auto& one) { take(one); }, step);
    }

    /// Adds a step whose text, a part of the source, is not as this program writes it. Of no kind: nobody knows it, or
    /// it cannot be used.
    void take_text(std::optional<StepKind> kind, std::string_view json);

    std::size_t size() const { return order_.size(); }

    /// Step n, from 1 to size(), valid as long as this.
    StepView at(std::size_t n) const;

    std::optional<StepKind> kind(std::size_t n) const {
        const std::uint32_t code = order_[n - 1] >> bits_of_place;
        return code < step_kinds              ? std::optional(static_cast<StepKind>(code))
               : code == code_of_pixel_in_run ? std::optional(StepKind::pixel)
                                              : std::nullopt;
    }

    /// The text of step n, if that is not as this program writes it; else "".
    std::string_view text_of(std::size_t n) const;

    /// How many steps there are of the kinds that we know, and of any kind.
    KindCounts counts() const;
    std::uint64_t count(std::string_view kind) const;

private:
    /// An entry of the order: which list, and the place there.
    static constexpr unsigned bits_of_place = 27;
    static constexpr std::uint32_t code_of(StepKind kind) {
        return static_cast<std::uint32_t>(kind);
    }
    static constexpr std::uint32_t code_of_pixel_in_run = step_kinds;
    static constexpr std::uint32_t code_of_unknown = step_kinds + 1;

    template <typename Variant> struct ListsOf;
    template <typename... Kinds> struct ListsOf<std::variant<Kinds...>> {
        using type = std::tuple<ArenaList<Kinds>...>;
    };

    /// Pixels of a row, from left to right.
    struct Run {
        Pixel first;
        std::size_t step; ///< that plots it
    };

    /// A text, and its step.
    struct TextOfStep {
        std::size_t step;
        std::string_view json;
    };

    template <typename Step> void add(const Step& step) {
        auto& list = std::get<ArenaList<Step>>(lists_);
        add_entry(code_of(Step::step_kind), list.size());
        list.add(step, arena_);
    }
    void count_value();
    void add_entry(std::uint32_t code, std::size_t place);
    Pixel pixel_in_run(std::size_t n, const Run& run) const {
        return {run.first.x + static_cast<int>(n - run.step), run.first.y};
    }

    Source source_;
    Arena arena_;
    ListsOf<AnyStep>::type lists_;
    ArenaList<Run> runs_;
    ArenaList<std::uint32_t> order_;
    std::vector<TextOfStep> texts_; ///< in the order of their steps
    std::size_t values_ = 0;        ///< a run is one
    std::size_t pixels_in_runs_ = 0;
    std::size_t most_ = any_number;
    std::size_t most_bytes_ = any_number;
    std::size_t most_pixels_ = any_number; ///< in runs
};

} // namespace rastertrace
