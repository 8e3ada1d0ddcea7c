// SPDX-License-Identifier: MIT
#include "plan/stages_of.h"

#include <rastertrace/core/draw/list/geometry.h>
#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/core/draw/plan/stages.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/numbers/adaptive.h>
#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/depth_interpolation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// A rectangle of pixels: columns from `left` to `right`, rows from `top` to `bottom` counted from
/// the top of the picture, all four included. Sides far beyond any canvas are kept within +-2^30.
struct PixelBox {
    std::int32_t left = 0;
    std::int32_t top = 0;
    std::int32_t right = -1;
    std::int32_t bottom = -1;

    bool is_empty() const { return right < left || bottom < top; }
    bool has(const PixelBox& other) const {
        return left <= other.left && other.right <= right && top <= other.top &&
               other.bottom <= bottom;
    }
    bool meets(const PixelBox& other) const {
        return left <= other.right && other.left <= right && top <= other.bottom &&
               other.top <= bottom;
    }
    PixelBox meet(const PixelBox& other) const {
        return {std::max(left, other.left), std::max(top, other.top), std::min(right, other.right),
                std::min(bottom, other.bottom)};
    }
    PixelBox join(const PixelBox& other) const {
        return is_empty() ? other
                          : PixelBox{std::min(left, other.left), std::min(top, other.top),
                                     std::max(right, other.right), std::max(bottom, other.bottom)};
    }
    PixelBox grown(int by) const { return {left - by, top - by, right + by, bottom + by}; }
    std::uint64_t area() const {
        return is_empty() ? 0
                          : static_cast<std::uint64_t>(right - left + 1) *
                                static_cast<std::uint64_t>(bottom - top + 1);
    }
};

PixelBox box_of(const Canvas& canvas) {
    return {canvas.left(), 0, canvas.right(), canvas.height - 1};
}

/// What the stages of a primitive's pixels are decided from.
struct PrimitiveSurvey {
    PrimitiveKind kind = PrimitiveKind::triangle;
    int pieces = 0;
    PixelBox box = {};           ///< it draws no pixel outside of it
    bool is_shared = false;      ///< another one may draw a pixel of it, for their boxes meet
    bool has_safe_depth = false; ///< no depth of it can lose against a clear buffer
    bool w_differs = false;
    bool colors_differ = false;

    /// True if another primitive may hide a pixel of it, or the clear buffer.
    bool may_be_hidden() const { return is_shared || !has_safe_depth; }
    /// True if it may draw a pixel twice: the parts of a clipped triangle share pixels, and the sides of an outline.
    bool has_parts() const { return pieces > 1; }
};

/// One of which nothing is known: it needs all stages.
PrimitiveSurvey unknown_survey(PrimitiveKind kind) {
    return {.kind = kind,
            .pieces = 2,
            .box = {-(1 << 30), -(1 << 30), 1 << 30, 1 << 30},
            .has_safe_depth = false,
            .w_differs = true,
            .colors_differ = true};
}

/// How far calculated places may lie from exact ones, for coordinates up to `farthest`: the numbers
/// drawn with are rounded, and adding up a slope adds up its error.
double slack_of(const Method& method, double farthest) {
    const double unit =
        farthest * (method.scalar == ScalarKind::single_precision ? 0x1p-20 : 0x1p-49);
    return method.lerp == LerpForm::incremental ? unit * largest_canvas_side : unit;
}

/// The largest whole number that nothing calculated from a coordinate lies below, and the smallest
/// that nothing lies above.
struct WholeBounds {
    Index low;
    Index high;
};

template <typename Coordinate>
WholeBounds whole_bounds(const Coordinate& coordinate, const Method& method, double slack) {
    if constexpr (!std::floating_point<Coordinate> && !std::same_as<Coordinate, Adaptive>)
        if (decides_exactly(method)) {
            // Whole numbers are doubles up to 2^53, and rounding to one passes none of them by.
            const double near = to_double(coordinate);
            if (const Index below = floor_index(near); static_cast<double>(below) != near)
                return {below, below + 1};
            const Rational exact = scalar_from<Rational>(coordinate, 1);
            return {floor_index(exact), ceil_index(exact)};
        }
    if constexpr (!std::same_as<Coordinate, Adaptive>)
        if (method.scalar == ScalarKind::fixed)
            if (const auto numerator = nearest_numerator(coordinate, fixed_grid))
                return {floor_quotient(*numerator, fixed_grid),
                        -floor_quotient(-*numerator, fixed_grid)};
    const double x = to_double(coordinate);
    const double off = slack + error_of(coordinate);
    return {floor_index(x - off), ceil_index(x + off)};
}

