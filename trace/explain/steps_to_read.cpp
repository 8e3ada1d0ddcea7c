// SPDX-License-Identifier: MIT
#include "steps_to_read.h"

#include "explanation.h"
#include "why_not.h"

#include <rastertrace/trace/record/told_samples.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/formula.h>
#include <rastertrace/trace/tell/sheet.h>
#include <rastertrace/trace/tell/step_text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Numbers of this size were worked with in doubles.
double rounded_by(double size) {
    constexpr double share = 0x1p-21;
    return share * size + 1e-9;
}

/// A pixel and its sample.
struct PixelPlace {
    Pixel pixel;
    double x;
    double y;
};

/// A point in doubles.
struct Place {
    double x;
    double y;
};

/// How far away a primitive is, at least and at most.
struct Reach {
    double least = -infinity; ///< not above 0: only its steps tell; infinite: it has no distance
    double most = infinity;
};

/// How far outside of an interval a place lies.
Reach beyond(double place, double low, double high) {
    const double distance = std::max(low - place, place - high);
    const double error = rounded_by(std::abs(place) + std::abs(low) + std::abs(high));
    return {distance - error, distance + error};
}

/// A primitive, or a part of one, as the question about a pixel needs it.
struct Unit {
    std::size_t first = 0; ///< its `primitive` step
    bool is_part = false;  ///< of the last one that is none
    std::string_view reason =
        "outside"; ///< that keeps it from the pixel, if none of its steps is about that
    Reach reach{};
};

/// Collects what its steps tell of one primitive, or part.
class UnitSteps {
public:
    UnitSteps(const Trace& trace, const PixelPlace& at, std::size_t first,
              const PrimitiveStep& told, bool is_part)
        : trace_(trace), at_(at), told_(told), unit_{.first = first, .is_part = is_part} {}

    bool is_whole = false; ///< see PrimitiveSteps
    bool has_clips = false;
    std::string skip{};

    void take(const StepView& step, StepKind kind) {
        switch (kind) {
        case StepKind::sample:
            has_samples_ = true;
            [[fallthrough]];
        case StepKind::pixel:
        case StepKind::depth:
            is_about_pixel_ |= x_in(step) == at_.pixel.x && y_in(step) == at_.pixel.y;
            return;
        case StepKind::reject:
            is_about_pixel_ |= covers(step, at_.pixel);
            return;
        case StepKind::scanline:
            return take(step.as<ScanlineStep>());
        case StepKind::edge:
            return take(step.as<EdgeStep>());
        default:
            return;
        }
    }

    /// What is known at the end.
    Unit finish() {
        set_reason_and_reach();
        if (is_about_pixel_)
            unit_.reach = {};
        return unit_;
    }

private:
    void set_reason_and_reach() {
        if (!skip.empty())
            return set_reason(reason_of_skip(skip));
        if (is_whole || (!told_.at && has_clips))
            return set_reason("clipped");
        if (!is_filled(told_.kind))
            return;
        if (told_.painted.is_false())
            return set_reason("unpainted");
        const auto corners = corners_in_doubles();
        if (told_.kind != PrimitiveKind::triangle || !corners || is_odd_)
            return;
        const auto [left, right] = std::minmax({(*corners)[0].x, (*corners)[1].x, (*corners)[2].x});
        const auto [low, high] = std::minmax({(*corners)[0].y, (*corners)[1].y, (*corners)[2].y});
        if (functions_ != 0) {
            if (functions_ == 3)
                unit_.reach = beyond_edges_;
        } else if (has_rows_) {
            unit_.reach = beyond_rows(low, high);
        } else if (trace_.method_value("fill") == "barycentric") {
            const Reach in_x = beyond(at_.x, left, right);
            const Reach in_y = beyond(at_.y, low, high);
            unit_.reach = {std::max(in_x.least, in_y.least), std::max(in_x.most, in_y.most)};
        } else if (!has_samples_) {
            set_reason(has_fan_ || trace_.method_value("fill") == "fan" ? "outside" : "unknown");
        }
    }

    /// The same reason for all pixels, without a distance.
    void set_reason(std::string_view reason) {
        unit_.reason = reason;
        unit_.reach = {.least = infinity};
    }

