// SPDX-License-Identifier: MIT
#pragma once

// Draws a scene: every primitive in the scene's order, by the method that the scene names.
//
//     const Image picture = draw<double>(scene, plan_for(scene), NullSink{});

#include <rastertrace/core/adaptive.h>
#include <rastertrace/core/depth.h>
#include <rastertrace/core/exactly.h>
#include <rastertrace/core/fill_barycentric.h>
#include <rastertrace/core/fill_fan.h>
#include <rastertrace/core/fill_scanline.h>
#include <rastertrace/core/fill_top_left.h>
#include <rastertrace/core/fill_two_halves.h>
#include <rastertrace/core/image.h>
#include <rastertrace/core/line_bresenham.h>
#include <rastertrace/core/line_lerp.h>
#include <rastertrace/core/pieces.h>
#include <rastertrace/core/placed.h>
#include <rastertrace/core/plan.h>
#include <rastertrace/core/scene.h>
#include <rastertrace/core/sink.h>
#include <rastertrace/core/steps.h>
#include <rastertrace/core/triangle.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace rastertrace {

/// Draws the line between two vertices of a primitive.
template <typename Scalar, typename Sink>
void draw_line(const PlacedPrimitive<Scalar>& primitive, EdgeName side, const Method& method,
               Image& image, Sink&& sink) {
    Segment<Scalar> segment{primitive.positions[side.from], primitive.positions[side.to]};
    GridLine line{nearest_pixel(segment.from.x, segment.from.y),
                  nearest_pixel(segment.to.x, segment.to.y), primitive.colors[side.from],
                  primitive.colors[side.to]};

    // From the low end, if that is asked for.
    const bool is_x_major = std::abs(line.to.x - line.from.x) >= std::abs(line.to.y - line.from.y);
    const bool runs_down = is_x_major ? line.to.x < line.from.x : line.to.y < line.from.y;
    if (method.from == LineStart::low && runs_down) {
        line = reversed(line);
        std::swap(segment.from, segment.to);
    }

    if (method.line == LineMethod::bresenham)
        draw_bresenham(line, method.color_lerp, image, sink);
    else
        draw_line_by_lerp(segment,
                          method.line == LineMethod::naive ? LineForm::naive : LineForm::dda,
                          line_rounding(method), line, method.color_lerp, image, sink);
}

/// How often `adaptive` could not decide with doubles.
struct Fallbacks {
    std::uint64_t primitives = 0; ///< or parts of one: drawn with exact numbers, from some row on
    std::uint64_t depths = 0;     ///< tests
    std::uint64_t colors = 0;     ///< of pixels
};

/// What drawing needs to decide exactly what its numbers leave open; most numbers leave nothing open.
template <typename Scalar> struct Exactness {};
template <> struct Exactness<Adaptive> {
    ExactPieces pieces;
    Rational sample_offset;
    std::vector<PieceNumber> drawn = {}; ///< the pieces so far; the last one is being drawn
    bool is_exact = false;               ///< its numbers are exact, too
    Fallbacks fallbacks = {};
};

/// What pixels are drawn on and tested against, and where their samples lie.
template <typename Scalar> struct Target {
    Image image;
    SampleGrid<Scalar> grid;
    std::optional<DepthBuffer<DepthOf<Scalar>>> depth = {};
    Exactness<Scalar> exactness;
};

/// Fills a triangle with the stages that its pixels go through.
template <typename Scalar, PixelStages stages, typename Sink>
void fill(const PlacedPrimitive<Scalar>& primitive, const Paint<Scalar, stages>& paint,
          const Method& method, Target<Scalar>& target, Sink&& sink) {
    const Triangle<Scalar> triangle{primitive.positions};
    Image& image = target.image;
    const ScanlineRules rules{.lerp = method.lerp, .span = span_rounding(method)};
    switch (method.fill) {
    case Fill::scanline:
        return fill_scanline(triangle, paint, rules, image, sink);
    case Fill::two_halves:
        return fill_two_halves(triangle, paint, rules, image, sink);
    case Fill::barycentric:
        return fill_barycentric(triangle, paint, target.grid.sample_offset(), image, sink);
    case Fill::top_left:
        return fill_top_left(triangle, paint, target.grid, image, sink);
    case Fill::fan:
        break;
    }
    fill_fan(triangle, primitive.colors,
             {.passes = method.fan_passes, .color_lerp = method.color_lerp}, image, sink);
}