/// The pixels that a primitive can reach under any rounding rule: samples lie at integers or half a
/// pixel up, and a rounded end of a row, or a pixel of a line, lies less than a pixel away.
template <typename Coordinate> PixelBox box_of(const Piece<Coordinate>& piece, const Scene& scene) {
    const auto& a = piece.positions[0];
    const auto& b = piece.positions[piece.count > 1 ? 1 : 0];
    const auto& c = piece.positions[piece.count > 2 ? 2 : 0];
    const auto farthest = [](double x, double y, double z) {
        return std::max({std::abs(x), std::abs(y), std::abs(z)});
    };
    const double slack = slack_of(
        scene.method, std::max({1.0, farthest(to_double(a.x), to_double(b.x), to_double(c.x)),
                                farthest(to_double(a.y), to_double(b.y), to_double(c.y))}));
    const auto bounds = [&](const Coordinate& x, const Coordinate& y, const Coordinate& z) {
        if constexpr (std::floating_point<Coordinate>) {
            const auto [low, high] = std::minmax({x, y, z});
            return WholeBounds{whole_bounds(low, scene.method, slack).low,
                               whole_bounds(high, scene.method, slack).high};
        } else {
            const auto of_x = whole_bounds(x, scene.method, slack);
            const auto of_y = whole_bounds(y, scene.method, slack);
            const auto of_z = whole_bounds(z, scene.method, slack);
            return WholeBounds{std::min({of_x.low, of_y.low, of_z.low}),
                               std::max({of_x.high, of_y.high, of_z.high})};
        }
    };
    const auto [left, right] = bounds(a.x, b.x, c.x);
    const auto [low, high] = bounds(a.y, b.y, c.y);
    const auto [top, bottom] = std::minmax({scene.canvas.row_of(low), scene.canvas.row_of(high)});
    const auto side = [](Index at) {
        constexpr Index limit = Index{1} << 30;
        return static_cast<std::int32_t>(std::clamp(at, -limit, limit));
    };
    return {side(left), side(top), side(right), side(bottom)};
}

/// True if every depth that can be calculated in the piece passes against a clear buffer. Depths of a
/// triangle come from slopes, whose rounding error grows with the square of its extent over its area; those
/// of a line lie between the depths of its ends, but for a rounding or two.
template <typename Coordinate>
bool has_safe_depth(const Piece<Coordinate>& piece, const DepthRule<double>& rule,
                    const Scene& scene) {
    std::array<std::array<double, 2>, 3> at{};
    double largest = 0;
    double margin = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < piece.count; ++i) {
        at[i] = {to_double(piece.positions[i].x), to_double(piece.positions[i].y)};
        const double depth = to_double(piece.depths[i]);
        largest = std::max(largest, std::abs(depth));
        if (rule.cleared)
            margin = std::min(margin,
                              rule.larger_passes ? depth - *rule.cleared : *rule.cleared - depth);
    }
    const bool is_single = scene.method.scalar == ScalarKind::single_precision;
    const double epsilon = std::ldexp(1.0, is_single ? -18 : -46);
    const bool has_exact_depths =
        std::all_of(piece.depths.begin(), piece.depths.end(),
                    [&](const auto& depth) { return error_of(depth) <= epsilon * largest / 64; });
    if (!has_exact_depths)
        return false;
    if (piece.kind != PrimitiveKind::triangle)
        return epsilon * largest < margin;

    const double abx = at[1][0] - at[0][0], aby = at[1][1] - at[0][1];
    const double acx = at[2][0] - at[0][0], acy = at[2][1] - at[0][1];
    const double extent =
        1 + std::max({std::abs(abx), std::abs(aby), std::abs(acx), std::abs(acy)});
    // `fixed` draws another triangle: each corner moves by up to 1/512 pixel.
    const bool is_snapped = scene.method.scalar == ScalarKind::fixed;
    const double area2 = std::abs(abx * acy - acx * aby) - (is_snapped ? extent / 64 : 0);
    const double farthest = std::max(
        {std::abs(at[0][0]), std::abs(at[0][1]), extent}); // differences are as exact as this
    // What is known with an error: each must be as exact as the rounding that is allowed for.
    for (std::size_t i = 0; i < 3; ++i)
        if (!(error_of(piece.positions[i].x) + error_of(piece.positions[i].y) <=
              epsilon * farthest / 64))
            return false;
    if (!(area2 > epsilon * extent * farthest))
        return false;

    // No product may be infinite, and no slope so small that it loses digits.
    const bool is_exact = decides_exactly(scene.method);
    const double most =
        is_single ? double{std::numeric_limits<float>::max()} : std::numeric_limits<double>::max();
    const double least =
        is_single ? double{std::numeric_limits<float>::min()} : std::numeric_limits<double>::min();
    const bool fits = 8 * largest * farthest < most && 8 * farthest * farthest < most &&
                      (largest == 0 ||
                       std::ldexp(least, 30) * farthest * farthest < margin * std::min(1.0, area2));
    if (!is_exact && !fits)
        return false;
    const double error = epsilon * largest * (1 + extent * farthest / area2);
    return error < margin;
}

