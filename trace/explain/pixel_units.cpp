// SPDX-License-Identifier: MIT
#include "pixel_units.h"

#include "explanation.h"
#include "why_not.h"

#include <rastertrace/trace/record/told_samples.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/formula.h>
#include <rastertrace/trace/tell/sheet.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/in_threads.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

FarReason far_reason_named(std::string_view name) {
    const auto found = std::find(far_reason_names.begin(), far_reason_names.end(), name);
    return static_cast<FarReason>(found - far_reason_names.begin());
}

/// Whole numbers that a float holds.
constexpr Index most_in_float = 1 << 24;

/// Larger numbers are infinite as a float, or may be.
constexpr double most_of_float = 1e38;

/// A point in doubles.
struct Place {
    double x;
    double y;
};

/// Collects what its steps tell of one primitive, or part.
class UnitSteps {
public:
    UnitSteps(const Trace& trace, std::size_t first, const PrimitiveStep& told, bool is_part)
        : trace_(trace),
          told_(told), unit_{.first = static_cast<std::uint32_t>(first), .is_part = is_part} {}

    bool is_whole = false; ///< see PrimitiveSteps
    bool has_clips = false;
    std::string skip{};

    void take(const StepView& step, StepKind kind) {
        switch (kind) {
        case StepKind::pixel:
        case StepKind::depth:
            return reach(x_in(step), y_in(step));
        case StepKind::sample:
            has_samples_ = true;
            return reach(x_in(step), y_in(step));
        case StepKind::reject:
            return take(step.as<RejectStep>());
        case StepKind::scanline:
            return take(step.as<ScanlineStep>());
        case StepKind::edge:
            return take(step.as<EdgeStep>());
        default:
            return;
        }
    }

