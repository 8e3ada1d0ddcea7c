// SPDX-License-Identifier: MIT
// Points, lines and circles of the model.

#include "model/model_drawing.h"

#include <rastertrace/core/raster/circle.h>
#include <rastertrace/core/raster/line_bresenham.h>
#include <rastertrace/core/raster/line_sampling.h>
#include <rastertrace/core/raster/mixed_colors.h>

#include <algorithm>

namespace rastertrace {

/// A point, or the side of a piece that begins at a corner; false if it has no pixel.
bool ModelDrawing::draw_side(const ModelPiece& piece, std::uint16_t side) {
    const auto next = static_cast<std::uint16_t>((side + 1) % piece.corners.size());
    const Rational offset = offset_of(sample_of_lines(method_)).exact();
    const ModelVertex from = on_samples(piece.corners[side], offset);
    const ModelVertex to = on_samples(piece.corners[next], offset);
    if (depths_ && !is_filled(piece.kind)) {
        const auto all = scene_.primitives[piece.primitive].corners();
        const std::size_t first = piece.side + side;
        segment_ = {piece.primitive,
                    traits_of(piece.kind).thickness,
                    {all[first % all.size()], all[(first + 1) % all.size()]},
                    from,
                    to};
    }
    if (piece.kind == PrimitiveKind::point) {
        const Rational of_points = offset_of(sample_of_others(method_)).exact();
        plot(pixel_of(on_samples(piece.corners[side], of_points).at),
             [&] { return from.color.rounded(method_.color_rounding); });
        return true;
    }
    const auto [start, end] = directed(rules_, from, to);
    if (piece.kind != PrimitiveKind::line)
        sink_(EdgeSetUp<>{.edge = EdgeName{side, next},
                          .octant = octant_of(pixel_of(start.at), pixel_of(end.at))});
    return draw_line(start, end);
}

bool ModelDrawing::draw_line(const ModelVertex& from, const ModelVertex& to) {
    const LineColors colors = line_colors(from, to);
    const GridLine pixels{pixel_of(from.at), pixel_of(to.at),
                          from.color.rounded(method_.color_rounding),
                          to.color.rounded(method_.color_rounding), colors ? &colors : nullptr};
    if (method_.line == LineMethod::diamond_exit)
        return sample_diamonds(from, to, pixels);
    const ModelLine line = rules_.line(from.at, to.at);
    const Index last = line.steps - (method_.ends == EndPixels::both ? 0 : 1);
    if (method_.line == LineMethod::bresenham)
        walk(line, last, true, [&](Index step, GridPoint pixel) {
            plot(pixel, [&] { return rules_.color_of_step(pixels, pixel, step, line.steps); });
        });
    else
        sample(line, pixels, last);
    return last >= 0;
}

/// In space: by the place on the line, beyond an end that of the end. Else by steps, unless these lead
/// between levels that are not whole.
LineColors ModelDrawing::line_colors(const ModelVertex& from, const ModelVertex& to) const {
    const ColorLerp lerp = scene_.color_lerp();
    const auto is_whole = [this](const ModelVertex& end) {
        return Levels<Rational>(end.color.rounded(method_.color_rounding)).of == end.color.of;
    };
    if (from.color.of == to.color.of ||
        (lerp != ColorLerp::space && is_whole(from) && is_whole(to)))
        return {};
    const bool divides = lerp == ColorLerp::space && scene_.mixes_in_perspective();
    const MixedOnLine<Rational> mixed{
        {from.color, to.color},
        {divides ? from.inverse_w : Rational(1), divides ? to.inverse_w : Rational(1)},
        method_.color_rounding};
    const Rational dx = to.at.x - from.at.x;
    const Rational dy = to.at.y - from.at.y;
    const bool is_x_major = abs(dx) >= abs(dy);
    const Rational run = is_x_major ? dx : dy;
    return [=](GridPoint pixel, Index step, Index steps) {
        const Rational along =
            is_x_major ? Rational(pixel.x - from.at.x) : Rational(pixel.y - from.at.y);
        if (lerp == ColorLerp::space)
            return mixed.at(run == 0 ? Rational(0)
                                     : std::clamp<Rational>(along / run, Rational(0), Rational(1)));
        if (step == 0 || step == steps)
            return mixed.at(step == 0 ? 0 : 1);
        const GridLine pixels{pixel_of(from.at), pixel_of(to.at), {}, {}};
        return mixed.at(lerp == ColorLerp::axis ? Rational(Rational(step) / steps)
                                                : Rational(1 - share_by_distance(pixels, pixel)));
    };
}

/// Bresenham's line: straight on, or diagonally?
void ModelDrawing::walk(const ModelLine& line, Index last, bool is_told,
                        const std::function<void(Index step, GridPoint pixel)>& visit) {
    const bool steps_at_ties = line_rules(method_).ties == Ties::step;
    GridPoint at = line.start, pixel = at;
    Index d = line.d;
    for (Index i = 0; i <= last; ++i) {
        visit(i, pixel);
        const bool is_straight = d < 0 || (d == 0 && !steps_at_ties);
        const GridPoint step = is_straight ? line.straight : line.diagonal;
        const GridPoint kept = is_straight ? line.straight : line.kept;
        const GridPoint next{at.x + step.x, at.y + step.y};
        if (is_told && i < last && canvas_.contains(pixel.x, pixel.y) &&
            canvas_.contains(next.x, next.y))
            sink_(LineDecided<>{.x = static_cast<int>(pixel.x),
                                .y = static_cast<int>(pixel.y),
                                .d = d,
                                .move = move_of(step)});
        d += is_straight ? line.d_straight : line.d_diagonal;
        at = {at.x + kept.x, at.y + kept.y};
        pixel = next;
    }
    tell_rejected();
}

/// The steps of a line along its major axis, from `first`, that are drawn: where the canvas has the column or row. Others
/// may come back from as far off as it has pixels.
std::pair<Index, Index> ModelDrawing::steps_within_reach(bool is_x_major, Index first,
                                                         bool goes_back, Index last_step) const {
    const Index low =
        (is_x_major ? canvas_.left() : std::min(canvas_.top(), canvas_.bottom())) - reach();
    const Index high =
        (is_x_major ? canvas_.right() : std::max(canvas_.top(), canvas_.bottom())) + reach();
    const StepRange steps = steps_between(low, high, first, goes_back, last_step);
    return {steps.first, steps.last};
}

/// A naive or dda line: the coordinate across at each step along its major axis.
void ModelDrawing::sample(const ModelLine& line, const GridLine& pixels, Index last) {
    const Rational offset = offset_of(sample_of_lines(method_)).exact();
    const SpanRounding rounding = line_rounding(method_);
    const bool falls = line.is_x_major ? line.to.y < line.from.y : line.to.x < line.from.x;
    const bool goes_back = line.last < line.first;
    const auto [from, to] = steps_within_reach(line.is_x_major, line.first, goes_back, last);
    for (Index i = from; i <= to; ++i) {
        const Index along = goes_back ? line.first - i : line.first + i;
        const Rational across = rules_.across(line, along);
        const Index rounded = pixel_across(across, rounding, falls);
        if (canvas_.contains(line.is_x_major ? along : canvas_.left(),
                             line.is_x_major ? canvas_.top() : along))
            sink_(line_sampled(line.is_x_major, along, Rational(across + offset), rounded));
        const GridPoint at =
            line.is_x_major ? GridPoint{along, rounded} : GridPoint{rounded, along};
        plot(at, [&] { return rules_.color_of_step(pixels, at, i, line.steps); });
    }
}

/// The pixels whose diamonds the line leaves, |x - i| + |y - j| < 1/2, when both its ends have been moved by (-e, -e e)
/// for a small e, y up in the picture.
bool ModelDrawing::sample_diamonds(const ModelVertex& from, const ModelVertex& to,
                                   const GridLine& pixels) {
    const int up = -down_;
    const ModelLine line = rules_.line({from.at.x, from.at.y * up}, {to.at.x, to.at.y * up});
    const auto along_of = [&line](const ModelRules::Point2& p) {
        return line.is_x_major ? p.x : p.y;
    };
    const bool goes_back = along_of(line.to) < along_of(line.from);
    const bool rises = line.is_x_major && line.slope > 0;
    const auto pixel_at = [&](Index along) {
        return nearest_index(rules_.across(line, along), rises ? Ties::up : Ties::start);
    };
    const auto is_in_diamond = [&](const ModelRules::Point2& p, Index along) {
        const Index across = pixel_at(along);
        const Rational u = p.x - (line.is_x_major ? along : across);
        const Rational v = p.y - (line.is_x_major ? across : along);
        const Rational twice = 2 * (abs(u) + abs(v));
        return twice < 1 || (twice == 1 && u > 0);
    };
    // An end on a column of samples has moved to its lower side.
    const Index back = goes_back ? 1 : -1;
    Index first = ceil_index(along_of(line.from)) - (goes_back ? 1 : 0);
    Index last = ceil_index(along_of(line.to)) - (goes_back ? 0 : 1);
    first += is_in_diamond(line.from, first + back) ? back : 0;
    last += is_in_diamond(line.to, last) ? back : 0;

    const Rational offset = offset_of(sample_of_lines(method_)).exact();
    const Index steps = (last - first) * -back + 1;
    const auto [begin, end] =
        steps_within_reach(line.is_x_major, line.is_x_major ? first : first * up,
                           (goes_back ? -1 : 1) * (line.is_x_major ? 1 : up) < 0, steps - 1);
    for (Index i = begin; i <= end; ++i) {
        const Index along = first - i * back;
        const Index across = pixel_at(along);
        const GridPoint at =
            line.is_x_major ? GridPoint{along, across * up} : GridPoint{across, along * up};
        const Rational told = rules_.across(line, along) * (line.is_x_major ? up : 1) + offset;
        if (canvas_.contains(line.is_x_major ? at.x : canvas_.left(),
                             line.is_x_major ? canvas_.top() : at.y))
            sink_(line.is_x_major ? line_sampled(true, at.x, told, at.y)
                                  : line_sampled(false, at.y, told, at.x));
        plot(at, [&] { return rules_.color_of_step(pixels, at, i, steps); });
    }
    return steps > 0;
}

/// The octant from (0, r) to the diagonal, and its mirror images: to the east while the midpoint of the next two
/// pixels lies inside of the circle, else to the south-east.
void ModelDrawing::draw_circle(const ModelVertex& center, Index r) {
    const GridPoint middle =
        pixel_of(on_samples(center, offset_of(sample_of_others(method_)).exact()).at);
    if (!meets({middle, r}, canvas_))
        return sink_(PrimitiveSkipped<>{.why = SkipReason::off_canvas});
    const auto plot_image = [&](GridPoint p) {
        plot({middle.x + p.x, middle.y + p.y},
             [&] { return center.color.rounded(method_.color_rounding); });
        tell_rejected();
    };
    for (GridPoint at{0, r}; at.x <= at.y;) {
        for_each_mirror_image(at, plot_image);
        if (at.x == at.y)
            return;
        const Index d = (at.x + 1) * (at.x + 1) + at.y * at.y - at.y - r * r;
        const bool goes_east = d < 0;
        sink_(LineDecided<>{.x = static_cast<int>(middle.x + at.x),
                            .y = static_cast<int>(middle.y + at.y),
                            .d = d,
                            .move = goes_east ? Move::e : Move::se});
        at = {at.x + 1, goes_east ? at.y : at.y - 1};
    }
}

} // namespace rastertrace
