// SPDX-License-Identifier: MIT
#pragma once

// Drawing in one kind of number: every primitive in its turn, by the method that the scene names.
// Compiled once for each kind, in draw_in_*.cpp.

#include "listener_sink.h"

#include <rastertrace/core/draw.h>

#include <rastertrace/core/adaptive.h>
#include <rastertrace/core/adaptive_depth.h>
#include <rastertrace/core/depth.h>
#include <rastertrace/core/exactly.h>
#include <rastertrace/core/fill.h>
#include <rastertrace/core/flat_painter.h>
#include <rastertrace/core/image.h>
#include <rastertrace/core/line_bresenham.h>
#include <rastertrace/core/line_lerp.h>
#include <rastertrace/core/mixed_colors.h>
#include <rastertrace/core/pieces.h>
#include <rastertrace/core/placed.h>
#include <rastertrace/core/plan.h>
#include <rastertrace/core/row_painter.h>
#include <rastertrace/core/sample_walk.h>
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

/// What pixels are drawn on and tested against, and where their samples lie.
template <typename Scalar, typename OfPixels = Scalar> struct Target {
    Image& image;
    SampleGrid<Scalar> grid;
    DepthBuffer<DepthOf<OfPixels>>* depth = nullptr; ///< if depths are tested
    Exactness* exactness = nullptr;                  ///< of `adaptive`
};

/// The sink that tells a listener; none keeps none.
template <typename Sink> Sink sink_to(const Listener& listener) {
    if constexpr (keeps_steps<Sink>)
        return ListenerSink(listener);
    else
        return {};
}

/// Draws the line between two vertices of a primitive.
template <typename Scalar, typename Sink>
void draw_line(const PlacedPrimitive<Scalar>& primitive, EdgeName side, const Method& method,
               const Canvas& canvas, Sink&& sink) {
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
        draw_bresenham(line, method.color_lerp, canvas, sink);
    else
        draw_line_by_lerp(segment,
                          method.line == LineMethod::naive ? LineForm::naive : LineForm::dda,
                          line_rounding(method), line, method.color_lerp, canvas, sink);
}

/// Fills a triangle with the stages that its pixels go through.
template <typename Scalar, typename OfPixels, typename Sink>
void fill_triangle(const PlacedPrimitive<Scalar>& primitive, Color flat, const Scene& scene,
                   const Plan& plan, Target<Scalar, OfPixels>& target, const Sink& sink) {
    const Triangle<Scalar> triangle{primitive.positions};
    const auto fill_with = [&](auto&& painter) {
        fill(triangle, primitive.colors, scene.method, target.grid, target.image.canvas(), painter);
    };

    // What its colors are mixed from. Without area, and where its vertices agree, it has one.
    PixelStages stages = plan.stages.pixels[primitive.number];
    const auto& [a, b, c] = primitive.colors;
    if (plan.mixes_colors && a == b && a == c)
        flat = a;
    std::optional<MixedColors<OfPixels>> mixed;
    if (stages.colors != ColorStage::flat) {
        const Barycentric<Scalar> barycentric(triangle);
        if (barycentric.area2() == scalar_from<Scalar>(0))
            stages.colors = ColorStage::flat;
        else if constexpr (std::same_as<OfPixels, Adaptive>)
            mixed = mixed_colors(primitive, stages.colors, *target.exactness);
        else
            mixed = {primitive.colors, barycentric, target.grid.sample_offset(),
                     primitive.inverse_w};
    }

    // The plain loop, if that is all.
    if constexpr (!keeps_steps<Sink>)
        if (stages.colors == ColorStage::flat && !stages.tests_depth)
            return fill_with(FlatPainter<>(target.image, flat, {}, stages.tests_canvas));

    PixelPainter<OfPixels, Sink> pixels{.image = target.image,
                                        .stages = stages,
                                        .flat = flat,
                                        .mixed = mixed ? &*mixed : nullptr,
                                        .buffer = stages.tests_depth ? target.depth : nullptr,
                                        .sink = sink};
    using Painter = RowPainter<Scalar, OfPixels, Sink>;
    if (!stages.tests_depth)
        return fill_with(Painter(pixels));
    TriangleDepth<DepthOf<Scalar>> depth(depth_positions(triangle), primitive.depths,
                                         target.depth->larger_passes());
    if (scene.method.fill != Fill::top_left)
        return fill_with(Painter(pixels, depth));
    const auto plane = depth.plane(depth_scalar(target.grid.sample_offset()));
    fill_with(Painter(pixels, plane));
}