    /// What is known at the end.
    PixelUnit finish() {
        if (!skip.empty())
            return nothing(far_reason_named(reason_of_skip(skip)));
        if (is_whole || (!told_.at && has_clips))
            return nothing(FarReason::clipped);
        if (!is_filled(told_.kind))
            return unit_;
        if (told_.painted.is_false())
            return nothing(FarReason::unpainted);
        const auto corners = corners_in_doubles();
        if (told_.kind != PrimitiveKind::triangle || !corners || is_odd_)
            return unit_;
        const auto [left, right] = std::minmax({(*corners)[0].x, (*corners)[1].x, (*corners)[2].x});
        const auto [low, high] = std::minmax({(*corners)[0].y, (*corners)[1].y, (*corners)[2].y});
        if (functions_ != 0) {
            unit_.rule = functions_ == 3 ? UnitRule::edges : UnitRule::ask;
        } else if (has_rows_) {
            for (const Index value : {low_row_, high_row_, from_, to_})
                if (std::abs(value) > most_in_float)
                    return unit_;
            unit_.rule = UnitRule::rows;
            unit_.values = {float(low_row_), float(high_row_), float(from_),
                            float(to_),      float(low),       float(high)};
        } else if (trace_.method_value("fill") == "barycentric") {
            unit_.rule = UnitRule::box;
            unit_.values = {float(left), float(right), float(low), float(high)};
        } else if (!has_samples_) {
            return nothing(has_fan_ || trace_.method_value("fill") == "fan" ? FarReason::outside
                                                                            : FarReason::unknown);
        }
        return unit_;
    }

private:
    /// Where the three corners are; `nullopt` if not each of them has a place that a float holds.
    std::optional<std::array<Place, 3>> corners_in_doubles() const {
        const auto places = told_.at.values();
        if (places.size() != 3 || told_.vertices.values().size() != 3)
            return std::nullopt;
        std::array<Place, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto place = places[i].values();
            const auto x = place.size() < 2 ? std::nullopt : place[0].nearest_double();
            const auto y = place.size() < 2 ? std::nullopt : place[1].nearest_double();
            if (!x || !y || std::max(std::abs(*x), std::abs(*y)) > most_of_float)
                return std::nullopt;
            corners[i] = {*x, *y};
        }
        return corners;
    }

    PixelUnit nothing(FarReason reason) {
        unit_.rule = UnitRule::nothing;
        unit_.reason = reason;
        return unit_;
    }

    const PrimitiveText& primitive() {
        if (!primitive_)
            primitive_ = primitive_in(told_);
        return *primitive_;
    }

    void reach(std::optional<Index> x, std::optional<Index> y) { reach(x, x, y, y); }

    /// Its steps are about these pixels; where a side is not told, about all.
    void reach(std::optional<Index> from_x, std::optional<Index> to_x, std::optional<Index> from_y,
               std::optional<Index> to_y) {
        const Canvas& canvas = trace_.canvas;
        const auto add = [](std::array<std::int16_t, 2>& range, std::optional<Index> one,
                            std::optional<Index> other, Index count) {
            const auto [least, most] = std::minmax({one.value_or(0), other.value_or(count - 1)});
            if (most < 0 || least >= count)
                return false;
            const bool is_empty = range[0] > range[1];
            const auto from = static_cast<std::int16_t>(std::max<Index>(least, 0));
            const auto to = static_cast<std::int16_t>(std::min(most, count - 1));
            range = {is_empty ? from : std::min(range[0], from),
                     is_empty ? to : std::max(range[1], to)};
            return true;
        };
        const auto column = [&](std::optional<Index> x) {
            return x ? std::optional(*x - canvas.left()) : std::nullopt;
        };
        const auto row = [&](std::optional<Index> y) {
            return y ? std::optional(canvas.row_of(*y)) : std::nullopt;
        };
        auto columns = unit_.columns;
        if (add(columns, column(from_x), column(to_x), canvas.width) &&
            add(unit_.rows, row(from_y), row(to_y), canvas.height))
            unit_.columns = columns;
    }

    void take(const RejectStep& dropped) {
        reach(dropped.x, dropped.x ? (dropped.to_x ? dropped.to_x : dropped.x) : std::nullopt,
              dropped.y, dropped.y ? (dropped.to_y ? dropped.to_y : dropped.y) : std::nullopt);
    }

    void take(const ScanlineStep& row) {
        const auto is_near = [](const TracedNumber& end, Index pixel) {
            const auto x = end.nearest_double();
            return x && std::abs(*x - static_cast<double>(pixel)) <= 2;
        };
        if (!is_near(row.left, row.from) || !is_near(row.right, row.to))
            is_odd_ = true;
        // They come from one end to the other, none left out.
        if (has_rows_ && row.y != low_row_ - 1 && row.y != high_row_ + 1)
            is_odd_ = true;
        low_row_ = has_rows_ ? std::min(low_row_, row.y) : row.y;
        high_row_ = has_rows_ ? std::max(high_row_, row.y) : row.y;
        from_ = has_rows_ ? std::min(from_, row.from) : row.from;
        to_ = has_rows_ ? std::max(to_, row.to) : row.to;
        has_rows_ = true;
    }

    void take(const EdgeStep& edge) {
        has_fan_ = has_edges_ ? has_fan_ : edge.octant.has_value();
        has_edges_ = true;
        if (!edge.a)
            return;
        const auto function = edge_function_in(trace_, edge, primitive());
        const double length =
            function ? std::hypot(nearest_double(function->a), nearest_double(function->b)) : 0;
        if (functions_ == 3 || !std::isnormal(length)) {
            is_odd_ = true;
            return;
        }
        float* const values = unit_.values.data() + 3 * functions_++;
        values[0] = static_cast<float>(nearest_double(function->a) / length);
        values[1] = static_cast<float>(nearest_double(function->b) / length);
        values[2] = static_cast<float>(
            nearest_double(function->a * function->from.x + function->b * function->from.y) /
            -length);
    }

    const Trace& trace_;
    PrimitiveStep told_;
    PixelUnit unit_;
    std::optional<PrimitiveText> primitive_;
    std::size_t functions_ = 0;
    bool has_rows_ = false;
    bool has_samples_ = false;
    bool has_edges_ = false;
    bool has_fan_ = false;
    bool is_odd_ = false; ///< what no fill of ours tells
    Index low_row_ = 0;
    Index high_row_ = 0;
    Index from_ = 0;
    Index to_ = 0;
};

/// A primitive and the parts that clipping has made of it.
class Group {
public:
    void begin(const Trace& trace, std::size_t n, const PrimitiveStep& told) {
        name_ = told.name.text();
        units_.clear();
        units_.emplace_back(trace, n, told, false);
    }

    /// The next primitive of the trace, if it is a part.
    bool takes(const Trace& trace, std::size_t n, const PrimitiveStep& told) {
        if (units_.empty() || !is_part_of(told, name_))
            return false;
        units_.front().is_whole = true;
        units_.emplace_back(trace, n, told, true);
        return true;
    }