/// Looks at every triangle that is drawn, with its parts; at points and lines too if depths are tested.
/// Without a pipeline there are no depths and no w.
template <typename AList>
std::vector<PrimitiveSurvey> survey_of(const Scene& scene, const AList& list) {
    std::vector<PrimitiveSurvey> result(scene.primitives.size());
    const bool has_depth_buffer = scene.has_depth_buffer();
    const DepthRule<double> rule = depth_rule<double>(scene);
    for_each_primitive(scene, list, [&](const ScreenPrimitive& one) {
        PrimitiveSurvey& triangle = result[one.primitive];
        if (one.state == ScreenPrimitive::State::undecided) {
            triangle = unknown_survey(scene.primitives[one.primitive].kind);
            return;
        }
        const auto piece = piece_of(scene, list, one);
        if ((piece.kind != PrimitiveKind::triangle && !has_depth_buffer) || piece.is_skipped)
            return;
        const bool is_first = triangle.pieces == 0;
        triangle.kind = piece.kind;
        triangle.pieces += piece.kind == PrimitiveKind::outline ? 3 : 1;
        // A face may hide a point of a line that it has only the next pixel of (line_painter.h).
        const int around = piece.kind == PrimitiveKind::triangle ? 0 : 1;
        triangle.box = triangle.box.join(box_of(piece, scene).grown(around));
        if constexpr (!std::same_as<AList, TypedVertices>) {
            triangle.has_safe_depth = has_depth_buffer && (is_first || triangle.has_safe_depth) &&
                                      has_safe_depth(piece, rule, scene);
            const auto& [a, b, c] = piece.inverse_w;
            triangle.w_differs = triangle.w_differs || may_differ(a, b) || may_differ(a, c);
        }
        if (piece.kind != PrimitiveKind::triangle)
            return;
        const auto& [a, b, c] = piece.colors;
        triangle.colors_differ = triangle.colors_differ || a != b || a != c;
    });
    return result;
}

/// Finds which primitives may share a pixel with another one: their boxes meet. Boxes are sorted into the
/// cells of a grid and compared with the first few of each cell; where more crowd, they are taken to
/// meet.
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
                if (!(other.is_shared && triangle.is_shared) && triangle.box.meets(other.box))
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
        const PixelBox box = triangles[number].box.meet(box_of(canvas));
        if (box.is_empty())
            continue;
        for (Index row = box.top / cell_side; row <= box.bottom / cell_side; ++row)
            for (Index column = (box.left - canvas.left()) / cell_side;
                 column <= (box.right - canvas.left()) / cell_side; ++column)
                look_into(cells[static_cast<std::size_t>(row * columns + column)], number);
    }
}

/// The stages of each primitive's pixels.
std::vector<PixelStages> pixel_stages(const Scene& scene,
                                      const std::vector<PrimitiveSurvey>& triangles) {
    const bool has_depth_buffer = scene.has_depth_buffer();
    const bool mixes_colors = scene.mixes_colors();
    const bool mixes_in_perspective = scene.mixes_in_perspective();
    const PixelBox canvas = box_of(scene.canvas);
    std::vector<PixelStages> result(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const PrimitiveSurvey& triangle = triangles[i];
        PixelStages& stages = result[i];
        stages.tests_canvas = scene.keep.has(Stage::canvas) || !canvas.has(triangle.box);
        stages.is_painted = scene.primitives[i].is_painted;
        stages.tests_depth = has_depth_buffer && (scene.keep.has(Stage::depth) ||
                                                  triangle.may_be_hidden() || triangle.has_parts());
        if (mixes_colors && (triangle.colors_differ || scene.keep.has(Stage::colors)))
            stages.colors =
                mixes_in_perspective && (triangle.w_differs || scene.keep.has(Stage::perspective))
                    ? ColorStage::perspective
                    : ColorStage::affine;
    }
    return result;
}

