// SPDX-License-Identifier: MIT
// Drawing with doubles that know their error: first certify, then draw. All decisions about a piece are
// taken before its first pixel is painted and its first step is told. If doubles leave one open, the
// piece is drawn with rationals instead. What hangs on a single pixel, a depth test or a color, is
// decided for that pixel (exactly.h).

#include "draw_in.h"
#include "draw_scalar.h"

#include <rastertrace/core/exactly.h>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace rastertrace {

namespace {

/// The rows that a fill yields, kept until all of them are certain. What comes pixel by pixel is too much
/// to keep: its decisions are taken again.
class CertainRows {
public:
    template <typename Step> void operator()(const Step&) {}
    void operator()(const ScanlineSpanned<Adaptive>& span) { spans_.push_back(span); }
    void operator()(const SampleTested<Adaptive>&) { has_pixels_ = true; }
    void operator()(const PixelPlotted&) { has_pixels_ = true; }

    template <typename Step> bool takes() const { return false; }

    void clear() {
        spans_.clear();
        has_pixels_ = false;
    }

    /// Hands all of it to a painter; `yield_again(painter)` if not all has been kept.
    template <typename Painter, typename YieldAgain>
    void paint_with(const Painter& painter, YieldAgain&& yield_again) const {
        if (has_pixels_)
            return yield_again(painter);
        for (const auto& span : spans_)
            painter(span);
    }

private:
    std::vector<ScanlineSpanned<Adaptive>> spans_;
    bool has_pixels_ = false;
};

/// Takes the steps that a listener takes, and tells it nothing. A step that doubles cannot tell is left
/// open like a decision that they cannot take.
class Certifier {
public:
    explicit Certifier(const Listener& listener) : listener_(listener) {}

    template <typename Step> bool takes() const { return listener_.takes<Step>(); }

    template <typename Step> void operator()(const Step& step) const {
        if (!is_told_by_doubles(step)) {
            constexpr double infinity = std::numeric_limits<double>::infinity();
            Adaptive::leave_open(infinity, infinity);
        }
    }

private:
    const Listener& listener_;
};

/// Tells a listener all steps of a primitive that doubles leave open, and, as soon as that has begun,
/// that they do.
class TellingUndecided {
public:
    TellingUndecided(const Listener& listener, const Undecided& undecided)
        : listener_(listener), undecided_(undecided) {}

    template <typename Step> bool takes() const { return listener_.takes<Step>(); }
    template <typename Step>
    requires std::same_as<Step, PrimitiveBegan<Quantity>>
    bool takes() const { return listener_.takes<Step>() || listener_.takes<BoundExceeded>(); }

