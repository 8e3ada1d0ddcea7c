// SPDX-License-Identifier: MIT
#include "pixel_units.h"

#include "explanation.h"
#include "why_not.h"

#include <rastertrace/trace/record/told_samples.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/formula.h>
#include <rastertrace/trace/tell/sheet.h>
#include <rastertrace/trace/tell/step_text.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

constexpr std::array<std::string_view, far_reasons> reason_names{"outside", "unpainted", "culled",
                                                                 "clipped", "skipped",   "unknown"};

FarReason far_reason_named(std::string_view name) {
    const auto found = std::find(reason_names.begin(), reason_names.end(), name);
    return static_cast<FarReason>(found - reason_names.begin());
}

/// Whole numbers that a float holds.
constexpr Index most_in_float = 1 << 24;

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
        const auto corners = corners_of(primitive());
        if (told_.kind != PrimitiveKind::triangle || !corners || is_odd_)
            return unit_;
        const auto [left, right] = std::minmax({(*corners)[0].x, (*corners)[1].x, (*corners)[2].x});
        const auto [low, high] = std::minmax({(*corners)[0].y, (*corners)[1].y, (*corners)[2].y});
        const bool is_barycentric = trace_.method_value("fill") == "barycentric";
        if (functions_ != 0) {
            unit_.rule = functions_ == 3 ? UnitRule::edges : UnitRule::ask;
        } else if (has_rows_) {
            for (const Index value : {low_row_, high_row_, from_, to_})
                if (std::abs(value) > most_in_float)
                    return unit_;
            unit_.rule = UnitRule::rows;
            unit_.values = {float(low_row_), float(high_row_), float(from_),
                            float(to_),      in_float(low),    in_float(high)};
        } else if (is_barycentric) {
            unit_.rule = UnitRule::box;
            unit_.values = {in_float(left), in_float(right), in_float(low), in_float(high)};
        } else if (!has_samples_) {
            return nothing(has_fan_ || trace_.method_value("fill") == "fan" ? FarReason::outside
                                                                            : FarReason::unknown);
        }
        return unit_;
    }

private:
    static float in_float(const Rational& number) {
        return static_cast<float>(nearest_double(number));
    }

    PixelUnit nothing(FarReason reason) {
        unit_.rule = UnitRule::nothing;
        unit_.reason = reason;
        return unit_;
    }

    const PrimitiveText& primitive() {
        if (!primitive_)
            primitive_ = primitive_in(trace_.step(unit_.first));
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

constexpr double infinity = std::numeric_limits<double>::infinity();

/// How far away a unit is, at least and at most.
struct Reach {
    double least = -infinity; ///< not above 0: only its steps tell; infinite: it has no distance
    double most = infinity;
};

/// A pixel, in the units' numbers.
struct PixelPlace {
    Pixel pixel;
    int column;
    int row;
    double x; ///< its sample
    double y;
};

/// Numbers of this size were rounded to floats, and worked with.
double rounded_by(double size) {
    constexpr double share = 0x1p-21;
    return share * size + 1e-9;
}

Reach reach_of(const PixelUnit& unit, const PixelPlace& at) {
    const auto& v = unit.values;
    const auto lies_in = [](const std::array<std::int16_t, 2>& range, int place) {
        return range[0] <= place && place <= range[1];
    };
    if (unit.rule == UnitRule::ask ||
        (lies_in(unit.columns, at.column) && lies_in(unit.rows, at.row)))
        return {};
    const auto beyond = [](double place, double low, double high) {
        const double distance = std::max(low - place, place - high);
        const double error = rounded_by(std::abs(place) + std::abs(low) + std::abs(high));
        return Reach{distance - error, distance + error};
    };
    switch (unit.rule) {
    case UnitRule::nothing:
        return {.least = infinity};
    case UnitRule::edges: {
        Reach reach{.most = -infinity};
        for (std::size_t i = 0; i < v.size(); i += 3) {
            const double along_x = double{v[i]} * at.x;
            const double along_y = double{v[i + 1]} * at.y;
            const double distance = -(along_x + along_y + double{v[i + 2]});
            const double error =
                rounded_by(std::abs(along_x) + std::abs(along_y) + std::abs(double{v[i + 2]}));
            reach.least = std::max(reach.least, distance - error);
            reach.most = std::max(reach.most, distance + error);
        }
        return reach;
    }
    case UnitRule::rows: {
        const double y = at.pixel.y;
        const double x = at.pixel.x;
        if (y < double{v[0]} || double{v[1]} < y)
            return beyond(at.y, double{v[4]}, double{v[5]});
        constexpr double from_end = 4; // from the end of a row to its last pixel, and its sample
        return {std::max(double{v[2]} - x, x - double{v[3]}) - from_end,
                std::max(std::abs(x - double{v[2]}), std::abs(x - double{v[3]})) + from_end};
    }
    default: {
        const Reach in_x = beyond(at.x, double{v[0]}, double{v[1]});
        const Reach in_y = beyond(at.y, double{v[2]}, double{v[3]});
        return {std::max(in_x.least, in_y.least), std::max(in_x.most, in_y.most)};
    }
    }
}

} // namespace