/// Draws a primitive, or a part of one, that lies where `primitive` says.
template <typename Coordinate, typename Scalar, typename OfPixels, typename Sink>
void draw_piece(const Piece<Coordinate>& piece, const PlacedPrimitive<Scalar>& primitive,
                const Scene& scene, const Plan& plan, Target<Scalar, OfPixels>& target,
                Sink&& sink) {
    const Method& method = scene.method;
    const Canvas& canvas = target.image.canvas();
    const FlatPainter painter(target.image, piece.color, sink);
    const bool is_tested = target.depth && piece.kind == PrimitiveKind::triangle;
    const auto pixel_of = [&primitive](std::size_t corner) {
        return nearest_pixel(primitive.positions[corner].x, primitive.positions[corner].y);
    };
    const auto tell_beginning = [&]<typename Told>(const PlacedPrimitive<Told>& told) {
        sink(PrimitiveBegan<Told>{
            .kind = piece.kind,
            .name = piece.name,
            .vertices = std::span(primitive.names).first(primitive.count),
            .positions = std::span(told.positions).first(primitive.count),
            .color = piece.color,
            .colors = std::span(primitive.colors).first(plan.mixes_colors ? primitive.count : 0),
            .octant = piece.kind == PrimitiveKind::line ? octant_of(pixel_of(0), pixel_of(1)) : 0,
            .is_part = piece.is_part,
            .depths = std::span(told.depths).first(is_tested ? primitive.count : 0)});
    };
    // The corners of `adaptive` are told as what they stand for: all decisions are about those.
    if constexpr (std::same_as<Scalar, Adaptive> && keeps_steps<Sink>)
        tell_beginning(target.exactness->pieces.placed(target.exactness->drawn.back()));
    else
        tell_beginning(primitive);
    if constexpr (!std::same_as<Coordinate, Number>)
        if (!report_face(piece.face, sink))
            return;

    switch (piece.kind) {
    case PrimitiveKind::point:
        draw_point(pixel_of(0), primitive.colors[0], canvas, painter);
        break;
    case PrimitiveKind::line:
        draw_line(primitive, {0, 1}, method, canvas, painter);
        break;
    case PrimitiveKind::outline:
        for (const EdgeName side : {EdgeName{0, 1}, EdgeName{1, 2}, EdgeName{2, 0}}) {
            sink(SideBegan{.edge = side,
                           .octant = octant_of(pixel_of(side.from), pixel_of(side.to))});
            draw_line(primitive, side, method, canvas, painter);
        }
        break;
    case PrimitiveKind::triangle:
        fill_triangle(primitive, piece.color, scene, plan, target, sink);
        break;
    }
}

/// Draws all pieces of the scene.
template <typename Scalar, typename AGeometry, typename Sink>
void draw_pieces(const Scene& scene, const Plan& plan, const AGeometry& geometry,
                 Target<Scalar>& target, const Listener& listener, Sink&& sink) {
    for_each_piece(
        scene, geometry,
        [&]<typename Coordinate>(const Piece<Coordinate>& piece) {
            if constexpr (draws<Scalar, Coordinate>)
                draw_piece(piece, placed<Scalar>(piece, plan), scene, plan, target, sink);
        },
        listener);
}

