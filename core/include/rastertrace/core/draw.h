// SPDX-License-Identifier: MIT
#pragma once

// Draws a scene: every primitive in the scene's order, by the method that the scene names.
//
//     const Image picture = draw<double>(scene, plan_for(scene), NullSink{});

#include <rastertrace/core/depth.h>
#include <rastertrace/core/fill_barycentric.h>
#include <rastertrace/core/fill_fan.h>
#include <rastertrace/core/fill_scanline.h>
#include <rastertrace/core/fill_top_left.h>
#include <rastertrace/core/fill_two_halves.h>
#include <rastertrace/core/image.h>
#include <rastertrace/core/line_bresenham.h>
#include <rastertrace/core/line_lerp.h>
#include <rastertrace/core/pieces.h>
#include <rastertrace/core/plan.h>
#include <rastertrace/core/scene.h>
#include <rastertrace/core/sink.h>
#include <rastertrace/core/steps.h>
#include <rastertrace/core/triangle.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

namespace rastertrace {

/// A piece with its numbers ready to draw: the first `count` of each.
template <typename Scalar> struct PlacedPrimitive {
    std::size_t number = 0; ///< its place in the scene
    std::size_t count = 0;
    std::array<std::string_view, 3> names;
    std::array<Vec<Scalar, 2>, 3> positions{};
    std::array<Color, 3> colors; ///< of the vertices; the primitive's where they have none
    std::array<DepthOf<Scalar>, 3> depths{};
    std::array<DepthOf<Scalar>, 3> inverse_w{};
};

/// A coordinate of a vertex as a Scalar, over the plan's denominator if that is a fraction.
template <typename Scalar, typename Coordinate>
Scalar on_grid(const Coordinate& coordinate, const Plan& plan) {
    return written_finer(scalar_from<Scalar>(coordinate, plan.denominator / plan.coarseness),
                         plan.coarseness);
}

/// Coordinates become numbers to calculate with.
template <typename Scalar, typename Coordinate>
PlacedPrimitive<Scalar> placed(const Piece<Coordinate>& piece, const Plan& plan) {
    PlacedPrimitive<Scalar> result{.number = piece.primitive,
                                   .count = piece.count,
                                   .names = piece.names,
                                   .colors = piece.colors};
    for (std::size_t i = 0; i < piece.count; ++i) {
        result.positions[i].x = on_grid<Scalar>(piece.positions[i].x, plan);
        result.positions[i].y = on_grid<Scalar>(piece.positions[i].y, plan);
    }
    using D = DepthOf<Scalar>;
    if constexpr (!std::same_as<Coordinate, Number> && std::constructible_from<D, Coordinate>)
        for (std::size_t i = 0; i < piece.count; ++i) {
            result.depths[i] = D(piece.depths[i]);
            result.inverse_w[i] = D(piece.inverse_w[i]);
        }
    return result;
}

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

/// What pixels are drawn on and tested against, and where their samples lie.
template <typename Scalar> struct Target {
    Image image;
    SampleGrid<Scalar> grid;
    std::optional<DepthBuffer<DepthOf<Scalar>>> depth = {};
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
        if (barycentric.area2() != scalar_from<Scalar>(0))
            mixed = {primitive.colors, barycentric, sample_offset, primitive.inverse_w};
        else
            stages.colors = ColorStage::flat;
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

/// Draws a primitive, or a part of one.
template <typename Scalar, typename Coordinate, typename Sink>
void draw_piece(const Piece<Coordinate>& piece, const Scene& scene, const Plan& plan,
                Target<Scalar>& target, Sink&& sink) {
    const Method& method = scene.method;
    Image& image = target.image;
    const bool is_tested = target.depth && piece.kind == PrimitiveKind::triangle;
    const auto primitive = placed<Scalar>(piece, plan);
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
                              (!std::floating_point<Scalar> && !std::same_as<Coordinate, float>);

/// Draws `scene` and returns its picture, reporting every step to `sink`. The picture is the same
/// whatever the sink. `Scalar` must be the one of the plan (with_scalar finds it), and find_unfit
/// must have found nothing.
template <typename Scalar, typename Sink>
Image draw(const Scene& scene, const Plan& plan, Sink&& sink) {
    Target<Scalar> target{
        .image = Image(scene.canvas),
        .grid = {scalar_from<Scalar>(sample_offset_of(scene.method), plan.denominator),
                 scene.canvas}};
    if (scene.has_depth_buffer())
        target.depth.emplace(plan.stages.depth_region, depth_rule<DepthOf<Scalar>>(scene));
    const auto draw_pieces = [&]<typename Coordinate>(const Piece<Coordinate>& piece) {
        if constexpr (draws<Scalar, Coordinate>)
            draw_piece<Scalar>(piece, scene, plan, target, sink);
    };
    std::visit(
        [&](const auto& geometry) {
            // All vertices on their way to the screen, then what is drawn between them.
            if constexpr (keeps_steps<Sink>)
                report_geometry(scene, geometry, sink);
            for_each_piece(scene, geometry, sink, draw_pieces);
        },
        plan.geometry);
    return std::move(target.image);
}

} // namespace rastertrace
