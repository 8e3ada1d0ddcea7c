// SPDX-License-Identifier: MIT
#include "depth_plot.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/corners.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/tell/told_samples.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

namespace rastertrace {

namespace {

/// A depth somewhere along the row or the side.
struct Sample {
    double along;
    double z;
};

/// Depths of one line of a picture.
struct Depths {
    std::string along; ///< "x in the row y=2", "y along the side AC"
    std::vector<Sample> drawn;
    std::array<Sample, 2> ends{};               ///< of the face in the row, or of the side as drawn
    std::string truth;                          ///< what the true depths are called
    std::function<double(double along)> true_z; ///< empty if nothing tells them
    double from = 0;                            ///< where the face begins
    double to = 0;                              ///< where it ends
};

/// True if nothing gets smaller far away: z itself is linear on the screen.
bool is_parallel(const Replay& replay) {
    for (const std::size_t n : replay.matrices()) {
        const auto matrix = replay.trace().step(n).as<MatrixStep>();
        if (matrix.name != "projection")
            continue;
        const auto rows = matrix.rows.values();
        const auto last = rows.size() == 4 ? rows[3].values() : std::vector<TracedNumber>();
        return last.size() == 4 && last[2].nearest_double() == 0.0;
    }
    return false;
}

/// The depths of the pixels of the row at their samples, as they were tested.
std::vector<Sample> along_row(const Trace& trace, ShownSteps steps, double offset) {
    std::vector<Sample> samples;
    for (const std::size_t n : trace.steps_of({StepKind::depth}, steps.first, steps.last)) {
        const auto test = trace.step(n).as<DepthStep>();
        if (const auto depth = test.depth.nearest_double())
            samples.push_back({static_cast<double>(test.x) + offset, *depth});
    }
    return samples;
}

/// The side of the current triangle along which depths change most, and its depth in each row.
struct Side {
    std::string edge;
    bool is_left = false;
    std::vector<Sample> samples;
    std::vector<double> x; ///< where it is in each of these rows
};
Side along_side(const Replay& replay, double offset) {
    const Trace& trace = replay.trace();
    std::vector<Side> sides;
    for (const std::size_t n :
         trace.steps_of({StepKind::scanline}, replay.primitive() + 1, replay.step())) {
        const auto row = trace.step(n).as<ScanlineStep>();
        for (const bool is_left : {false, true}) {
            const auto depth = (is_left ? row.left_depth : row.right_depth).nearest_double();
            const auto x = (is_left ? row.left : row.right).nearest_double();
            if (!depth || !x)
                continue;
            const std::string edge = (is_left ? row.left_edge : row.right_edge).text();
            auto side = std::find_if(sides.begin(), sides.end(), [&](const Side& one) {
                return one.is_left == is_left && one.edge == edge;
            });
            if (side == sides.end())
                side = sides.insert(sides.end(), {edge, is_left, {}, {}});
            side->samples.push_back({static_cast<double>(row.y) + offset, *depth});
            side->x.push_back(*x);
        }
    }
    const auto change_of = [](const Side& side) {
        const auto [least, most] =
            std::minmax_element(side.samples.begin(), side.samples.end(),
                                [](const Sample& a, const Sample& b) { return a.z < b.z; });
        return most->z - least->z;
    };
    const auto most =
        std::max_element(sides.begin(), sides.end(),
                         [&](const Side& a, const Side& b) { return change_of(a) < change_of(b); });
    return most == sides.end() ? Side() : *most;
}

std::optional<Depths> depths_of(const Panel& panel) {
    const Replay& replay = panel.replay;
    const Trace& trace = panel.trace();
    const auto kind = trace.method.triangles.depth;
    const bool is_inverse = kind == Depth::inverse_z;
    if (replay.primitive() == 0 || (!is_inverse && kind != Depth::linear_z))
        return std::nullopt;

    // What was drawn, as z.
    const auto z_of = [is_inverse](double depth) { return is_inverse ? 1 / depth : depth; };
    Depths depths;
    const std::size_t scanline = panel.subject.row;
    const bool is_row =
        panel.is_step() && scanline != 0 && trace.kind_of(scanline) == StepKind::scanline;
    const SampleOffset<Rational> offset = told_samples(trace).triangles;
    const double offset_x = nearest_double(offset.x());
    const double offset_y = nearest_double(offset.y());
    double row = 0;                                // its y
    std::optional<std::array<Sample, 2>> row_ends; // of the face in it
    Side side;
    if (is_row) {
        const auto told = trace.step(scanline).as<ScanlineStep>();
        row = static_cast<double>(told.y) + offset_y;
        const auto left = told.left.nearest_double(), right = told.right.nearest_double();
        const auto left_depth = told.left_depth.nearest_double();
        const auto right_depth = told.right_depth.nearest_double();
        if (left && right && left_depth && right_depth)
            row_ends = {{{*left, z_of(*left_depth)}, {*right, z_of(*right_depth)}}};
        depths.along = said("x in the row y = {}", told.y);
        depths.drawn = along_row(trace, {scanline, end_of(trace, scanline)}, offset_x);
    } else {
        side = along_side(replay, offset_y);
        depths.along = said("y along the side {}", side.edge);
        depths.drawn = side.samples;
    }
    for (Sample& sample : depths.drawn)
        sample.z = z_of(sample.z);
    std::erase_if(depths.drawn, [](const Sample& sample) { return !std::isfinite(sample.z); });
    if (depths.drawn.size() < 2)
        return std::nullopt;
    std::sort(depths.drawn.begin(), depths.drawn.end(),
              [](const Sample& a, const Sample& b) { return a.along < b.along; });
    depths.ends = row_ends.value_or(std::array{depths.drawn.front(), depths.drawn.back()});
    depths.from = std::max(depths.drawn.front().along, depths.ends[0].along);
    depths.to = std::min(depths.drawn.back().along, depths.ends[1].along);

    // The truth, from the triangle's corners.
    const auto primitive = trace.step(replay.primitive()).as<PrimitiveStep>();
    const Path at = corners_of(primitive);
    const auto corner_depths = primitive.depths.values();
    if (at.size() != 3 || corner_depths.size() != 3)
        return depths;
    const bool is_linear = is_parallel(replay); // z is; otherwise 1/z
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double depth = corner_depths[i].nearest_double().value_or(0);
        values[i] = is_inverse == is_linear ? 1 / depth : depth;
    }
    const auto plane = plane_through(at, values);
    if (!plane || !std::isfinite((*plane)[0] + (*plane)[1] + (*plane)[2]))
        return depths;
    depths.truth = trace.projection.empty() ? said("true in a perspective") : said("true");
    const auto true_at = [plane = *plane, is_linear](double x, double y) {
        const double value = plane[0] * x + plane[1] * y + plane[2];
        return is_linear ? value : 1 / value;
    };
    if (is_row) {
        depths.true_z = [true_at, row](double x) { return true_at(x, row); };
    } else {
        // Between two rows the side is straight.
        depths.true_z = [true_at, side](double y) {
            for (std::size_t i = 0; i + 1 < side.samples.size(); ++i) {
                const double from = side.samples[i].along;
                const double to = side.samples[i + 1].along;
                if ((y - from) * (y - to) <= 0 && from != to)
                    return true_at(
                        side.x[i] + (y - from) / (to - from) * (side.x[i + 1] - side.x[i]), y);
            }
            return std::nan("");
        };
    }
    return depths;
}

/// What has a place in a plot: 1/z of z = 0 has none.
void add_finite(const std::vector<Sample>& samples, double (*value)(double z),
                std::vector<PlotMark>& marks) {
    for (const Sample& sample : samples)
        if (const double y = value(sample.z); std::isfinite(y))
            marks.push_back({.x = sample.along, .y = y});
}

/// The truth, the straight line between the ends, and what is drawn; of z, or of 1/z.
Plot plot_of(const Depths& depths, std::string_view name, double (*value)(double z)) {
    Plot plot{.width = 330,
              .area_height = 190,
              .x = {.scale = PlotScale::linear, .label = depths.along},
              .y = {.scale = PlotScale::linear, .label = std::string(name)}};
    PlotCurve drawn{.name = said("as drawn"), .marks = {}, .has_line = false};
    add_finite(depths.drawn, value, drawn.marks);
    PlotCurve straight{.name = said("straight between the ends"), .marks = {}, .has_marks = false};
    const auto& [first, last] = depths.ends;
    const double slope = (value(last.z) - value(first.z)) / (last.along - first.along);
    for (const double along : {depths.from, depths.to})
        if (const double y = value(first.z) + slope * (along - first.along); std::isfinite(y))
            straight.marks.push_back({.x = along, .y = y});
    PlotCurve truth{.name = depths.truth, .marks = {}, .has_marks = false};
    if (depths.true_z) {
        constexpr int pieces = 60;
        std::vector<Sample> on_curve;
        for (int i = 0; i <= pieces; ++i) {
            const double along = depths.from + (depths.to - depths.from) * i / pieces;
            on_curve.push_back({.along = along, .z = depths.true_z(along)});
        }
        add_finite(on_curve, value, truth.marks);
    }
    plot.curves = {std::move(truth), std::move(straight), std::move(drawn)};
    return plot;
}

} // namespace

std::vector<Plot> depth_plots(const Panel& panel) {
    const auto depths = depths_of(panel);
    if (!depths)
        return {};
    std::vector<Plot> plots{plot_of(*depths, "z", [](double z) { return z; }),
                            plot_of(*depths, "1/z", [](double z) { return 1 / z; })};
    std::erase_if(plots, [](const Plot& plot) { return plot.curves.back().marks.size() < 2; });
    return plots;
}

} // namespace rastertrace