    /// Where the three corners are; `nullopt` if not each of them has a place.
    std::optional<std::array<Place, 3>> corners_in_doubles() const {
        constexpr double farthest = 1e38; // products of larger ones may be infinite
        const auto places = told_.at.values();
        if (places.size() != 3 || told_.vertices.values().size() != 3)
            return std::nullopt;
        std::array<Place, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto place = places[i].values();
            const auto x = place.size() < 2 ? std::nullopt : place[0].nearest_double();
            const auto y = place.size() < 2 ? std::nullopt : place[1].nearest_double();
            if (!x || !y || std::max(std::abs(*x), std::abs(*y)) > farthest)
                return std::nullopt;
            corners[i] = {*x, *y};
        }
        return corners;
    }

    /// `low` and `high`: least and largest y of the corners.
    Reach beyond_rows(double low, double high) const {
        const auto& [x, y] = std::pair<double, double>(at_.pixel.x, at_.pixel.y);
        if (y < low_row_ || high_row_ < y)
            return beyond(at_.y, low, high);
        constexpr double from_end = 4; // from the end of a row to its last pixel, and its sample
        return {std::max(from_ - x, x - to_) - from_end,
                std::max(std::abs(x - from_), std::abs(x - to_)) + from_end};
    }

    void take(const ScanlineStep& row) {
        const auto is_near = [](const TracedNumber& end, Index pixel) {
            const auto x = end.nearest_double();
            return x && std::abs(*x - static_cast<double>(pixel)) <= 2;
        };
        if (!is_near(row.left, row.from) || !is_near(row.right, row.to))
            is_odd_ = true;
        // They come from one end to the other, none left out.
        const auto y = static_cast<double>(row.y);
        if (has_rows_ && y != low_row_ - 1 && y != high_row_ + 1)
            is_odd_ = true;
        low_row_ = std::min(low_row_, y);
        high_row_ = std::max(high_row_, y);
        from_ = std::min(from_, static_cast<double>(row.from));
        to_ = std::max(to_, static_cast<double>(row.to));
        has_rows_ = true;
    }

    void take(const EdgeStep& edge) {
        has_fan_ = has_edges_ ? has_fan_ : edge.octant.has_value();
        has_edges_ = true;
        if (!edge.a)
            return;
        if (!primitive_)
            primitive_ = primitive_in(told_);
        const auto function = edge_function_in(trace_, edge, *primitive_);
        const double length =
            function ? std::hypot(nearest_double(function->a), nearest_double(function->b)) : 0;
        if (functions_ == 3 || !std::isnormal(length)) {
            is_odd_ = true;
            return;
        }
        ++functions_;
        const double along_x = nearest_double(function->a) / length * at_.x;
        const double along_y = nearest_double(function->b) / length * at_.y;
        const double at_zero =
            nearest_double(function->a * function->from.x + function->b * function->from.y) /
            length;
        const double distance = at_zero - along_x - along_y;
        const double error = rounded_by(std::abs(along_x) + std::abs(along_y) + std::abs(at_zero));
        beyond_edges_.least = std::max(beyond_edges_.least, distance - error);
        beyond_edges_.most = std::max(beyond_edges_.most, distance + error);
    }

    const Trace& trace_;
    const PixelPlace& at_;
    PrimitiveStep told_;
    Unit unit_;
    std::optional<PrimitiveText> primitive_;
    std::size_t functions_ = 0; ///< edge functions
    Reach beyond_edges_{.most = -infinity};
    bool is_about_pixel_ = false; ///< one of its steps
    bool has_rows_ = false;
    bool has_samples_ = false;
    bool has_edges_ = false;
    bool has_fan_ = false;
    bool is_odd_ = false; ///< what no fill of ours tells
    double low_row_ = infinity;
    double high_row_ = -infinity;
    double from_ = infinity;
    double to_ = -infinity;
};

/// What going through a trace gives.
struct TraceContents {
    std::vector<Unit> units{};
    std::map<std::string, std::size_t> others{}; ///< primitives without a distance, by their reason
    std::vector<std::size_t> primitives{};       ///< steps
    std::vector<std::size_t>
        loose{}; ///< steps that belong to no primitive: those about the whole scene
    std::vector<std::size_t> vertices{}; ///< `vertex` steps, which are found by name
};

/// A primitive and the parts that clipping has made of it.
class Group {
public:
    Group(const Trace& trace, const PixelPlace& at) : trace_(trace), at_(at) {}