    template <typename Step> void operator()(const Step& step) { listener_(step); }
    void operator()(const PrimitiveBegan<Quantity>& step) {
        listener_(step);
        if (!is_told_)
            listener_(
                BoundExceeded{.difference = undecided_.difference, .error = undecided_.error});
        is_told_ = true;
    }

private:
    const Listener& listener_;
    Undecided undecided_;
    bool is_told_ = false;
};

/// Runs what may leave something open; tells what.
template <typename Run> std::optional<Undecided> left_open_by(Run&& run) {
    try {
        run();
        return std::nullopt;
    } catch (const Undecided& undecided) {
        return undecided;
    }
}

/// Draws the pieces of a scene, with a sink or without one.
template <typename Sink> class AdaptiveDrawing {
public:
    AdaptiveDrawing(const Scene& scene, const Plan& plan, Target<Adaptive>& target,
                    const Listener& listener)
        : scene_(scene), plan_(plan),
          target_(target), exact_target_{target.image, sample_grid<Rational>(scene, plan),
                                         target.depth, target.exactness},
          exactness_(*target.exactness), listener_(listener), certifier_(listener),
          certifying_(certifier_) {
        if (target.depth)
            target.depth->ask(
                [this](auto... asked) { return is_nearer(scene_, plan_, exactness_, asked...); },
                [this](auto... asked) { return told_depth(scene_, exactness_, asked...); });
    }

    /// Draws a primitive whose pieces doubles may leave open: its face, or what clips it.
    void draw(const Geometry<Adaptive>& geometry, std::size_t number) {
        parts_ = 0;
        pieces_.clear();
        const auto open = left_open_by([&] {
            visit_pieces(scene_, geometry, number, plan_.mixes_colors, certifying_,
                         [this](const Piece<Adaptive>& piece) { draw_or_keep(piece); });
        });
        if (open) {
            TellingUndecided telling(listener_, *open);
            const Listener told(telling);
            exactness_.pieces.visit(number, told, [&](const auto& piece) {
                if (piece.is_part)
                    return draw_one(piece, told);
                begin(piece.primitive);
                draw_exactly(piece, told);
            });
        } else if constexpr (keeps_steps<Sink>) {
            visit_pieces(scene_, geometry, number, plan_.mixes_colors, listener_,
                         [this](const Piece<Adaptive>& piece) { draw_one(piece, listener_); });
        } else {
            for (const Piece<Adaptive>& piece : pieces_)
                draw_one(piece, listener_);
        }
    }

    /// Draws a primitive whose pieces are certain.
    template <typename AGeometry> void draw(const AGeometry& geometry, std::size_t number) {
        parts_ = 0;
        visit_pieces(scene_, geometry, number, plan_.mixes_colors, listener_,
                     [this]<typename Coordinate>(const Piece<Coordinate>& piece) {
                         if constexpr (draws<Adaptive, Coordinate>)
                             draw_one(piece, listener_);
                     });
    }

private:
    /// A whole piece is all that there is to decide about its primitive. A part is kept until the others
    /// are certain. Who listens visits them again.
    void draw_or_keep(const Piece<Adaptive>& piece) {
        if constexpr (!keeps_steps<Sink>) {
            if (!piece.is_part)
                return draw_one(piece, listener_);
            Piece<Adaptive>& kept = pieces_.emplace_back(piece);
            kept.name = {}; // those of parts end with the visit
            kept.names = {};
        }
    }

    /// What follows is about the next piece of a primitive.
    void begin(std::size_t number) {
        exactness_.drawn.push_back({number, parts_++});
        if (target_.depth)
            target_.depth->begin(static_cast<std::uint32_t>(exactness_.drawn.size() - 1));
    }

    /// Draws the next piece of a primitive.
    template <typename Coordinate>
    void draw_one(const Piece<Coordinate>& piece, const Listener& listener) {
        begin(piece.primitive);
        const auto primitive = placed<Adaptive>(piece, plan_);
        const auto open = keeps_steps<Sink> ? certified(piece, primitive)
                                            : certified_and_painted(piece, primitive);
        if (open) {
            TellingUndecided telling(listener, *open);
            draw_exactly(piece, Listener(telling));
        } else if constexpr (keeps_steps<Sink>) {
            draw_piece(piece, primitive, scene_, plan_, target_, sink_to<Sink>(listener));
        }
    }

    /// Draws it with rationals.
    template <typename Coordinate>
    void draw_exactly(const Piece<Coordinate>& piece, const Listener& listener) {
        ++exactness_.fallbacks.primitives;
        PlacedPrimitive<Rational> exact = exactness_.pieces.placed(exactness_.drawn.back());
        exact.names = piece.names;
        draw_piece(piece, exact, scene_, plan_, exact_target_, sink_to<Sink>(listener));
    }

    /// Takes all decisions about a piece, and looks at every step that the listener would be told.
    template <typename Coordinate>
    std::optional<Undecided> certified(const Piece<Coordinate>& piece,
                                       const PlacedPrimitive<Adaptive>& primitive) {
        const ListenerSink sink(certifying_);
        return left_open_by([&] {
            if constexpr (!std::same_as<Coordinate, Number>)
                if (!report_face(piece.face, sink))
                    return;
            if (piece.kind == PrimitiveKind::triangle)
                TrianglePaint<Adaptive, Adaptive>(primitive, piece.color, scene_, plan_, target_);
            decide(piece.kind, primitive, sink);
        });
    }

    /// The same for nobody. What is certain is painted at once.
    template <typename Coordinate>
    std::optional<Undecided> certified_and_painted(const Piece<Coordinate>& piece,
                                                   const PlacedPrimitive<Adaptive>& primitive) {
        if constexpr (!std::same_as<Coordinate, Number>)
            if (piece.face.skip)
                return std::nullopt;
        rows_.clear();
        std::optional<TrianglePaint<Adaptive, Adaptive>> paint;
        const auto open = left_open_by([&] {
            if (piece.kind == PrimitiveKind::triangle)
                paint.emplace(primitive, piece.color, scene_, plan_, target_);
            decide(piece.kind, primitive, rows_);
        });
        const auto paint_with = [&](const auto& painter) {
            rows_.paint_with(painter,
                             [&](const auto& again) { decide(piece.kind, primitive, again); });
        };
        if (open)
            return open;
        if (paint)
            paint->with_painter(target_, NullSink{}, paint_with);
        else
            paint_with(FlatPainter<>(target_.image, piece.color));
        return std::nullopt;
    }

    template <typename Decisions>
    void decide(PrimitiveKind kind, const PlacedPrimitive<Adaptive>& primitive,
                Decisions&& decisions) {
        const Canvas& canvas = target_.image.canvas();
        if (kind == PrimitiveKind::triangle)
            fill(primitive, scene_.method, target_.grid, canvas, decisions);
        else
            draw_lines(kind, primitive, scene_.method, canvas, decisions);
    }

    const Scene& scene_;
    const Plan& plan_;
    Target<Adaptive>& target_;
    Target<Rational, Adaptive> exact_target_;
    Exactness& exactness_;
    const Listener& listener_;
    const Certifier certifier_;
    const Listener certifying_; ///< tells the certifier
    CertainRows rows_;
    std::vector<Piece<Adaptive>> pieces_; ///< parts of the primitive; without names
    std::size_t parts_ = 0;
};

} // namespace

template <typename AGeometry, typename Sink>
void draw_pieces(const Scene& scene, const Plan& plan, const AGeometry& geometry,
                 Target<Adaptive>& target, const Listener& listener, const Sink&) {
    AdaptiveDrawing<Sink> drawing(scene, plan, target, listener);
    for (std::size_t turn = 0; turn < scene.primitives.size(); ++turn)
        drawing.draw(geometry, primitive_at(geometry, turn));
    if (target.depth)
        target.exactness->fallbacks.depths = target.depth->exact_tests();
}

template Image draw_in<Adaptive>(const Scene&, const Plan&, const Listener&, Fallbacks*);

} // namespace rastertrace
