// SPDX-License-Identifier: MIT
#include "diff_context.h"

#include <rastertrace/trace/record/frame.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/describe.h>

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// So many bytes of steps are kept for the sentences: in front of all primitives, from the
/// beginning of the primitive, and in front of the spot. Between the last two, the last step of each
/// kind is kept.
constexpr std::size_t most_kept = 1'000'000;

/// So many steps are told before and behind the one that differs.
constexpr std::size_t steps_around = 1;

/// Where something is in a trace: a step, or the place where it would be.
struct Spot {
    LinePlace place{};
    bool is_step = false;
};

/// A pixel, and which steps at it are meant: depth tests, or those that plot it.
using PixelOfKind = std::tuple<StepKind, Index, Index>;

/// The steps before it, the step, those after it.
using Around = std::tuple<std::vector<DiffStep>, std::optional<DiffStep>, std::vector<DiffStep>>;

/// A part of a trace, from which sentences can be made.
class Excerpt {
public:
    explicit Excerpt(const TraceText& text) : text_(text), trace_(text.header().without_steps()) {}

    /// Adds the steps from a place on, as long as `wants` says so.
    template <typename Wants> void add(LinePlace from, const Wants& wants) {
        StepLines lines(text_, from);
        for (; const StepLine* const line = lines.front(); lines.pass()) {
            if (!wants(*line))
                break;
            add(line->json, line->kind, line->place);
        }
    }

    /// Adds the steps of a primitive up to an offset. The row of the last pixel may stand far behind
    /// the beginning.
    void add_primitive(LinePlace from, std::size_t end) {
        LastSteps last; // of each kind, between the parts kept
        StepLines(text_, from, end).pass_all_lines([&](std::string_view line, LinePlace place) {
            if (StepLines::is_blank(line))
                return;
            const std::string_view json = step_of_line(line);
            const auto kind = kind_in_front(json);
            if (place.offset >= from.offset + most_kept && place.offset + most_kept < end) {
                auto& [at, text] = last[kind];
                at = place;
                text.assign(json);
                return;
            }
            add_in_order(std::exchange(last, {}));
            add(json, kind, place);
        });
        add_in_order(last);
    }

    /// Adds the steps in front of an offset that tell of some pixels, with their primitives.
    void add_about(const std::set<PixelOfKind>& pixels, std::size_t end) {
        std::pair<LinePlace, std::string> primitive;
        const auto see = [&](std::string_view line, LinePlace place) {
            const std::string_view json = step_of_line(line);
            const auto kind = kind_in_front(json);
            if (kind == StepKind::primitive)
                primitive = {place, std::string(json)};
            const auto pixel = pixel_of(kind, StepView(json));
            if (!pixel || !pixels.contains(*pixel))
                return;
            if (!primitive.second.empty())
                add(std::exchange(primitive.second, {}), StepKind::primitive, primitive.first);
            add(json, kind, place);
        };
        if (!pixels.empty())
            StepLines(text_, {}, end).pass_all_lines(see);
    }

    /// The pixels of the steps that are told around a spot, whose sentences say what was there before.
    std::set<PixelOfKind> told_pixels(const Spot& spot) const {
        std::set<PixelOfKind> pixels;
        for (std::size_t n = 1; n <= trace_.size(); ++n)
            if (const auto pixel = pixel_of(trace_.kind_of(n), trace_.step(n));
                pixel && is_told(n, spot))
                pixels.insert(*pixel);
        return pixels;
    }

    /// What there is around a spot, the last of the steps that have been added.
    Around around(const Spot& spot) const {
        Around found;
        auto& [before, here, after] = found;
        Replay replay(trace_, {.depths = true});
        for (std::size_t n = 1; n <= trace_.size(); ++n) {
            const std::size_t number = trace_.number_of(n);
            const std::size_t at = spot.place.steps + 1;
            if (!is_told(n, spot))
                continue;
            replay.go_to(n);
            DiffStep step{.number = number,
                          .line = text_.has_lines() ? lines_[n - 1] + 2 : 0,
                          .json = std::string(trace_.step(n).json()),
                          .sentence = describe_step(replay)};
            if (number < at)
                before.push_back(std::move(step));
            else if (number == at && spot.is_step)
                here = std::move(step);
            else
                after.push_back(std::move(step));
        }
        return found;
    }

private:
    /// True if step n is told around a spot.
    bool is_told(std::size_t n, const Spot& spot) const {
        const std::size_t last = spot.place.steps + steps_around + (spot.is_step ? 1 : 0);
        return trace_.number_of(n) + steps_around > spot.place.steps && trace_.number_of(n) <= last;
    }