/// Decides about the stages of vertices. Without a pipeline, vertices go through none.
template <typename Coordinate>
void decide_vertex_stages(const Scene& scene, const ScreenList<Coordinate>& list,
                          std::vector<StageDecision>& decisions) {
    const auto& transforms = list.transforms;
    const auto is_used = used_vertices(scene);
    const auto vertices =
        static_cast<std::uint64_t>(std::count(is_used.begin(), is_used.end(), true));
    const StageSet& needed = transforms.needed;
    const bool moves = needed.has(Stage::model);
    decisions.push_back({Stage::model,
                         "",
                         moves || transforms.rest_model,
                         moves ? "a model moves its vertices" : "no model moves anything",
                         {.steps = vertices}});
    decisions.push_back({Stage::view,
                         "",
                         transforms.view.has_value(),
                         needed.has(Stage::view) ? "the camera moves the world"
                         : scene.camera          ? "the camera looks from where the world begins"
                                                 : "there is no camera",
                         {.steps = vertices}});
    for (const auto& [plane, outside] : list.outside)
        decisions.push_back({Stage::clip, plane, outside > 0 || scene.keep.has(Stage::clip),
                             outside == 1  ? "1 vertex lies outside it"
                             : outside > 0 ? std::to_string(outside) + " vertices lie outside it"
                                           : "no vertex lies outside it"});
    if (list.outside.empty())
        decisions.push_back({Stage::clip, "", false, "nothing bounds the view"});
    decisions.push_back(
        {Stage::divide,
         "",
         transforms.divides,
         needed.has(Stage::divide) ? "w is not 1 at every vertex" : "w is 1 at every vertex",
         {.steps = transforms.projection ? vertices : 0}});
    const bool paints = scene.depth() == Depth::painter;
    decisions.push_back({Stage::order,
                         "",
                         list.order.has_value(),
                         !paints                    ? "the method has no painter"
                         : needed.has(Stage::order) ? "the farthest triangles do not come first"
                                                    : "the farthest triangles come first already",
                         {.steps = paints ? 1U : 0U}});
}
void decide_vertex_stages(const Scene&, const TypedVertices&,
                          std::vector<StageDecision>& decisions) {
    decisions.push_back({Stage::model, "", false, "no model moves anything"});
    decisions.push_back({Stage::view, "", false, "there is no camera"});
    decisions.push_back({Stage::clip, "", false, "nothing bounds the view"});
    decisions.push_back({Stage::divide, "", false, "w is 1 at every vertex"});
    decisions.push_back({Stage::order, "", false, "the method has no painter"});
}

/// Decides about the stages of faces: what the method does not ask for would change the picture.
void decide_face_stages(const Scene& scene, std::vector<StageDecision>& decisions) {
    const bool culls = scene.method.cull != Cull::none;
    const bool lights = scene.method.shade == Shade::lambert;
    const bool has_triangles = scene.has(PrimitiveKind::triangle);
    const auto why = [has_triangles](bool is_asked) {
        return !is_asked        ? "the method does not ask for it"
               : !has_triangles ? "there is no triangle"
                                : "the method asks for it";
    };
    decisions.push_back({Stage::cull, "", culls && has_triangles, why(culls)});
    decisions.push_back({Stage::light, "", lights && has_triangles, why(lights)});
}

/// Why depths are tested, or not: what the primitives need, whatever was asked to be kept.
std::string why_depth(const std::vector<PrimitiveSurvey>& triangles) {
    std::uint64_t all = 0, hidden = 0, with_parts = 0;
    bool are_triangles = true;
    for (const PrimitiveSurvey& one : triangles) {
        if (one.pieces == 0)
            continue;
        ++all;
        hidden += one.may_be_hidden() ? 1 : 0;
        with_parts += one.has_parts() && !one.may_be_hidden() ? 1 : 0;
        are_triangles = are_triangles && one.kind == PrimitiveKind::triangle;
    }
    const std::string of_all = " of " + counted(all, are_triangles ? "triangle" : "primitive");
    std::string why;
    if (hidden > 0)
        why = std::to_string(hidden) + of_all +
              " may share a pixel with another, or may be as far as the buffer starts";
    if (with_parts > 0)
        why += (why.empty() ? "" : "; ") + std::to_string(with_parts) + of_all +
               (with_parts == 1 ? " has" : " have") +
               (are_triangles ? " parts, made by clipping, that may share a pixel"
                              : " parts or sides that may share a pixel");
    if (!why.empty())
        return why;
    return are_triangles ? "no two triangles can share a pixel"
                         : "no two primitives can share a pixel";
}

