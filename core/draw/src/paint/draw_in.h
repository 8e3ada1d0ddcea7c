// SPDX-License-Identifier: MIT
#pragma once

// Drawing in one kind of number: every primitive in its turn, by the method that the scene names.
// Compiled once for each kind, in draw_in_*.cpp.

#include "hidden-lines/line_painter.h"
#include "paint/target.h"
#include "tell/listener_sink.h"

#include <rastertrace/core/draw/draw.h>

#include <rastertrace/core/draw/filtered/adaptive.h>
#include <rastertrace/core/draw/filtered/adaptive_depth.h>
#include <rastertrace/core/draw/filtered/exactly.h>
#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/draw/paint/fill.h>
#include <rastertrace/core/draw/paint/piece_in.h>
#include <rastertrace/core/draw/paint/row_painter.h>
#include <rastertrace/core/draw/paint/sample_walk.h>
#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/raster/depth.h>
#include <rastertrace/core/raster/flat_painter.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/line_bresenham.h>
#include <rastertrace/core/raster/line_lerp.h>
#include <rastertrace/core/raster/mixed_colors.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/steps.h>
#include <rastertrace/core/raster/triangle.h>

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace rastertrace {

/// The sink that tells a listener; none keeps none.
template <typename Sink> Sink sink_to(const Listener& listener) {
    if constexpr (keeps_steps<Sink>)
        return ListenerSink(listener);
    else
        return {};
}

/// The line between two vertices of a primitive, from the end at which it is drawn first: its true ends, and
/// the pixels nearest to them.
template <typename Scalar> struct DirectedLine {
    Segment<Scalar> segment;
    GridLine pixels;
};

/// With `from: low`, the end that has the lower coordinate along the major axis comes first. Bresenham's line
/// goes from pixel to pixel, and its ends are compared as pixels; the others go along the true line.
template <typename Scalar>
DirectedLine<Scalar> directed_line(const Piece<Scalar>& primitive, EdgeName side,
                                   const Method& method) {
    const Vec<Scalar, 2>& from = primitive.positions[side.from];
    const Vec<Scalar, 2>& to = primitive.positions[side.to];
    // One after the other: of ends that filtered doubles leave open, the first one is told.
    const GridPoint to_pixel = nearest_pixel(to.x, to.y);
    const GridPoint from_pixel = nearest_pixel(from.x, from.y);
    const DirectedLine<Scalar> forward{
        {from, to}, {from_pixel, to_pixel, primitive.colors[side.from], primitive.colors[side.to]}};
    if (method.from == LineStart::first)
        return forward;

    const auto runs_down = [](const auto& a, const auto& b, bool is_x_major) {
        return is_x_major ? b.x < a.x : b.y < a.y;
    };
    const Index columns = std::abs(to_pixel.x - from_pixel.x);
    const Index rows = std::abs(to_pixel.y - from_pixel.y);
    const bool is_reversed = method.line == LineMethod::bresenham
                                 ? runs_down(from_pixel, to_pixel, columns >= rows)
                                 : runs_down(from, to, is_longer_in_x(forward.segment));
    return is_reversed ? DirectedLine<Scalar>{{to, from}, reversed(forward.pixels)} : forward;
}

/// The octant in which it is drawn.
template <typename Scalar>
int octant_of(const Piece<Scalar>& primitive, EdgeName side, const Method& method) {
    const GridLine line = directed_line(primitive, side, method).pixels;
    return octant_of(line.from, line.to);
}

/// Draws the line between two vertices of a primitive; false if it has no pixel to draw.
template <typename Scalar, typename Sink>
bool draw_line(const Piece<Scalar>& primitive, EdgeName side, const Method& method,
               const Canvas& canvas, Sink&& sink) {
    const auto [segment, pixels] = directed_line(primitive, side, method);
    if (method.line == LineMethod::bresenham)
        return draw_bresenham(pixels, line_rules(method), canvas, sink);
    return draw_line_by_lerp(segment,
                             method.line == LineMethod::naive ? LineForm::naive : LineForm::dda,
                             line_rounding(method), pixels, line_rules(method), canvas, sink);
}

/// Doubles can tell the depths along an edge only if they hold the difference of its ends, with some to spare
/// for what is rounded.
inline void require_finite_differences(const std::array<Adaptive, 3>& depths) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i)
        if (!std::isfinite(2 * (depths[i].value() - depths[(i + 1) % 3].value())))
            Adaptive::leave_open(infinity, infinity);
}

