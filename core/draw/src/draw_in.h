// SPDX-License-Identifier: MIT
#pragma once

// Drawing in one kind of number: every primitive in its turn, each piece by draw_piece.h. Compiled once for each kind, in
// draw_in_*.cpp.

#include "directed_line.h"
#include "hidden-lines/owners.h"
#include "tell/listener_sink.h"

#include <rastertrace/core/draw/draw.h>

#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/draw/paint/depth_tests.h>
#include <rastertrace/core/draw/paint/fill.h>
#include <rastertrace/core/draw/paint/piece_in.h>
#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/steps.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace rastertrace {

/// What the drawing of all primitives of a scene shares. Depths are tested by `Tests`.
template <typename Scalar, typename Tests = DepthTests<DepthOf<Scalar>>> struct SceneDrawing {
    const Scene& scene;
    const Plan& plan;
    Image& image;
    SampleGrid<Scalar> grid = sample_grid<Scalar>(scene, plan); ///< of triangles
    SampleOffset<Scalar> line_offset =
        sample_offset<Scalar>(sample_of_lines(scene.method), plan.denominator);
    SampleOffset<Scalar> offset = ///< of primitives that are SampledBy::itself
        sample_offset<Scalar>(sample_of_others(scene.method), plan.denominator);
    Tests* depth = nullptr;              ///< if depths are tested
    Owners<DepthOf<Scalar>> owners = {}; ///< if lines are tested

    const PixelStages& stages_of(std::size_t primitive) const {
        return plan.stages.pixels[primitive];
    }
};

/// Emits PrimitiveBegan.
template <typename Scalar, typename Tests, typename Sink>
void tell_beginning(const Piece<Scalar>& piece, std::string_view name,
                    std::span<const std::string_view> corners,
                    const SceneDrawing<Scalar, Tests>& drawing, Sink&& sink) {
    const Plan& plan = drawing.plan;
    std::vector<std::array<DepthOf<Scalar>, 4>> levels;
    for (const auto& of_corner : piece.levels)
        levels.push_back(of_corner.of);
    const bool is_line = piece.kind == PrimitiveKind::line;
    const Index octant =
        is_line ? octant_of(piece, {0, 1}, drawing.line_offset, drawing.scene.method) : 0;
    sink(PrimitiveBegan<Scalar>{
        .kind = piece.kind,
        .name = name,
        .vertices = corners,
        .at = if_any(piece.corners()),
        .depths = if_any(std::span(piece.depths).first(drawing.depth ? piece.count : 0)),
        .color = piece.color,
        .colors = if_any(std::span(piece.colors).first(plan.mixes_colors ? piece.count : 0)),
        .levels = if_any(levels),
        .octant = octant != 0 ? std::optional(octant) : std::nullopt,
        .part = piece.is_part ? std::optional(true) : std::nullopt,
        .painted =
            plan.stages.pixels[piece.primitive].is_painted ? std::nullopt : std::optional(false),
        .radius = radius_of(piece),
        .face = if_any(drawing.scene.face_of(drawing.scene.primitives[piece.primitive]))});
}

/// Draws a piece (draw_piece.h).
template <typename Scalar, typename Tests, typename Sink>
void draw_piece(const Piece<Scalar>& piece, SceneDrawing<Scalar, Tests>& drawing, const Sink& sink);

/// Emits what is known of a piece, and draws it. `of_pixels` is the sink of its drawing.
template <typename AList, typename AFace, typename Scalar, typename Tests, typename Sink>
void tell_and_draw(const AList& list, const ScreenPrimitive& one, const AFace& face,
                   const Piece<Scalar>& piece, SceneDrawing<Scalar, Tests>& drawing,
                   const Listener& listener, const Sink& of_pixels) {
    const PieceNames names(drawing.scene, list,
                           one); // a listener may refer to them until the piece ends
    const ListenerSink sink(listener);
    tell_beginning(piece, names.piece, names.corners, drawing, sink);
    tell_face(face, sink);
    if (!piece.is_skipped)
        draw_piece(piece, drawing, of_pixels);
}

/// Draws the list. `sink` is that of pixels.
template <typename Scalar, typename AList, typename Sink>
void draw_list(const AList& list, SceneDrawing<Scalar>& drawing, const Listener& listener,
               const Sink& sink) {
    const Scene& scene = drawing.scene;
    const Plan& plan = drawing.plan;
    if constexpr (!std::same_as<AList, TypedVertices>)
        drawing.owners = {
            .primitive_of = [&](std::uint32_t owner) { return list.primitives[owner].primitive; },
            .triangle_of =
                [&](std::uint32_t owner) {
                    const auto piece = piece_of(scene, list, list.primitives[owner]);
                    return corners_of(piece_in<Scalar>(piece, plan));
                }};
    // The owner of a depth is an index in the list. Vertices as typed have no depths.
    const auto begin = [&]([[maybe_unused]] const ScreenPrimitive& one) {
        if constexpr (!std::same_as<AList, TypedVertices>)
            if (drawing.depth)
                drawing.depth->begin(static_cast<std::uint32_t>(&one - list.primitives.data()));
    };
    if (!listener.takes_nothing())
        tell_all_pieces(scene, list, listener, [&](const ScreenPrimitive& one, const auto& face) {
            const auto piece = piece_in<Scalar>(piece_of(scene, list, one), plan);
            begin(one);
            tell_and_draw(list, one, face, piece, drawing, listener, sink);
        });
    else
        for (std::size_t place = 0; place < count_of(scene, list); ++place) {
            const ScreenPrimitive& one = nth_of(scene, list, place);
            auto piece = piece_of(scene, list, one);
            begin(one);
            if (!piece.is_skipped)
                draw_piece(piece_in<Scalar>(std::move(piece), plan), drawing, sink);
        }
}

/// Draws a scene with the numbers that its plan has chosen.
template <typename Scalar>
Image draw_in(const Scene& scene, const Plan& plan, const Listener& listener, Fallbacks*) {
    Image image(scene.canvas);
    SceneDrawing<Scalar> drawing{scene, plan, image};
    std::optional<DepthTests<DepthOf<Scalar>>> depth;
    if (scene.has_depth_buffer())
        drawing.depth = &depth.emplace(plan.stages.depth_region, depth_rule<DepthOf<Scalar>>(scene),
                                       scene.has_tested_lines());

    // First the steps of all vertices, then the primitives.
    const auto draw_all = [&]<typename AList>(const AList& list) {
        if constexpr (draws<Scalar, AList>) {
            if constexpr (!std::same_as<AList, TypedVertices>)
                tell_geometry(scene, list, listener);
            if (listener.takes_pixels())
                draw_list(list, drawing, listener, ListenerSink(listener));
            else
                draw_list(list, drawing, listener, SkipSink(listener));
        }
    };
    std::visit(draw_all, *plan.list);
    return image;
}

} // namespace rastertrace