/// Colors that are mixed with errors, pixel by pixel, and exactly where an error reaches over half a
/// level.
inline MixedColors<Adaptive> mixed_colors(const PlacedPrimitive<Adaptive>& primitive,
                                          const Adaptive& sample_offset, ColorStage stage,
                                          Exactness<Adaptive>& exactness) {
    Triangle<Adaptive> triangle;
    std::array<Adaptive, 3> inverse_w;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& [x, y] = primitive.positions[i];
        triangle.vertices[i] = {x.rounded(), y.rounded()};
        inverse_w[i] = primitive.inverse_w[i].rounded();
    }
    const auto exact_color =
        [&exactness, stage, colors = std::optional<MixedColors<Rational>>()](Pixel pixel) mutable {
            ++exactness.fallbacks.colors;
            if (!colors) {
                const auto& exact = exactness.pieces.placed(exactness.drawn.back());
                colors = {exact.colors, Barycentric<Rational>({exact.positions}),
                          exactness.sample_offset, exact.inverse_w};
            }
            return stage == ColorStage::perspective ? colors->at<true>(pixel)
                                                    : colors->at<false>(pixel);
        };
    return {
        primitive.colors, Barycentric<Adaptive>(triangle), sample_offset, inverse_w, {exact_color}};
}

/// Fills a triangle.
template <typename Scalar, typename Sink>
void fill(const PlacedPrimitive<Scalar>& primitive, Color flat, const Scene& scene,
          const Plan& plan, Target<Scalar>& target, Sink&& sink) {
    const Triangle<Scalar> triangle{primitive.positions};
    const Scalar sample_offset = target.grid.sample_offset();

    // What its colors are mixed from. Without area, and where its vertices agree, it has one.
    PixelStages stages = plan.stages.pixels[primitive.number];
    const auto& [a, b, c] = primitive.colors;
    if (plan.mixes_colors && a == b && a == c)
        flat = a;
    std::optional<MixedColors<Scalar>> mixed;
    if (stages.colors != ColorStage::flat) {
        const Barycentric<Scalar> barycentric(triangle);
        if (barycentric.area2() == scalar_from<Scalar>(0))
            stages.colors = ColorStage::flat;
        else if constexpr (std::same_as<Scalar, Adaptive>)
            mixed = mixed_colors(primitive, sample_offset, stages.colors, target.exactness);
        else
            mixed = {primitive.colors, barycentric, sample_offset, primitive.inverse_w};
    }

    // What its depths are.
    std::optional<TriangleDepth<Scalar>> depth;
    if (stages.tests_depth) {
        depth.emplace(triangle, primitive.depths, *target.depth);
        if (scene.method.fill == Fill::top_left)
            depth->prepare(depth_scalar(sample_offset));
    }

    with_stages<std::remove_cvref_t<Sink>>(stages, [&]<PixelStages with>() {
        const Paint<Scalar, with> paint{flat, mixed ? &*mixed : nullptr, depth ? &*depth : nullptr};
        fill(primitive, paint, scene.method, target, sink);
    });
}

/// A piece in the numbers that it is drawn with.
template <typename Scalar, typename Coordinate>
PlacedPrimitive<Scalar> placed_for(const Piece<Coordinate>& piece, const Plan& plan,
                                   Exactness<Scalar>& exactness) {
    if constexpr (std::same_as<Scalar, Adaptive>)
        if (exactness.is_exact) {
            auto primitive = exactly(exactness.pieces.placed(exactness.drawn.back()));
            primitive.names = piece.names;
            return primitive;
        }
    return placed<Scalar>(piece, plan);
}