/// All that is worked out about a triangle before it is filled: what its pixels go through, what their
/// colors are mixed from, and how deep they lie.
template <typename Scalar, typename OfPixels> class TrianglePaint {
public:
    TrianglePaint(const Piece<Scalar>& primitive, const Scene& scene, const Plan& plan,
                  const Target<Scalar, OfPixels>& target)
        : stages_(plan.stages.pixels[primitive.primitive]), flat_(primitive.color),
          depth_at_(scene.method.depth_at) {
        // Without area, and where its vertices agree, it has one color.
        const Triangle<Scalar> triangle{primitive.positions};
        const auto& [a, b, c] = primitive.colors;
        if (a == b && a == c)
            flat_ = a;
        if (stages_.colors != ColorStage::flat) {
            const Barycentric<Scalar> barycentric(triangle);
            if (barycentric.area2() == scalar_from<Scalar>(0))
                stages_.colors = ColorStage::flat;
            else if constexpr (std::same_as<OfPixels, Adaptive>)
                mixed_ = mixed_colors(primitive, stages_.colors, scene.method.color_rounding,
                                      *target.exactness);
            else
                mixed_ = {primitive.colors, barycentric, target.grid.sample_offset(),
                          primitive.inverse_w, scene.method.color_rounding};
        }
        if (!stages_.tests_depth)
            return;
        depth_.emplace(depth_positions(triangle), primitive.depths, target.depth->larger_passes());
        const DepthForm form = depth_form_of(scene.method.fill);
        if (form == DepthForm::plane)
            plane_ = depth_->plane(depth_scalar(target.grid.sample_offset()));
        if constexpr (std::same_as<Scalar, Adaptive>)
            if (form == DepthForm::along_edges)
                require_finite_differences(primitive.depths);
    }

    /// Calls `fill_with(painter)`.
    template <typename Sink, typename FillWith>
    void with_painter(Target<Scalar, OfPixels>& target, const Sink& sink, FillWith&& fill_with) {
        // The plain loop, if that is all.
        if constexpr (!keeps_steps<Sink>) {
            if (!stages_.is_painted && !stages_.tests_depth)
                return;
            if (stages_.colors == ColorStage::flat && !stages_.tests_depth)
                return fill_with(FlatPainter<>(target.image, flat_, {}, stages_.tests_canvas));
        }

        PixelPainter<OfPixels, Sink> pixels{.image = target.image,
                                            .stages = stages_,
                                            .flat = flat_,
                                            .mixed = mixed_ ? &*mixed_ : nullptr,
                                            .buffer = stages_.tests_depth ? target.depth : nullptr,
                                            .depth_at = depth_at_,
                                            .sink = sink};
        using Painter = RowPainter<Scalar, OfPixels, Sink>;
        fill_with(plane_   ? Painter(pixels, *plane_)
                  : depth_ ? Painter(pixels, *depth_)
                           : Painter(pixels));
    }

private:
    PixelStages stages_;
    Color flat_;
    DepthAt depth_at_;
    std::optional<MixedColors<OfPixels>> mixed_;
    std::optional<TriangleDepth<DepthOf<Scalar>>> depth_;
    std::optional<DepthPlane<DepthOf<Scalar>>> plane_;
};