    void begin(std::size_t n, const PrimitiveStep& told) {
        name_ = told.name.text();
        units_.clear();
        units_.emplace_back(trace_, at_, n, told, false);
    }

    /// The next primitive of the trace, if it is a part.
    bool takes(std::size_t n, const PrimitiveStep& told) {
        if (units_.empty() || !is_part_of(told, name_))
            return false;
        units_.front().is_whole = true;
        units_.emplace_back(trace_, at_, n, told, true);
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

    void finish(TraceContents& contents) {
        for (UnitSteps& steps : units_) {
            const Unit unit = steps.finish();
            if (units_.size() == 1 && unit.reach.least == infinity)
                ++contents.others[std::string(unit.reason)];
            else
                contents.units.push_back(unit);
        }
        units_.clear();
    }

private:
    const Trace& trace_;
    const PixelPlace& at_;
    std::string name_;
    std::vector<UnitSteps> units_;
};

/// `nullopt` for a trace that lacks steps, or has some that are not written as StepWriter writes them: lines of another
/// program may lack what the rules above rely on.
std::optional<TraceContents> contents_of(const Trace& trace, const PixelPlace& at) {
    if (trace.is_partial || !trace.end || !trace.damage.empty())
        return std::nullopt;
    TraceContents found;
    Group group(trace, at);
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const auto kind = trace.kind_of(n);
        if (!kind || !trace.is_plain(n))
            return std::nullopt;
        if (kind == StepKind::vertex) {
            found.vertices.push_back(n);
            continue;
        }
        if (kind != StepKind::primitive) {
            if (found.primitives.empty() || kind == StepKind::matrix || kind == StepKind::order)
                found.loose.push_back(n);
            group.take(trace.step(n), *kind);
            continue;
        }
        found.primitives.push_back(n);
        const auto told = trace.step(n).as<PrimitiveStep>();
        if (group.takes(n, told))
            continue;
        group.finish(found);
        group.begin(n, told);
    }
    group.finish(found);
    return found;
}

} // namespace

std::optional<StepsToRead> steps_to_read(const Trace& trace, Pixel pixel, std::size_t nearest) {
    const auto& offset = told_samples(trace).triangles;
    const auto contents = contents_of(trace, {.pixel = pixel,
                                              .x = nearest_double(offset.x_of(pixel.x)),
                                              .y = nearest_double(offset.y_of(pixel.y))});
    if (!contents)
        return std::nullopt;

    // No one that is farther away than this is among the nearest.
    const auto& units = contents->units;
    std::vector<double> most;
    for (const Unit& unit : units)
        if (unit.reach.least > 0 && unit.reach.least < infinity)
            most.push_back(unit.reach.most);
    if (most.size() <= nearest)
        return std::nullopt;
    const auto last = most.begin() + static_cast<std::ptrdiff_t>(nearest) - 1;
    std::nth_element(most.begin(), last, most.end());
    const double far = *last;

    // The steps of the near ones, with their parts; of the others, the reasons.
    StepsToRead chosen{.steps = contents->loose, .others = contents->others};
    auto& steps = chosen.steps;
    const auto& primitives = contents->primitives;
    std::set<std::string> vertices;
    for (auto unit = units.begin(); unit != units.end();) {
        const auto end =
            std::find_if(unit + 1, units.end(), [](const Unit& one) { return !one.is_part; });
        const bool is_near =
            std::any_of(unit, end, [far](const Unit& one) { return one.reach.least <= far; });
        const auto next = std::upper_bound(primitives.begin(), primitives.end(), (end - 1)->first);
        const std::size_t behind = next == primitives.end() ? trace.size() + 1 : *next;
        for (std::size_t n = unit->first; is_near && n < behind; ++n) {
            steps.push_back(n);
            if (trace.kind_of(n) == StepKind::primitive)
                for (std::string& name : trace.step(n).as<PrimitiveStep>().vertices.texts())
                    vertices.insert(std::move(name));
        }
        for (; unit != end; ++unit)
            if (!is_near)
                ++chosen.others[std::string(unit->reason)];
    }
    for (const std::size_t n : contents->vertices)
        if (vertices.contains(name_in(trace.step(n)).text()))
            steps.push_back(n);
    std::sort(steps.begin(), steps.end());
    steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
    return chosen;
}

} // namespace rastertrace
