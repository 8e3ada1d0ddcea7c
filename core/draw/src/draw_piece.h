// SPDX-License-Identifier: MIT
#pragma once

// Drawing a piece in one kind of number, by the method that the scene names. Compiled once for each kind, in draw_in_*.cpp.

#include "draw_in.h"
#include "hidden-lines/line_painter.h"

#include <rastertrace/core/draw/paint/fill.h>
#include <rastertrace/core/draw/paint/row_painter.h>
#include <rastertrace/core/draw/paint/sample_walk.h>
#include <rastertrace/core/raster/circle.h>
#include <rastertrace/core/raster/depth_interpolation.h>
#include <rastertrace/core/raster/fill_edge_table.h>
#include <rastertrace/core/raster/flat_painter.h>
#include <rastertrace/core/raster/line_bresenham.h>
#include <rastertrace/core/raster/line_dda.h>
#include <rastertrace/core/raster/line_diamond_exit.h>
#include <rastertrace/core/raster/line_naive.h>
#include <rastertrace/core/raster/mixed_colors.h>
#include <rastertrace/core/raster/triangle.h>

#include <array>
#include <concepts>
#include <optional>

namespace rastertrace {

/// Draws the line between two vertices of a primitive. Returns false if the line has no pixel.
template <typename Scalar, typename Sink>
bool draw_line(const Piece<Scalar>& primitive, EdgeName side, const SampleOffset<Scalar>& offset,
               const Scene& scene, Sink&& sink) {
    const Method& method = scene.method;
    const Canvas& canvas = scene.canvas;
    const DirectedLine<Scalar> line = directed_line(primitive, side, offset, method);
    const LineColors colors = line_colors(line, side, primitive, offset, scene);
    const Segment<Scalar>& segment = line.segment;
    GridLine pixels = line.pixels;
    pixels.colors = colors ? &colors : nullptr;
    const LineSampling sampling{line_rounding(method), pixels, line_rules(method)};
    switch (method.line) {
    case LineMethod::naive:
        return draw_naive_line(segment, offset, sampling, canvas, sink);
    case LineMethod::dda:
        return draw_dda_line(segment, offset, sampling, canvas, sink);
    case LineMethod::bresenham:
        return draw_bresenham(pixels, line_rules(method), canvas, sink);
    case LineMethod::diamond_exit:
        return draw_diamond_exit_line(segment, offset, sampling, canvas, sink);
    }
    not_an_enumerator();
}

/// What is computed once per triangle before it is filled: the stages of its pixels, their colors,
/// and their depths. It makes the painter of the triangle.
template <typename Scalar, typename Tests> class TrianglePaint {
public:
    TrianglePaint(const Piece<Scalar>& primitive, const SceneDrawing<Scalar, Tests>& drawing)
        : stages_(drawing.stages_of(primitive.primitive)), flat_(primitive.color) {
        const Method& method = drawing.scene.method;
        // A triangle has one color if it has no area, or if its vertices have one color.
        const Triangle<Scalar> triangle{primitive.positions};
        const auto& [a, b, c] = primitive.colors;
        if (a == b && a == c && primitive.levels.empty())
            flat_ = a;
        if (stages_.colors != ColorStage::flat) {
            const Barycentric<Scalar> barycentric(triangle);
            if (barycentric.area2() == scalar_from<Scalar>(0))
                stages_.colors = ColorStage::flat;
            else
                mixed_ = {primitive.colors, barycentric, drawing.grid.offset(), primitive.inverse_w,
                          method.color_rounding};
        }
        if (mixed_ && !primitive.levels.empty())
            mixed_->levels = {primitive.levels[0], primitive.levels[1], primitive.levels[2]};
        if (mixed_ && method.fill == Fill::fan && drawing.scene.color_lerp() == ColorLerp::space)
            of_fan_ = [this](GridPoint at, Index, Index) {
                const Pixel pixel{static_cast<int>(at.x), static_cast<int>(at.y)};
                return stages_.colors == ColorStage::perspective
                           ? mixed_->template at<true>(pixel)
                           : mixed_->template at<false>(pixel);
            };
        if (!stages_.tests_depth)
            return;
        depth_.emplace(depth_positions(triangle), primitive.depths, drawing.depth->larger_passes());
        if (traits_of(method.fill).depths == DepthForm::plane)
            plane_ = depth_->plane(depth_offset(drawing));
    }

    TrianglePaint(const TrianglePaint&) = delete;
    TrianglePaint& operator=(const TrianglePaint&) = delete;

    /// The colors of a fan's pixels in space; nullptr of all others.
    const LineColors* of_fan() const { return of_fan_ ? &of_fan_ : nullptr; }

    /// True if FlatPainter paints it: one color, no depths.
    bool is_flat() const { return stages_.colors == ColorStage::flat && !stages_.tests_depth; }

    /// True if PlanePainter paints it: one color, depths in a plane, and no lines are tested.
    bool is_flat_in_plane(const SceneDrawing<Scalar, Tests>& drawing) const {
        return stages_.colors == ColorStage::flat && stages_.is_painted && plane_ &&
               !drawing.depth->has_owners();
    }

    /// False if its pixels are neither painted nor tested.
    bool has_work() const { return stages_.is_painted || stages_.tests_depth; }

    template <typename Sink = NullSink>
    FlatPainter<Sink> flat_painter(Image& image, const Sink& sink = {}) const {
        return FlatPainter<Sink>(image, flat_, sink, stages_.tests_canvas);
    }

    template <typename Sink>
    PlanePainter<Scalar, Sink> plane_painter(const SceneDrawing<Scalar, Tests>& drawing,
                                             const Sink& sink) const {
        return {drawing.image, flat_, *plane_, *drawing.depth, stages_.tests_canvas, sink};
    }

    template <typename Sink>
    RowPainter<Scalar, Tests, Sink> row_painter(const SceneDrawing<Scalar, Tests>& drawing,
                                                const Sink& sink) {
        return {.image = drawing.image,
                .stages = stages_,
                .flat = flat_,
                .mixed = mixed_ ? &*mixed_ : nullptr,
                .tests = stages_.tests_depth ? drawing.depth : nullptr,
                .plane = plane_ ? &*plane_ : nullptr,
                .triangle = depth_ ? &*depth_ : nullptr,
                .depth_at = drawing.scene.method.depth_at,
                .offset =
                    stages_.tests_depth ? depth_offset(drawing) : SampleOffset<DepthOf<Scalar>>(),
                .sink = sink};
    }

private:
    static SampleOffset<DepthOf<Scalar>> depth_offset(const SceneDrawing<Scalar, Tests>& drawing) {
        const SampleOffset<Scalar>& offset = drawing.grid.offset();
        return {depth_scalar(offset.x()), depth_scalar(offset.y())};
    }

    PixelStages stages_;
    Color flat_;
    std::optional<MixedColors<Scalar>> mixed_;
    LineColors of_fan_;
    std::optional<TriangleDepth<DepthOf<Scalar>>> depth_;
    std::optional<DepthPlane<DepthOf<Scalar>>> plane_;
};

/// Draws a point, a line, a circle, or the three lines of an outline. `painter_of(side)` makes the
/// painter of each. The side of a point, or of a circle, leads from its corner to itself.
template <typename Scalar, typename Tests, typename PainterOf>
void draw_lines(const Piece<Scalar>& primitive, const SceneDrawing<Scalar, Tests>& drawing,
                PainterOf&& painter_of) {
    const Method& method = drawing.scene.method;
    const Canvas& canvas = drawing.scene.canvas;
    const SampleOffset<Scalar>& offset = drawing.line_offset;
    const SkipReason no_pixel = traits_of(method.line).rule == LineRule::diamonds
                                    ? SkipReason::leaves_no_diamond
                                    : SkipReason::last_pixel_only;
    const Vec<Scalar, 2>& first = primitive.positions[0];
    switch (primitive.kind) {
    case PrimitiveKind::point:
        return draw_point(nearest_pixel(first, drawing.offset), primitive.colors[0], canvas,
                          painter_of(EdgeName{0, 0}));
    case PrimitiveKind::circle: {
        auto&& painter = painter_of(EdgeName{0, 0});
        if (!draw_circle({nearest_pixel(first, drawing.offset), primitive.radius},
                         primitive.colors[0], canvas, painter))
            painter(PrimitiveSkipped<>{.why = SkipReason::off_canvas});
        return;
    }
    case PrimitiveKind::line: {
        auto&& painter = painter_of(EdgeName{0, 1});
        if (!draw_line(primitive, {0, 1}, offset, drawing.scene, painter))
            painter(PrimitiveSkipped<>{.why = no_pixel});
        return;
    }
    case PrimitiveKind::outline: {
        bool has_pixels = false;
        for (const EdgeName side : {EdgeName{0, 1}, EdgeName{1, 2}, EdgeName{2, 0}}) {
            auto&& painter = painter_of(side);
            painter(
                EdgeSetUp<>{.edge = side, .octant = octant_of(primitive, side, offset, method)});
            has_pixels = draw_line(primitive, side, offset, drawing.scene, painter) || has_pixels;
            if (side.to == 0 && !has_pixels)
                painter(PrimitiveSkipped<>{.why = no_pixel});
        }
        return;
    }
    case PrimitiveKind::triangle:
    case PrimitiveKind::polygon:
        break;
    }
}

/// Fills a polygon. `sink` is its painter.
template <typename Scalar, typename Sink>
void fill_polygon(const Piece<Scalar>& polygon, const SampleOffset<Scalar>& offset,
                  const Method& method, const Canvas& canvas, Sink&& sink) {
    fill_edge_table<Scalar>(polygon.corners(), offset,
                            {.fill_rule = method.fill_rule,
                             .rows = {.lerp = method.lerp,
                                      .span = span_rounding(method),
                                      .rows = method.rows.value_or(RowRule::half_open)},
                             .vertices = method.polygon_vertices},
                            canvas, sink);
}

/// Draws a point, a line or an outline, with or without depth tests.
template <typename Scalar, typename Tests, typename Sink>
void draw_thin(const Piece<Scalar>& piece, SceneDrawing<Scalar, Tests>& drawing, const Sink& sink) {
    const Scene& scene = drawing.scene;
    if (!drawing.stages_of(piece.primitive).tests_depth)
        return draw_lines(piece, drawing,
                          [&](EdgeName) { return FlatPainter(drawing.image, piece.color, sink); });
    draw_lines(piece, drawing, [&](EdgeName side) {
        return LinePainter<Scalar, Tests, Sink>(piece, side, scene, drawing.image, *drawing.depth,
                                                drawing.owners, sink);
    });
}

/// True if somebody takes what a piece without work tells: that it is skipped.
constexpr bool hears_skips(const NullSink&) {
    return false;
}
inline bool hears_skips(const SkipSink& sink) {
    return sink.is_heard();
}

/// Draws a piece.
template <typename Scalar, typename Tests, typename Sink>
void draw_piece(const Piece<Scalar>& piece, SceneDrawing<Scalar, Tests>& drawing,
                const Sink& sink) {
    const Scene& scene = drawing.scene;
    if (piece.kind == PrimitiveKind::polygon)
        return fill_polygon(piece, drawing.offset, scene.method, scene.canvas,
                            FlatPainter(drawing.image, piece.color, sink,
                                        drawing.stages_of(piece.primitive).tests_canvas));
    if (piece.kind != PrimitiveKind::triangle)
        return draw_thin(piece, drawing, sink);
    const Triangle<Scalar> triangle{piece.positions};
    TrianglePaint<Scalar, Tests> paint(piece, drawing);
    if constexpr (!keeps_steps<Sink>) {
        if (!paint.has_work() && !hears_skips(sink))
            return;
        if (paint.has_work() && paint.is_flat())
            return fill(triangle, piece.colors, scene.method, drawing.grid, scene.canvas,
                        paint.flat_painter(drawing.image, sink));
        if constexpr (std::same_as<Tests, DepthTests<DepthOf<Scalar>>> &&
                      std::floating_point<DepthOf<Scalar>>)
            if (scene.method.fill == Fill::top_left && paint.is_flat_in_plane(drawing))
                return fill_top_left(triangle, drawing.grid,
                                     canvas_of_samples(scene.method, scene.canvas),
                                     paint.plane_painter(drawing, sink));
    }
    fill(triangle, piece.colors, scene.method, drawing.grid, scene.canvas,
         paint.row_painter(drawing, sink), paint.of_fan());
}

} // namespace rastertrace