/// Draws what is no triangle: a point, a line, or the three lines of an outline. `painter_of(side)` makes the
/// painter of each; a point's side leads from its corner to itself.
template <typename Scalar, typename PainterOf>
void draw_lines(const Piece<Scalar>& primitive, const Method& method, const Canvas& canvas,
                PainterOf&& painter_of) {
    switch (primitive.kind) {
    case PrimitiveKind::point:
        return draw_point(nearest_pixel(primitive.positions[0].x, primitive.positions[0].y),
                          primitive.colors[0], canvas, painter_of(EdgeName{0, 0}));
    case PrimitiveKind::line: {
        auto&& painter = painter_of(EdgeName{0, 1});
        if (!draw_line(primitive, {0, 1}, method, canvas, painter))
            painter(PrimitiveSkipped{.why = SkipReason::last_pixel_only});
        return;
    }
    case PrimitiveKind::outline: {
        bool has_pixels = false;
        for (const EdgeName side : {EdgeName{0, 1}, EdgeName{1, 2}, EdgeName{2, 0}}) {
            auto&& painter = painter_of(side);
            painter(SideBegan{.edge = side, .octant = octant_of(primitive, side, method)});
            has_pixels = draw_line(primitive, side, method, canvas, painter) || has_pixels;
            if (side.to == 0 && !has_pixels)
                painter(PrimitiveSkipped{.why = SkipReason::last_pixel_only});
        }
        return;
    }
    case PrimitiveKind::triangle:
        break;
    }
}

/// Tells that a piece begins. `told` are its corners in the numbers that they are told in.
template <typename Scalar, typename Told, typename Sink>
void tell_beginning(const Piece<Scalar>& piece, const PieceNames& names, const Piece<Told>& told,
                    bool has_depths, const Scene& scene, const Plan& plan, Sink&& sink) {
    sink(PrimitiveBegan<Told>{
        .kind = piece.kind,
        .name = names.piece,
        .vertices = std::span(names.corners).first(piece.count),
        .positions = std::span(told.positions).first(piece.count),
        .color = piece.color,
        .colors = std::span(piece.colors).first(plan.mixes_colors ? piece.count : 0),
        .octant = piece.kind == PrimitiveKind::line ? octant_of(piece, {0, 1}, scene.method) : 0,
        .is_part = piece.is_part,
        .depths = std::span(told.depths).first(has_depths ? piece.count : 0),
        .is_painted = plan.stages.pixels[piece.primitive].is_painted});
}

/// Draws a point, a line or an outline, tested against the depth buffer or not.
template <typename Scalar, typename OfPixels, typename Sink>
void draw_thin(const Piece<Scalar>& piece, const Scene& scene, const Plan& plan,
               Target<Scalar, OfPixels>& target, const Sink& sink) {
    const Canvas& canvas = target.image.canvas();
    if (!plan.stages.pixels[piece.primitive].tests_depth)
        return draw_lines(piece, scene.method, canvas,
                          [&](EdgeName) { return FlatPainter(target.image, piece.color, sink); });
    draw_lines(piece, scene.method, canvas, [&](EdgeName side) {
        target.begin_side(side);
        return LinePainter<Scalar, OfPixels, Sink>(piece, side, scene, target, sink);
    });
}

/// Draws a primitive, or a part of one, with its numbers ready to draw.
template <typename Scalar, typename OfPixels, typename Sink>
void draw_piece(const Piece<Scalar>& piece, const Scene& scene, const Plan& plan,
                Target<Scalar, OfPixels>& target, const Sink& sink) {
    const Canvas& canvas = target.image.canvas();
    if (piece.kind == PrimitiveKind::triangle)
        TrianglePaint<Scalar, OfPixels>(piece, scene, plan, target)
            .with_painter(target, sink, [&](const auto& painter) {
                fill(Triangle<Scalar>{piece.positions}, piece.colors, scene.method, target.grid,
                     canvas, painter);
            });
    else
        draw_thin(piece, scene, plan, target, sink);
}

/// Tells of a piece. The corners of `adaptive` are told as what they stand for: all decisions are about
/// those.
template <typename AFace, typename Scalar, typename OfPixels, typename Sink>
void tell_piece(const PieceNames& names, const AFace& face, const Piece<Scalar>& piece,
                const Scene& scene, const Plan& plan, const Target<Scalar, OfPixels>& target,
                const Sink& sink) {
    const bool has_depths = target.depth != nullptr;
    bool is_told = false;
    if constexpr (std::same_as<Scalar, Adaptive>)
        if (sink.reads_corners()) {
            const auto exact = target.exactness->pieces.piece(target.exactness->drawn.back());
            tell_beginning(piece, names, exact, has_depths, scene, plan, sink);
            is_told = true;
        }
    if (!is_told)
        tell_beginning(piece, names, piece, has_depths, scene, plan, sink);
    tell_face(face, sink);
}