    /// The pixel that a depth test or a plotted pixel is about.
    static std::optional<PixelOfKind> pixel_of(std::optional<StepKind> kind, const StepView& step) {
        const bool is_one = kind == StepKind::depth || kind == StepKind::pixel;
        const auto x = is_one ? x_in(step) : std::nullopt;
        const auto y = is_one ? y_in(step) : std::nullopt;
        return x && y ? std::optional(PixelOfKind(*kind, *x, *y)) : std::nullopt;
    }

    using LastSteps = std::map<std::optional<StepKind>, std::pair<LinePlace, std::string>>;

    /// The kind of a step, without a look behind its name if that stands in front.
    static std::optional<StepKind> kind_in_front(std::string_view json) {
        if (!json.starts_with(front_of_step))
            return StepView(json).kind();
        const std::string_view name = json.substr(front_of_step.size());
        return step_kind_named(name.substr(0, name.find('"')));
    }

    void add(std::string_view json, std::optional<StepKind> kind, LinePlace place) {
        trace_.add_to_excerpt(StepView(json), kind, place.steps + 1);
        lines_.push_back(place.lines);
    }

    void add_in_order(const LastSteps& steps) {
        std::map<std::size_t, LastSteps::const_iterator> by_number;
        for (auto one = steps.begin(); one != steps.end(); ++one)
            by_number.emplace(one->second.first.steps, one);
        for (const auto& [number, one] : by_number)
            add(one->second.second, one->first, one->second.first);
    }

    const TraceText& text_;
    Trace trace_;
    std::vector<std::size_t> lines_; ///< of the text in front of each step
};

Around around(const TraceText& text, LinePlace primitive, const Spot& spot) {
    const std::size_t offset = spot.place.offset;
    const auto excerpt_with = [&](const std::set<PixelOfKind>& pixels) {
        Excerpt excerpt(text);
        // What stands in front of all primitives: matrices, vertices, the painter's order.
        const std::size_t begin = text.begin();
        excerpt.add({}, [&](const StepLine& line) {
            return line.kind != StepKind::primitive && line.place.offset < offset &&
                   line.place.offset < begin + most_kept;
        });
        // The primitive, up to the spot.
        if (primitive.offset != 0) {
            excerpt.add_about(pixels, primitive.offset);
            excerpt.add_primitive(primitive, offset);
        }
        // One more than is told: a sentence may depend on what comes next.
        std::size_t rest = steps_around + (spot.is_step ? 2 : 1);
        excerpt.add(spot.place, [&rest](const StepLine&) { return rest-- > 0; });
        return excerpt;
    };
    return excerpt_with(excerpt_with({}).told_pixels(spot)).around(spot);
}

/// Where a side's step is, or else where the comparison was.
std::optional<Spot> spot_of(const std::optional<StepLine>& step,
                            const std::optional<LinePlace>& place) {
    if (step)
        return Spot{step->place, true};
    return place ? std::optional(Spot{*place, false}) : std::nullopt;
}

} // namespace

void tell_first(TraceDiff& found, const TraceComparison& comparison, const TraceText& a,
                const TraceText& b) {
    const auto& first = comparison.tally().first();
    if (!first)
        return;
    const auto& gap = comparison.first_gap();
    const bool is_here = gap && gap->number == first->gap;
    const StepLine& step = first->a ? *first->a : *first->b;
    StepDifference difference{
        .kind = step.kind_name, .fields = first->fields, .is_moved = first->is_moved};
    const std::string& json = first->a ? first->section.json_a : first->section.json_b;
    difference.primitive = name_in(StepView(json)).text();
    if (const auto spot = spot_of(first->a, is_here ? std::optional(gap->a) : std::nullopt))
        std::tie(found.before_a, difference.a, found.after_a) =
            around(a, first->section.begin_a, *spot);
    if (const auto spot = spot_of(first->b, is_here ? std::optional(gap->b) : std::nullopt))
        std::tie(found.before_b, difference.b, found.after_b) =
            around(b, first->section.begin_b, *spot);
    found.first = std::move(difference);
}

} // namespace rastertrace