/// Draws a primitive, or a part of one.
template <typename Scalar, typename Coordinate, typename Sink>
void draw_piece(const Piece<Coordinate>& piece, const Scene& scene, const Plan& plan,
                Target<Scalar>& target, Sink&& sink) {
    const Method& method = scene.method;
    Image& image = target.image;
    const bool is_tested = target.depth && piece.kind == PrimitiveKind::triangle;
    const auto primitive = placed_for(piece, plan, target.exactness);
    if constexpr (std::same_as<Scalar, Adaptive>)
        if (target.depth)
            target.depth->begin(static_cast<std::uint32_t>(target.exactness.drawn.size() - 1));
    const auto pixel_of = [&primitive](std::size_t corner) {
        return nearest_pixel(primitive.positions[corner].x, primitive.positions[corner].y);
    };
    sink(PrimitiveBegan<Scalar>{
        .kind = piece.kind,
        .name = piece.name,
        .vertices = std::span(primitive.names).first(primitive.count),
        .positions = std::span(primitive.positions).first(primitive.count),
        .color = piece.color,
        .colors = std::span(primitive.colors).first(plan.mixes_colors ? primitive.count : 0),
        .octant = piece.kind == PrimitiveKind::line ? octant_of(pixel_of(0), pixel_of(1)) : 0,
        .is_part = piece.is_part,
        .depths = std::span(primitive.depths).first(is_tested ? primitive.count : 0)});
    if constexpr (!std::same_as<Coordinate, Number>)
        if (!report_face(piece.face, sink))
            return;

    switch (piece.kind) {
    case PrimitiveKind::point:
        draw_point(pixel_of(0), primitive.colors[0], image, sink);
        break;
    case PrimitiveKind::line:
        draw_line(primitive, {0, 1}, method, image, sink);
        break;
    case PrimitiveKind::outline:
        for (const EdgeName side : {EdgeName{0, 1}, EdgeName{1, 2}, EdgeName{2, 0}}) {
            sink(SideBegan{.edge = side,
                           .octant = octant_of(pixel_of(side.from), pixel_of(side.to))});
            draw_line(primitive, side, method, image, sink);
        }
        break;
    case PrimitiveKind::triangle:
        fill(primitive, piece.color, scene, plan, target, sink);
        break;
    }
}

/// True if vertices that lie at coordinates of this type are drawn with Scalar.
template <typename Scalar, typename Coordinate>
inline constexpr bool draws = std::same_as<Coordinate, Number> ||
                              std::same_as<Scalar, Coordinate> ||
                              (std::same_as<Scalar, Adaptive>
                                   ? std::same_as<Coordinate, Rational>
                                   : !std::floating_point<Scalar> &&
                                         !std::same_as<Coordinate, float> &&
                                         !std::same_as<Coordinate, Adaptive>);

/// Draws all pieces of the scene.
template <typename Scalar, typename AGeometry, typename Sink>
void draw_pieces(const Scene& scene, const Plan& plan, const AGeometry& geometry,
                 Target<Scalar>& target, Sink&& sink) {
    for_each_piece(scene, geometry, sink, [&]<typename Coordinate>(const Piece<Coordinate>& piece) {
        if constexpr (draws<Scalar, Coordinate>)
            draw_piece<Scalar>(piece, scene, plan, target, sink);
    });
}

/// Whether a piece is nearer in a pixel than what is stored there, in exact numbers.
inline bool is_nearer(const Scene& scene, Exactness<Adaptive>& exactness, std::uint32_t piece,
                      std::optional<std::uint32_t> stored, int x, int row) {
    const auto depth_of = [&](std::uint32_t number) {
        return exact_depth_at(scene, exactness.pieces.placed(exactness.drawn[number]), x,
                              scene.canvas.y_of(row));
    };
    if (stored)
        return depth_of(piece) < depth_of(*stored);
    const DepthRule<Rational> rule = depth_rule<Rational>(scene);
    const Rational cleared = rule.cleared.value_or(0);
    return depth_of(piece) < (rule.larger_passes ? Rational(-cleared) : cleared);
}