    void take(const StepView& step, StepKind kind) {
        if (units_.empty())
            return;
        if (kind != StepKind::clip && kind != StepKind::skip)
            return units_.back().take(step, kind);
        UnitSteps& named = name_in(step).text() == name_ ? units_.front() : units_.back();
        if (kind == StepKind::clip)
            named.has_clips = true;
        else
            named.skip = step.as<SkipStep>().why.text();
    }

    void finish(PixelUnits& known) {
        std::vector<PixelUnit> done;
        for (UnitSteps& unit : units_)
            done.push_back(unit.finish());
        const bool is_nowhere = done.size() == 1 && done[0].rule == UnitRule::nothing &&
                                done[0].columns[0] > done[0].columns[1];
        if (is_nowhere)
            ++known.others[static_cast<std::size_t>(done[0].reason)];
        else
            known.units.insert(known.units.end(), done.begin(), done.end());
        units_.clear();
    }

private:
    std::string name_;
    std::vector<UnitSteps> units_;
};

/// Adds the contents of the next part of the trace.
void append(TraceContents& contents, const TraceContents& behind) {
    contents.known.are_known = contents.known.are_known && behind.known.are_known;
    for (std::size_t reason = 0; reason < far_reasons; ++reason)
        contents.known.others[reason] += behind.known.others[reason];
    const auto add = [](auto& to, const auto& from) {
        to.insert(to.end(), from.begin(), from.end());
    };
    add(contents.known.units, behind.known.units);
    add(contents.primitives, behind.primitives);
    add(contents.loose, behind.loose);
    add(contents.vertices, behind.vertices);
}

/// Of the steps from `first` to before `end`: those of whole primitives with all their parts.
TraceContents contents_of(const Trace& trace, const StepReader& steps, std::size_t first,
                          std::size_t end) {
    TraceContents found{.known = {.are_known = true}};
    Group group;
    for (std::size_t n = first; n < end; ++n) {
        const auto kind = steps.kind_of(n);
        // Lines of another program may lack what the rules below rely on.
        found.known.are_known = found.known.are_known && kind && steps.is_plain(n);
        if (!found.known.are_known)
            break;
        const auto number = static_cast<std::uint32_t>(n);
        if (kind == StepKind::vertex) {
            found.vertices.push_back(number);
            continue;
        }
        if (kind != StepKind::primitive) {
            if (is_loose(*kind, first != 1 || !found.primitives.empty()))
                found.loose.push_back(number);
            group.take(steps.step(n), *kind);
            continue;
        }
        found.primitives.push_back(number);
        const auto told = steps.step(n).as<PrimitiveStep>();
        if (group.takes(trace, n, told))
            continue;
        group.finish(found.known);
        group.begin(trace, n, told);
    }
    group.finish(found.known);
    return found;
}

/// Where the steps can be divided into parts of at least so many: before primitives that are no part of another one.
std::vector<std::size_t> ends_of_parts(const Trace& trace, std::size_t least) {
    std::vector<std::size_t> ends;
    const std::size_t last = trace.size();
    for (std::size_t n = least; (n = trace.next_of({StepKind::primitive}, n + 1, last)) <= last;)
        if (!trace.step(n).as<PrimitiveStep>().part.is_true()) {
            ends.push_back(n);
            n += least;
        }
    ends.push_back(trace.size() + 1);
    return ends;
}

} // namespace

TraceContents contents_of(const Trace& trace, std::size_t jobs, std::size_t steps_in_part) {
    const bool is_whole = !trace.is_partial && trace.end && trace.damage.empty() &&
                          trace.size() < std::numeric_limits<std::uint32_t>::max();
    if (!is_whole)
        return {};
    jobs = jobs_or_usual(jobs);
    const std::vector<std::size_t> ends = ends_of_parts(trace, steps_in_part);
    std::vector<TraceContents> parts(ends.size());
    std::vector<StepReader> readers;
    for (std::size_t i = 0; i < jobs; ++i)
        readers.emplace_back(trace);
    in_threads(ends.size(), jobs, [&](std::size_t i, std::size_t thread) {
        parts[i] = contents_of(trace, readers[thread], i == 0 ? 1 : ends[i - 1], ends[i]);
    });
    for (std::size_t i = 1; i < parts.size(); ++i)
        append(parts[0], parts[i]);
    return std::move(parts[0]);
}

} // namespace rastertrace