/// Decides about the stages of pixels, from what was decided for each triangle.
void decide_pixel_stages(const Scene& scene, const std::vector<PrimitiveSurvey>& triangles,
                         std::size_t depth_size, Stages& stages) {
    const PixelBox canvas = box_of(scene.canvas);
    struct Count {
        std::uint64_t kept = 0;
        std::uint64_t saved_pixels = 0;
    };
    Count in_canvas, in_depth, in_perspective, in_colors;
    std::uint64_t all = 0, beyond = 0, differ_in_w = 0, differ_in_color = 0;
    PixelBox tested;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const PrimitiveSurvey& triangle = triangles[i];
        if (triangle.pieces == 0)
            continue;
        const PixelBox box = triangle.box.meet(canvas);
        const PixelStages& pixels = stages.pixels[i];
        if (pixels.tests_depth && !box.is_empty())
            tested = tested.join(box);
        if (triangle.kind != PrimitiveKind::triangle) {
            in_depth.kept += pixels.tests_depth ? 1 : 0;
            continue;
        }
        ++all;
        const auto note = [&box](Count& count, bool is_kept) {
            count.kept += is_kept ? 1 : 0;
            count.saved_pixels += is_kept ? 0 : box.area();
        };
        note(in_canvas, pixels.tests_canvas);
        note(in_depth, pixels.tests_depth);
        note(in_perspective, pixels.colors == ColorStage::perspective);
        note(in_colors, pixels.colors != ColorStage::flat);
        beyond += canvas.has(triangle.box) ? 0 : 1;
        differ_in_w += triangle.w_differs ? 1 : 0;
        differ_in_color += triangle.colors_differ ? 1 : 0;
    }
    auto& decisions = stages.decisions;
    const auto of_all = [all](std::uint64_t some) {
        return std::to_string(some) + " of " + counted(all, "triangle");
    };

    decisions.push_back({Stage::canvas,
                         "",
                         in_canvas.kept > 0,
                         beyond > 0 ? of_all(beyond) + " may reach beyond the canvas"
                         : all > 0  ? "every triangle lies on the canvas"
                                    : "no triangle is filled",
                         {.pixels = in_canvas.saved_pixels}});

    if (scene.keep.has(Stage::depth) && scene.has_depth_buffer())
        tested = canvas;
    stages.depth_region = {tested.left, tested.top, std::max(tested.right - tested.left + 1, 0),
                           std::max(tested.bottom - tested.top + 1, 0)};
    const bool has_depths = scene.has_depth_buffer();
    decisions.push_back({Stage::depth,
                         "",
                         in_depth.kept > 0,
                         has_depths ? why_depth(triangles) : "the method has no depth buffer",
                         {.bytes = has_depths ? (canvas.area() - tested.area()) * depth_size : 0,
                          .pixels = has_depths ? in_depth.saved_pixels : 0}});

    const bool mixes = scene.mixes_colors() && all > 0;
    const bool in_space = scene.mixes_in_perspective() && all > 0;
    decisions.push_back({Stage::perspective,
                         "",
                         in_perspective.kept > 0,
                         !in_space         ? "no colors are mixed in a perspective"
                         : differ_in_w > 0 ? "w differs in " + of_all(differ_in_w)
                                           : "w is the same all over each triangle",
                         {.pixels = in_space ? in_perspective.saved_pixels : 0}});
    decisions.push_back({Stage::colors,
                         "",
                         in_colors.kept > 0,
                         !mixes                ? "no colors are mixed"
                         : differ_in_color > 0 ? "the vertices differ in " + of_all(differ_in_color)
                                               : "the vertices of each triangle agree",
                         {.pixels = mixes ? in_colors.saved_pixels : 0}});
}

} // namespace

template <typename AList>
Stages stages_of(const Scene& scene, const AList& list, std::size_t depth_size) {
    std::vector<PrimitiveSurvey> triangles = survey_of(scene, list);
    if (scene.has_depth_buffer())
        find_shared(triangles, scene.canvas);
    Stages stages;
    stages.pixels = pixel_stages(scene, triangles);
    decide_vertex_stages(scene, list, stages.decisions);
    decide_face_stages(scene, stages.decisions);
    decide_pixel_stages(scene, triangles, depth_size, stages);

    for (StageDecision& decision : stages.decisions) {
        if (decision.is_kept)
            decision.saved = {};
        if (decision.is_kept && scene.keep.has(decision.stage))
            decision.why = "asked to be kept; " + decision.why;
    }
    return stages;
}

template Stages stages_of(const Scene&, const TypedVertices&, std::size_t);
template Stages stages_of(const Scene&, const ScreenList<float>&, std::size_t);
template Stages stages_of(const Scene&, const ScreenList<double>&, std::size_t);
template Stages stages_of(const Scene&, const ScreenList<Adaptive>&, std::size_t);
template Stages stages_of(const Scene&, const ScreenList<Rational>&, std::size_t);

} // namespace rastertrace