/// Draws them with doubles that know their error. A piece of which these leave a decision open is drawn
/// once more with exact numbers: up to there it comes out as before, so its steps are not told again.
template <typename AGeometry, typename Sink>
void draw_pieces(const Scene& scene, const Plan& plan, const AGeometry& geometry,
                 Target<Adaptive>& target, const Listener& listener, const Sink&) {
    Exactness& exactness = *target.exactness;
    Target<Rational, Adaptive> exact_target{target.image, sample_grid<Rational>(scene, plan),
                                            target.depth, &exactness};
    if (target.depth)
        target.depth->ask(
            [&](auto... asked) { return is_nearer(scene, plan, exactness, asked...); },
            [&](auto... asked) { return told_depth(scene, exactness, asked...); });

    // What could not be decided is told, and done again.
    const auto decide = [&](auto& resumed, auto&& draw_it, auto&& draw_it_exactly) {
        try {
            draw_it();
            return;
        } catch (const Undecided& undecided) {
            listener(BoundExceeded{.difference = undecided.difference, .error = undecided.error});
        }
        resumed.pass_over_what_came();
        draw_it_exactly();
    };

    // Without a listener there is nothing to pass on.
    const auto resumed = [](ResumedListener& steps) {
        return keeps_steps<Sink> ? Listener(steps) : Listener();
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
                if (target.depth)
                    target.depth->begin(static_cast<std::uint32_t>(exactness.drawn.size() - 1));
                ResumedListener steps_of_piece(listener);
                const Listener of_piece = resumed(steps_of_piece);
                const Sink sink = sink_to<Sink>(of_piece);
                decide(
                    steps_of_piece,
                    [&] {
                        draw_piece(piece, placed<Adaptive>(piece, plan), scene, plan, target, sink);
                    },
                    [&] {
                        ++exactness.fallbacks.primitives;
                        PlacedPrimitive<Rational> exact =
                            exactness.pieces.placed(exactness.drawn.back());
                        exact.names = piece.names;
                        draw_piece(piece, exact, scene, plan, exact_target, sink);
                    });
            }
        };
        // Which pieces it has may be left open, too.
        ResumedListener steps_of_primitive(listener);
        const Listener of_primitive = resumed(steps_of_primitive);
        decide(
            steps_of_primitive,
            [&] { visit_pieces(scene, geometry, number, mixes_colors, of_primitive, draw_one); },
            [&] {
                part = 0;
                exactness.pieces.visit(number, of_primitive, draw_one);
            });
    }
    if (target.depth)
        exactness.fallbacks.depths = target.depth->exact_tests();
}

/// Draws a scene with the numbers that its plan has chosen, with a sink or without one.
template <typename Scalar, typename Sink>
Image draw_with(const Scene& scene, const Plan& plan, const Listener& listener, const Sink& sink,
                Fallbacks* fallbacks) {
    Image image(scene.canvas);
    Target<Scalar> target{image, sample_grid<Scalar>(scene, plan)};
    std::optional<DepthBuffer<DepthOf<Scalar>>> depth;
    if (scene.has_depth_buffer())
        target.depth = &depth.emplace(plan.stages.depth_region, depth_rule<DepthOf<Scalar>>(scene));
    std::optional<Exactness> exactness;
    if constexpr (std::same_as<Scalar, Adaptive>)
        target.exactness = &exactness.emplace(Exactness{
            ExactPieces(scene, plan), scalar_from<Rational>(sample_offset_of(scene.method))});
    std::visit(
        [&](const auto& geometry) {
            // All vertices on their way to the screen, then what is drawn between them.
            tell_geometry(scene, geometry, listener);
            draw_pieces(scene, plan, geometry, target, listener, sink);
        },
        plan.geometry);
    if (fallbacks && exactness)
        *fallbacks = exactness->fallbacks;
    return image;
}

template <typename Scalar>
Image draw_in(const Scene& scene, const Plan& plan, const Listener& listener,
              Fallbacks* fallbacks) {
    if (listener.takes_nothing())
        return draw_with<Scalar>(scene, plan, listener, NullSink{}, fallbacks);
    return draw_with<Scalar>(scene, plan, listener, ListenerSink(listener), fallbacks);
}

} // namespace rastertrace