PixelUnits pixel_units_of(const Trace& trace) {
    PixelUnits known{.are_known = !trace.is_partial && trace.end && trace.damage.empty()};
    if (!known.are_known)
        return known;
    Group group;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const auto kind = trace.kind_of(n);
        if (!kind)
            continue;
        const StepView step = trace.step(n);
        if (kind != StepKind::primitive) {
            group.take(step, *kind);
            continue;
        }
        const auto told = step.as<PrimitiveStep>();
        if (group.takes(trace, n, told))
            continue;
        group.finish(known);
        group.begin(trace, n, told);
    }
    group.finish(known);
    return known;
}

std::optional<StepsToRead> steps_to_read(const Trace& trace, Pixel pixel, std::size_t nearest) {
    const TraceIndex* const index = trace.index();
    if (index == nullptr || !index->knows_units())
        return std::nullopt;
    const auto& offset = told_samples(trace).triangles;
    const PixelPlace at{.pixel = pixel,
                        .column = pixel.x - trace.canvas.left(),
                        .row = static_cast<int>(trace.canvas.row_of(pixel.y)),
                        .x = nearest_double(offset.x_of(pixel.x)),
                        .y = nearest_double(offset.y_of(pixel.y))};
    const auto units = index->units();
    std::vector<double> least;
    std::vector<double> most;
    least.reserve(units.size());
    most.reserve(units.size());
    for (const PixelUnit& unit : units) {
        const Reach reach = reach_of(unit, at);
        least.push_back(reach.least);
        if (reach.least > 0 && reach.least < infinity)
            most.push_back(reach.most);
    }
    if (most.size() <= nearest)
        return std::nullopt;
    // No other one is among the nearest.
    std::nth_element(most.begin(), most.begin() + static_cast<std::ptrdiff_t>(nearest) - 1,
                     most.end());
    const double far = most[nearest - 1];

    StepsToRead chosen;
    std::array<std::uint64_t, far_reasons> others = index->other_units();
    auto& steps = chosen.steps;
    const auto loose = index->loose_steps();
    steps.assign(loose.begin(), loose.end());
    std::set<std::string> vertices;
    const auto primitives = index->primitives();
    for (std::size_t i = 0, end = 0; i < units.size(); i = end) {
        end = i + 1;
        while (end < units.size() && units[end].is_part)
            ++end;
        const bool is_near = std::any_of(least.begin() + static_cast<std::ptrdiff_t>(i),
                                         least.begin() + static_cast<std::ptrdiff_t>(end),
                                         [far](double distance) { return distance <= far; });
        if (!is_near) {
            for (std::size_t unit = i; unit < end; ++unit)
                ++others[static_cast<std::size_t>(units[unit].reason)];
            continue;
        }
        const auto next =
            std::upper_bound(primitives.begin(), primitives.end(), units[end - 1].first);
        const std::size_t behind = next == primitives.end() ? trace.size() + 1 : *next;
        for (std::size_t n = units[i].first; n < behind; ++n) {
            steps.push_back(n);
            if (trace.kind_of(n) == StepKind::primitive)
                for (std::string& name : trace.step(n).as<PrimitiveStep>().vertices.texts())
                    vertices.insert(std::move(name));
        }
    }
    for (const std::string& name : vertices) {
        const auto of_vertex = index->vertex_steps(name);
        steps.insert(steps.end(), of_vertex.begin(), of_vertex.end());
    }
    std::sort(steps.begin(), steps.end());
    steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
    for (std::size_t reason = 0; reason < far_reasons; ++reason)
        if (others[reason] != 0)
            chosen.others[std::string(reason_names[reason])] = others[reason];
    return chosen;
}

} // namespace rastertrace
