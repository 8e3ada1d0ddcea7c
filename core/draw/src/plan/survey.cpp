// SPDX-License-Identifier: MIT
#include "plan/survey.h"

#include "plan/unfit.h"

#include <array>
#include <cmath>
#include <concepts>
#include <limits>

namespace rastertrace {

namespace {

/// How far calculated positions may lie from exact ones, for coordinates up to `farthest`: the
/// numbers drawn with are rounded, and adding up a slope adds up its error.
double slack_of(const Method& method, double farthest) {
    const double unit =
        farthest * (method.scalar == ScalarKind::single_precision ? 0x1p-20 : 0x1p-49);
    return method.lerp == LerpForm::incremental ? unit * largest_canvas_side : unit;
}

/// Whole numbers below and above everything that is calculated from a coordinate.
struct WholeBounds {
    Index low;
    Index high;
};

template <typename Coordinate>
WholeBounds whole_bounds(const Coordinate& coordinate, const Method& method, double slack) {
    constexpr bool is_exact =
        std::same_as<Coordinate, Number> || std::same_as<Coordinate, Rational>;
    if constexpr (is_exact)
        if (decides_exactly(method)) {
            // Whole numbers are doubles up to 2^53, so that rounding does not cross one.
            const double near = to_double(coordinate);
            if (const Index below = floor_index(near); static_cast<double>(below) != near)
                return {below, below + 1};
            const Rational exact = scalar_from<Rational>(coordinate, 1);
            return {floor_index(exact), ceil_index(exact)};
        }
    if constexpr (is_exact || std::floating_point<Coordinate>)
        if (method.scalar == ScalarKind::fixed)
            if (const auto numerator = nearest_numerator(coordinate, fixed_grid))
                return {floor_quotient(*numerator, fixed_grid),
                        -floor_quotient(-*numerator, fixed_grid)};
    const double x = to_double(coordinate);
    const double off = slack + error_of(coordinate);
    return {floor_index(x - off), ceil_index(x + off)};
}

/// The bounds of the coordinates `coordinate(corner)` of all corners.
template <typename Coordinate, typename CoordinateOf>
WholeBounds whole_bounds(std::span<const Vec<Coordinate, 2>> corners, CoordinateOf&& coordinate,
                         const Method& method, double slack) {
    if constexpr (std::floating_point<Coordinate>) {
        const auto [low, high] =
            std::minmax_element(corners.begin(), corners.end(), [&](const auto& a, const auto& b) {
                return coordinate(a) < coordinate(b);
            });
        return {whole_bounds(coordinate(*low), method, slack).low,
                whole_bounds(coordinate(*high), method, slack).high};
    } else {
        WholeBounds all = whole_bounds(coordinate(corners[0]), method, slack);
        for (const Vec<Coordinate, 2>& corner : corners.subspan(1)) {
            const WholeBounds bounds = whole_bounds(coordinate(corner), method, slack);
            all = {std::min(all.low, bounds.low), std::max(all.high, bounds.high)};
        }
        return all;
    }
}

/// How far, in pixels, rounding may carry a row's end, or a line, from the whole numbers around it: none
/// if these are its samples, or if only what lies between its vertices has samples.
Index reach_of_samples(PrimitiveKind kind, const Method& method) {
    const bool is_triangle = kind == PrimitiveKind::triangle;
    const bool is_line = kind == PrimitiveKind::line || kind == PrimitiveKind::outline;
    const Sample sample = is_triangle ? sample_of(method)
                          : is_line   ? sample_of_lines(method)
                                      : sample_of_others(method);
    const bool is_between = is_triangle
                                ? traits_of(method.fill).rule == PixelRule::samples
                                : is_line && traits_of(method.line).rule == LineRule::diamonds;
    return sample == Sample::integer || is_between ? 0 : 1;
}

/// The pixels that a piece can reach under any rounding rule: a rounded end of a row, or a pixel of a
/// line, lies less than a pixel away.
template <typename Coordinate> PixelBox box_of(const Piece<Coordinate>& piece, const Scene& scene) {
    double farthest = 1;
    const auto corners = piece.corners();
    for (const Vec<Coordinate, 2>& at : corners)
        farthest = std::max({farthest, std::abs(to_double(at.x)), std::abs(to_double(at.y))});
    const double slack = slack_of(scene.method, farthest);
    const WholeBounds x = whole_bounds<Coordinate>(
        corners, [](const auto& at) -> const Coordinate& { return at.x; }, scene.method, slack);
    const WholeBounds y = whole_bounds<Coordinate>(
        corners, [](const auto& at) -> const Coordinate& { return at.y; }, scene.method, slack);
    const auto [top, bottom] =
        std::minmax({scene.canvas.row_of(y.low), scene.canvas.row_of(y.high)});
    // A face may hide a point of a line although the line draws only the next pixel
    // (line_painter.h).
    const Index around =
        (is_filled(piece.kind) ? 0 : 1) + reach_of_samples(piece.kind, scene.method);
    const auto side = [](Index at) {
        constexpr Index limit = Index{1} << 30;
        return static_cast<std::int32_t>(std::clamp(at, -limit, limit));
    };
    return {side(x.low - around), side(top - around), side(x.high + around), side(bottom + around)};
}

/// `epsilon`, or more where numbers of this size are `error` off: 64 times that.
double with_error(double epsilon, double error, double size) {
    return 64 * error <= epsilon * size ? epsilon : 64 * error / size;
}

/// True if a triangle's depths pass by a margin that is larger than what rounding makes of them.
/// They come from slopes, whose error grows with the square of its extent over its area.
/// `position_error(i)` is that of a corner.
template <typename PositionError>
bool has_safe_slopes(const Piece<double>& triangle, double largest, double margin, double epsilon,
                     const Method& method, PositionError&& position_error) {
    const auto& [a, b, c] = triangle.positions;
    const double abx = b.x - a.x, aby = b.y - a.y;
    const double acx = c.x - a.x, acy = c.y - a.y;
    const double extent =
        1 + std::max({std::abs(abx), std::abs(aby), std::abs(acx), std::abs(acy)});
    // `fixed` draws another triangle: each corner moves by up to 1/512 pixel.
    const bool is_snapped = method.scalar == ScalarKind::fixed;
    const double area2 = std::abs(abx * acy - acx * aby) - (is_snapped ? extent / 64 : 0);
    // Differences of coordinates are as exact as this times epsilon; so must be the coordinates.
    const double farthest = std::max({std::abs(a.x), std::abs(a.y), extent});
    for (std::size_t i = 0; i < 3; ++i)
        epsilon = with_error(epsilon, position_error(i), farthest);
    if (!(area2 > epsilon * extent * farthest))
        return false;

    // No product may be infinite, and no slope so small that it loses digits.
    const bool is_single = method.scalar == ScalarKind::single_precision;
    const double most =
        is_single ? double{std::numeric_limits<float>::max()} : std::numeric_limits<double>::max();
    const double least =
        is_single ? double{std::numeric_limits<float>::min()} : std::numeric_limits<double>::min();
    const bool fits =
        8 * largest * farthest < most && 8 * farthest * farthest < most &&
        (largest == 0 || least * 0x1p30 * farthest * farthest < margin * std::min(1.0, area2));
    if (!decides_exactly(method) && !fits)
        return false;
    const double error = epsilon * largest * (1 + extent * farthest / area2);
    return error < margin;
}

/// True if every depth that can be calculated in the piece passes against a clear buffer. The
/// depths of a line lie between those of its ends, but for a rounding or two.
template <typename Coordinate>
bool has_safe_depth(const Piece<Coordinate>& piece, const DepthRule<double>& rule,
                    const Method& method) {
    double largest = 0;
    double margin = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < piece.count; ++i) {
        const double depth = to_double(piece.depths[i]);
        largest = std::max(largest, std::abs(depth));
        if (rule.cleared)
            margin = std::min(margin,
                              rule.larger_passes ? depth - *rule.cleared : *rule.cleared - depth);
    }
    const bool is_single = method.scalar == ScalarKind::single_precision;
    double epsilon = is_single ? 0x1p-18 : 0x1p-46;
    for (const auto& depth : piece.depths)
        epsilon = with_error(epsilon, error_of(depth), largest);
    if (piece.kind != PrimitiveKind::triangle)
        return epsilon * largest < margin;
    return has_safe_slopes(in_doubles(piece), largest, margin, epsilon, method, [&](std::size_t i) {
        return error_of(piece.positions[i].x) + error_of(piece.positions[i].y);
    });
}

/// The survey of a primitive that doubles leave open: it needs all stages.
PrimitiveSurvey open_survey(PrimitiveKind kind) {
    return {.kind = kind,
            .pieces = 2,
            .box = {-(1 << 30), -(1 << 30), 1 << 30, 1 << 30},
            .has_safe_depth = false,
            .w_differs = true,
            .colors_differ = true};
}

/// Adds a piece to the survey of its primitive.
template <typename Coordinate>
void survey_piece(const Scene& scene, const Piece<Coordinate>& piece, const DepthRule<double>* rule,
                  PrimitiveSurvey& survey) {
    const bool is_first = survey.pieces == 0;
    survey.kind = piece.kind;
    survey.pieces += piece.kind == PrimitiveKind::outline ? 3 : 1;
    survey.box = survey.box.joined(box_of(piece, scene));
    if constexpr (!std::same_as<Coordinate, Number>) { // vertices as typed have no depth and no w
        survey.has_safe_depth = rule && (is_first || survey.has_safe_depth) &&
                                has_safe_depth(piece, *rule, scene.method);
        for (std::size_t i = 1; i < piece.count; ++i)
            survey.w_differs =
                survey.w_differs || may_differ(piece.inverse_w[0], piece.inverse_w[i]);
    }
    for (std::size_t i = 1; i < piece.count; ++i)
        survey.colors_differ =
            survey.colors_differ || piece.colors[0] != piece.colors[i] || !piece.levels.empty();
}

/// Finds the primitives that may share a pixel with another one, because their boxes overlap. Boxes
/// are sorted into the cells of a grid and compared with the first few of each cell; those in a
/// crowded cell are taken to overlap.
void find_shared(std::vector<PrimitiveSurvey>& triangles, const Canvas& canvas) {
    constexpr Index cell_side = 16;
    constexpr std::size_t crowd = 16;
    struct Cell {
        std::array<std::uint32_t, crowd> triangles{};
        std::uint32_t count = 0;
        bool is_decided = false; ///< it is crowded, and all of these share a pixel
    };
    const Index columns = (canvas.width + cell_side - 1) / cell_side;
    const Index rows = (canvas.height + cell_side - 1) / cell_side;
    std::vector<Cell> cells(static_cast<std::size_t>(columns * rows));
    const auto look_into = [&](Cell& cell, std::size_t number) {
        const bool is_crowded = cell.count == crowd;
        PrimitiveSurvey& triangle = triangles[number];
        if (!cell.is_decided) {
            bool all_share = true;
            for (std::size_t i = 0; i < cell.count; ++i) {
                PrimitiveSurvey& other = triangles[cell.triangles[i]];
                if (!(other.is_shared && triangle.is_shared) &&
                    !triangle.box.intersected(other.box).is_empty())
                    triangle.is_shared = other.is_shared = true;
                all_share = all_share && other.is_shared;
            }
            cell.is_decided = is_crowded && all_share;
        }
        if (is_crowded)
            triangle.is_shared = true;
        else
            cell.triangles[cell.count++] = static_cast<std::uint32_t>(number);
    };
    for (std::size_t number = 0; number < triangles.size(); ++number) {
        const PixelBox box = triangles[number].box.intersected(box_of(canvas));
        if (box.is_empty())
            continue;
        for (Index row = box.top / cell_side; row <= box.bottom / cell_side; ++row)
            for (Index column = (box.left - canvas.left()) / cell_side;
                 column <= (box.right - canvas.left()) / cell_side; ++column)
                look_into(cells[static_cast<std::size_t>(row * columns + column)], number);
    }
}

} // namespace

std::vector<PrimitiveSurvey> survey_of(const Scene& scene, const AnyScreenList& list) {
    std::vector<PrimitiveSurvey> result(scene.primitives.size());
    const bool has_depth_buffer = scene.has_depth_buffer();
    const bool has_lines = has_depth_buffer || scene.mixes_lines_in_space();
    const DepthRule<double> rule = depth_rule<double>(scene);
    const auto survey_all = [&](const auto& primitives) {
        for_each_primitive(scene, primitives, [&](const ScreenPrimitive& one) {
            const PrimitiveKind kind = scene.primitives[one.primitive].kind;
            if (one.state == ScreenPrimitive::State::undecided) {
                result[one.primitive] = open_survey(kind);
                return;
            }
            const auto piece = piece_of(scene, primitives, one);
            if ((is_filled(kind) || has_lines) && !piece.is_skipped)
                survey_piece(scene, piece, has_depth_buffer ? &rule : nullptr,
                             result[one.primitive]);
        });
    };
    std::visit(survey_all, list);
    if (has_depth_buffer)
        find_shared(result, scene.canvas);
    return result;
}

} // namespace rastertrace