/// Tells of a piece and draws it.
template <typename AList, typename AFace, typename Scalar, typename OfPixels, typename Sink>
void tell_and_draw(const AList& list, const ScreenPrimitive& one, const AFace& face,
                   const Piece<Scalar>& piece, const Scene& scene, const Plan& plan,
                   Target<Scalar, OfPixels>& target, const Sink& sink) {
    const PieceNames names(scene, list, one); // a listener may refer to them until the piece ends
    tell_piece(names, face, piece, scene, plan, target, sink);
    if (!piece.is_skipped)
        draw_piece(piece, scene, plan, target, sink);
}

/// A triangle of the list, in the numbers that depths are tested in.
template <typename Scalar, typename Coordinate>
DeepTriangle<DepthOf<Scalar>> triangle_in(const Scene& scene, const ScreenList<Coordinate>& list,
                                          const ScreenPrimitive& one, const Plan& plan) {
    using D = DepthOf<Scalar>;
    DeepTriangle<D> triangle;
    for (std::size_t i = 0; i < 3; ++i) {
        const ScreenVertex<Coordinate>& corner = list.vertices[corner_in_list(scene, list, one, i)];
        triangle[i].at = {depth_scalar(on_grid<Scalar>(corner.position.x, plan)),
                          depth_scalar(on_grid<Scalar>(corner.position.y, plan))};
        if constexpr (std::same_as<D, Adaptive>)
            triangle[i].depth = with_error(corner.depth);
        else if constexpr (std::constructible_from<D, Coordinate>)
            triangle[i].depth = D(corner.depth);
    }
    return triangle;
}

/// Draws the list.
template <typename Scalar, typename AList, typename Sink>
void draw_list(const Scene& scene, const Plan& plan, const AList& list, Target<Scalar>& target,
               const Listener& listener, const Sink& sink) {
    if constexpr (!std::same_as<AList, TypedVertices>) {
        target.listed = list.primitives;
        target.triangle_of = [&](std::uint32_t owner) {
            return triangle_in<Scalar>(scene, list, list.primitives[owner], plan);
        };
    }
    const auto begin = [&target](const ScreenPrimitive& one) {
        if (target.depth)
            target.depth->begin(static_cast<std::uint32_t>(&one - target.listed.data()));
    };
    if constexpr (keeps_steps<Sink>)
        tell_all_pieces(scene, list, listener, [&](const ScreenPrimitive& one, const auto& face) {
            const auto piece = piece_in<Scalar>(piece_of(scene, list, one), plan);
            begin(one);
            tell_and_draw(list, one, face, piece, scene, plan, target, sink);
        });
    else
        for_each_primitive(scene, list, [&](const ScreenPrimitive& one) {
            const auto piece = piece_of(scene, list, one);
            begin(one);
            if (!piece.is_skipped)
                draw_piece(piece_in<Scalar>(piece, plan), scene, plan, target, sink);
        });
}

/// Draws a scene with the numbers that its plan has chosen, with a sink or without one.
template <typename Scalar, typename Sink>
Image draw_with(const Scene& scene, const Plan& plan, const Listener& listener, const Sink& sink,
                Fallbacks* fallbacks) {
    Image image(scene.canvas);
    Target<Scalar> target{image, sample_grid<Scalar>(scene, plan)};
    std::optional<DepthBuffer<DepthOf<Scalar>>> depth;
    if (scene.has_depth_buffer())
        target.depth = &depth.emplace(plan.stages.depth_region, depth_rule<DepthOf<Scalar>>(scene),
                                      scene.has_tested_lines());
    std::optional<Exactness> exactness;
    if constexpr (std::same_as<Scalar, Adaptive>)
        target.exactness = &exactness.emplace(Exactness{
            ExactPieces(scene, plan), scalar_from<Rational>(sample_offset_of(scene.method))});
    std::visit(
        [&]<typename AList>(const AList& list) {
            // All vertices on their way to the screen, then what is drawn between them.
            if constexpr (draws<Scalar, AList>) {
                if constexpr (!std::same_as<AList, TypedVertices>)
                    tell_geometry(scene, list, listener);
                draw_list(scene, plan, list, target, listener, sink);
            }
        },
        *plan.list);
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
