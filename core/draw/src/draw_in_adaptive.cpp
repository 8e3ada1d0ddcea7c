// SPDX-License-Identifier: MIT
// Drawing with filtered doubles: certify, then draw. All decisions about a piece are taken before
// its first pixel is painted and its first step is emitted. If one is undecided, the piece is drawn
// with rationals instead. An undecided depth test or color is decided exactly for its pixel alone
// (exactly.h).

#include "draw_in.h"
#include "draw_scalar.h"
#include "filtered/sinks.h"

#include <rastertrace/core/draw/filtered/exactly.h>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace rastertrace {

// The drawing with rationals is compiled in draw_in_adaptive_exactly.cpp.
extern template void draw_piece(const Piece<Rational>&, SceneDrawing<Rational, Adaptive>&,
                                const NullSink&);
extern template void draw_piece(const Piece<Rational>&, SceneDrawing<Rational, Adaptive>&,
                                const ListenerSink&);

namespace {

/// Draws the pieces of a scene, with a listener (ListenerSink) or without (NullSink).
template <typename Sink> class AdaptiveDrawing {
public:
    AdaptiveDrawing(SceneDrawing<Adaptive>& filtered, const Listener& listener)
        : scene_(filtered.scene), plan_(filtered.plan),
          filtered_(filtered), exact_{.scene = scene_,
                                      .plan = plan_,
                                      .image = filtered.image,
                                      .depth = filtered.depth,
                                      .exactness = filtered.exactness},
          exactness_(*filtered.exactness), listener_(listener), certifier_(listener),
          certifying_(certifier_) {
        if (filtered.depth)
            filtered.depth->ask(
                [this](auto... asked) { return is_nearer(scene_, plan_, exactness_, asked...); },
                [this](auto... asked) { return told_depth(scene_, exactness_, asked...); });
        exact_.owners = {
            .primitive_of =
                [this](std::uint32_t owner) { return exactness_.drawn[owner].primitive; },
            .hides_exactly = [this](auto... asked) { return hides_exactly(asked...); },
            .begin_side = [this](EdgeName side) { begin_side(side); }};
        filtered_.owners = {.primitive_of = exact_.owners.primitive_of,
                            .hides_exactly =
                                [this](auto... asked) {
                                    ++exactness_.fallbacks.depths;
                                    return hides_exactly(asked...);
                                },
                            .begin_side = exact_.owners.begin_side};
    }

    /// Draws the list.
    void draw(const TypedVertices& typed) {
        for_each_primitive(scene_, typed, [&](const ScreenPrimitive& one) {
            parts_ = 0;
            draw_one(typed, one, NoFace(), listener_);
        });
    }
    template <typename Coordinate> void draw(const ScreenList<Coordinate>& list) {
        listed_ = list.primitives;
        exactness_.drawn.reserve(listed_.size());
        filtered_.owners.triangle_of = [&](std::uint32_t owner) {
            const PieceIndex& index = exactness_.drawn[owner];
            if (!index.listed)
                return corners_of(piece_in<Adaptive>(exactness_.pieces.piece(index), plan_));
            const auto piece = piece_of(scene_, list, list.primitives[*index.listed]);
            return corners_of(piece_in<Adaptive>(piece, plan_));
        };
        const std::span all(list.primitives);
        std::size_t next = 0;
        for (std::size_t turn = 0; turn < scene_.primitives.size(); ++turn) {
            const std::size_t index = primitive_at(list, turn);
            const std::size_t first = next;
            while (next != all.size() && all[next].primitive == index)
                ++next;
            draw(list, index, all.subspan(first, next - first));
        }
    }

private:
    /// Draws a primitive, whose pieces in the list are `pieces`.
    template <typename Coordinate>
    void draw(const ScreenList<Coordinate>& list, std::size_t index,
              std::span<const ScreenPrimitive> pieces) {
        parts_ = 0;
        const auto open = left_open_in(list, index, pieces);
        if (!open)
            return draw_in_turn(list, index, pieces, listener_,
                                [&](auto&&... one) { draw_one(list, one..., listener_); });
        TellingUndecided telling(listener_, *open);
        const Listener told(telling);
        const auto exact = exactness_.pieces.of(index);
        const auto& exact_list = exactness_.pieces.list();
        draw_in_turn(exact_list, index, exact, told,
                     [&](const ScreenPrimitive& one, const auto& face) {
                         if (one.state == ScreenPrimitive::State::part)
                             return draw_one(exact_list, one, face, told);
                         begin(index);
                         draw_exactly(exact_list, one, face, told);
                     });
    }

    /// The undecided comparison of a primitive's face test or clipping, if there is one.
    template <typename Coordinate>
    std::optional<Undecided> left_open_in(const ScreenList<Coordinate>& list, std::size_t index,
                                          std::span<const ScreenPrimitive> pieces) {
        if constexpr (!std::same_as<Coordinate, Adaptive>)
            return std::nullopt;
        else if constexpr (keeps_steps<Sink>)
            if (const auto open = left_open_by([&] {
                    tell_pieces<Adaptive>(scene_, list, index, certifying_, [](const auto&) {});
                }))
                return open;
        const bool is_open =
            !pieces.empty() && pieces.front().state == ScreenPrimitive::State::undecided;
        return is_open ? std::optional(list.undecided[pieces.front().index]) : std::nullopt;
    }

    /// Emits the steps of a primitive, and calls `draw_piece(one, face)` with its pieces.
    template <typename Coordinate, typename DrawPiece>
    void draw_in_turn(const ScreenList<Coordinate>& list, std::size_t index,
                      std::span<const ScreenPrimitive> pieces, const Listener& listener,
                      DrawPiece&& draw_piece) {
        auto next = pieces.begin();
        if constexpr (keeps_steps<Sink>)
            tell_pieces<Coordinate>(scene_, list, index, listener,
                                    [&](const auto& face) { draw_piece(*next++, face); });
        else
            for (const ScreenPrimitive& one : pieces)
                draw_piece(one, NoFace());
    }

    /// Begins the next piece of a primitive: `one` of the plan's list, if it is there.
    void begin(std::size_t index, const ScreenPrimitive* one = nullptr) {
        PieceIndex piece{.primitive = static_cast<std::uint32_t>(index), .part = parts_++};
        if (one && !listed_.empty() && &listed_.front() <= one && one <= &listed_.back())
            piece.listed = static_cast<std::uint32_t>(one - listed_.data());
        exactness_.drawn.push_back(piece);
        if (filtered_.depth)
            filtered_.depth->begin(static_cast<std::uint32_t>(exactness_.drawn.size() - 1));
    }

    /// Begins a side of the same piece: its depths have an owner of their own.
    void begin_side(EdgeName side) {
        if (side.from == 0)
            return;
        PieceIndex piece = exactness_.drawn.back();
        piece.side = side.from;
        filtered_.depth->begin(static_cast<std::uint32_t>(exactness_.drawn.size()));
        exactness_.drawn.push_back(piece);
    }

    /// Returns whether a face hides the point at a pixel of a side of the current piece, exactly.
    bool hides_exactly(std::uint32_t owner, EdgeName side, Pixel pixel) {
        const bool larger_passes = filtered_.depth->larger_passes();
        const auto line = line_points(exactness_.pieces.piece(exactness_.drawn.back()), side,
                                      larger_passes, scene_);
        const auto face = corners_of(exactness_.pieces.piece(exactness_.drawn[owner]));
        return hides_point(face, line.at(pixel), larger_passes);
    }

    /// Draws the next piece of a primitive.
    template <typename AList, typename AFace>
    void draw_one(const AList& list, const ScreenPrimitive& one, const AFace& face,
                  const Listener& listener) {
        begin(one.primitive, &one);
        const auto piece = piece_in<Adaptive>(piece_of(scene_, list, one), plan_);
        const auto open = decide_about(piece, face);
        if (open) {
            TellingUndecided telling(listener, *open);
            draw_exactly(list, one, face, Listener(telling));
        } else if constexpr (keeps_steps<Sink>) {
            if (takes_pixels_) {
                const NearestSlopes nearest(listener, piece, exactness_);
                return tell_and_draw(list, one, face, piece, filtered_, nearest, nearest);
            }
            const PieceNames names(scene_, list, one);
            const ListenerSink sink(listener);
            tell_piece(names, face, piece, filtered_, sink);
            if (rows_.skipped())
                sink(*rows_.skipped());
        }
    }

    /// Draws it with rationals.
    template <typename AList, typename AFace>
    void draw_exactly(const AList& list, const ScreenPrimitive& one, const AFace& face,
                      const Listener& listener) {
        ++exactness_.fallbacks.primitives;
        const auto exact = exactness_.pieces.piece(exactness_.drawn.back());
        const Sink sink = sink_to<Sink>(listener);
        tell_and_draw(list, one, face, exact, exact_, sink, sink);
    }

    /// Takes all decisions about a piece; returns the undecided comparison, if there is one. If the
    /// listener takes no pixels, the piece is painted as well.
    template <typename AFace>
    std::optional<Undecided> decide_about(const Piece<Adaptive>& piece, const AFace& face) {
        rows_.clear();
        if constexpr (keeps_steps<Sink>) {
            const ListenerSink sink(certifying_);
            const auto open = left_open_by([&] {
                if (piece.kind == PrimitiveKind::line)
                    octant_of(piece, {0, 1}, filtered_.line_offset,
                              scene_.method); // emitted even if the line is not drawn
                if (!tell_face(face, sink) || !takes_pixels_)
                    return;
                if (piece.kind == PrimitiveKind::triangle)
                    TrianglePaint<Adaptive, Adaptive>(piece, filtered_);
                decide(piece, sink);
            });
            if (open || takes_pixels_)
                return open;
        }
        return paint_if_decided(piece);
    }

    /// Paints a piece if all of it is decided, and emits no steps.
    std::optional<Undecided> paint_if_decided(const Piece<Adaptive>& piece) {
        if (piece.is_skipped)
            return std::nullopt;
        std::optional<TrianglePaint<Adaptive, Adaptive>> paint;
        const auto open = left_open_by([&] {
            if (piece.kind == PrimitiveKind::triangle)
                paint.emplace(piece, filtered_);
            decide(piece, rows_);
        });
        const auto paint_with = [&](const auto& painter) {
            rows_.paint_with(painter, [&](const auto& again) { decide(piece, again); });
        };
        if (open)
            return open;
        if (paint && paint->is_flat() && paint->has_work()) {
            paint_with(paint->flat_painter(filtered_.image));
        } else if (paint && paint->has_work()) {
            paint_with(paint->row_painter(filtered_, NullSink{}));
        } else if (piece.kind == PrimitiveKind::polygon) {
            paint_with(FlatPainter(filtered_.image, piece.color, NullSink{},
                                   filtered_.stages_of(piece.primitive).tests_canvas));
        } else if (!paint) {
            draw_thin(piece, filtered_, NullSink{});
        }
        return std::nullopt;
    }

    template <typename Decisions> void decide(const Piece<Adaptive>& piece, Decisions&& decisions) {
        const Canvas& canvas = filtered_.image.canvas();
        if (piece.kind == PrimitiveKind::triangle)
            fill(Triangle<Adaptive>{piece.positions}, piece.colors, scene_.method, filtered_.grid,
                 canvas, decisions);
        else if (piece.kind == PrimitiveKind::polygon)
            fill_polygon(piece, filtered_.offset, scene_.method, canvas, decisions);
        else
            draw_lines(piece, filtered_, [&](EdgeName side) -> Decisions& {
                if (plan_.stages.pixels[piece.primitive].tests_depth) {
                    require_finite_differences(piece.depths);
                    line_points(piece, side, filtered_.depth->larger_passes(), scene_);
                }
                return decisions;
            });
    }

    const Scene& scene_;
    const Plan& plan_;
    SceneDrawing<Adaptive>& filtered_;
    SceneDrawing<Rational, Adaptive> exact_;
    Exactness& exactness_;
    const Listener& listener_;
    const Certifier certifier_;
    const Listener certifying_; ///< of the certifier
    const bool takes_pixels_ = listener_.takes_pixels();
    CertainRows rows_;
    std::span<const ScreenPrimitive> listed_; ///< the plan's list
    std::uint32_t parts_ = 0;                 ///< of the primitive, so far
};

} // namespace

template <typename AList, typename Sink>
void draw_list(const AList& list, SceneDrawing<Adaptive>& drawing, const Listener& listener,
               const Sink&) {
    if (listener.takes_nothing())
        AdaptiveDrawing<NullSink>(drawing, listener).draw(list);
    else
        AdaptiveDrawing<ListenerSink>(drawing, listener).draw(list);
    if (drawing.depth)
        drawing.exactness->fallbacks.depths += drawing.depth->exact_tests();
}

template Image draw_in<Adaptive>(const Scene&, const Plan&, const Listener&, Fallbacks*);

} // namespace rastertrace