/// The same with doubles that know their error. A piece of which they leave a decision open is drawn
/// once more with exact numbers: up to there it comes out as before, so its steps are not told again.
template <typename AGeometry, typename Sink>
void draw_pieces(const Scene& scene, const Plan& plan, const AGeometry& geometry,
                 Target<Adaptive>& target, Sink&& sink) {
    Exactness<Adaptive>& exactness = target.exactness;
    if (target.depth)
        target.depth->ask([&](auto... asked) { return is_nearer(scene, exactness, asked...); });

    // What could not be decided is told, and done again.
    const auto decide = [&](auto& resumed, auto&& draw_it, auto&& draw_it_exactly) {
        try {
            draw_it();
            return;
        } catch (const Undecided& undecided) {
            sink(BoundExceeded{.difference = undecided.difference, .error = undecided.error});
        }
        resumed.pass_over_what_came();
        draw_it_exactly();
    };

    const bool mixes_colors = scene.mixes_colors();
    for (std::size_t turn = 0; turn < scene.primitives.size(); ++turn) {
        const std::size_t number = primitive_at(geometry, turn);
        std::size_t drawn = 0; // pieces of the primitive
        std::size_t part = 0;
        const auto draw_one = [&]<typename Coordinate>(const Piece<Coordinate>& piece) {
            if constexpr (draws<Adaptive, Coordinate>) {
                if (part++ < drawn)
                    return;
                exactness.drawn.push_back({number, drawn++});
                ResumedSink resumed(sink);
                exactness.is_exact = false;
                const auto draw_it = [&] {
                    draw_piece<Adaptive>(piece, scene, plan, target, resumed);
                };
                decide(resumed, draw_it, [&] {
                    ++exactness.fallbacks.primitives;
                    exactness.is_exact = true;
                    draw_it();
                });
            }
        };
        // Which pieces it has may be left open, too.
        ResumedSink resumed(sink);
        decide(
            resumed,
            [&] { visit_pieces(scene, geometry, number, mixes_colors, resumed, draw_one); },
            [&] {
                part = 0;
                exactness.pieces.visit(number, resumed, draw_one);
            });
    }
    if (target.depth)
        exactness.fallbacks.depths = target.depth->exact_tests();
}

/// Draws `scene` and returns its picture, reporting every step to `sink`. The picture is the same
/// whatever the sink. `Scalar` must be the one of the plan (with_scalar finds it), and find_unfit
/// must have found nothing. Who wants to know is told how often `adaptive` fell back on exact
/// numbers.
template <typename Scalar, typename Sink>
Image draw(const Scene& scene, const Plan& plan, Sink&& sink, Fallbacks* fallbacks = nullptr) {
    const auto exactness = [&]() -> Exactness<Scalar> {
        if constexpr (std::same_as<Scalar, Adaptive>)
            return {.pieces = ExactPieces(scene, plan),
                    .sample_offset = scalar_from<Rational>(sample_offset_of(scene.method))};
        else
            return {};
    };
    Target<Scalar> target{
        .image = Image(scene.canvas),
        .grid = {scalar_from<Scalar>(sample_offset_of(scene.method), plan.denominator),
                 scene.canvas},
        .exactness = exactness()};
    if (scene.has_depth_buffer())
        target.depth.emplace(plan.stages.depth_region, depth_rule<DepthOf<Scalar>>(scene));
    std::visit(
        [&](const auto& geometry) {
            // All vertices on their way to the screen, then what is drawn between them.
            if constexpr (keeps_steps<Sink>)
                report_geometry(scene, geometry, sink);
            draw_pieces(scene, plan, geometry, target, sink);
        },
        plan.geometry);
    if constexpr (std::same_as<Scalar, Adaptive>)
        if (fallbacks)
            *fallbacks = target.exactness.fallbacks;
    return std::move(target.image);
}

} // namespace rastertrace
