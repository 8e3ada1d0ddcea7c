// SPDX-License-Identifier: MIT
// Drawing in intervals. Every piece is first tried: drawn in intervals, on a picture that nobody sees,
// for a sink that keeps nothing. If that decides everything, the piece is drawn in doubles, from the
// middles of its corners: each double lies in its interval, and decides alike. Else it is drawn in
// fractions. Without a listener an open depth test does not count: the exact depths of its pixel
// decide it (numbered_depths.h).

#include "draw_in.h"
#include "draw_scalar.h"
#include "hidden-lines/line_painter.h"

#include <rastertrace/core/draw/paint/numbered_depths.h>
#include <rastertrace/core/raster/fill_scanline.h>

#include <map>

namespace rastertrace {

/// The depths of a row of a triangle: between its two edges, or in its plane.
DepthRow<Rational> depths_of_row(const Scene& scene, const Piece<Rational>& piece, int y) {
    const Method& method = scene.method;
    const auto offset = sample_offset<Rational>(sample_of(method), 1);
    const Triangle<Rational> triangle{piece.positions};
    TriangleDepth<Rational> depth(triangle.vertices, piece.depths,
                                  depth_rule<Rational>(scene).larger_passes);
    if (traits_of(method.fill).depths != DepthForm::along_edges)
        return depth.plane(offset).on_row(y);
    const int down = scene.canvas.down();
    const JoinedEdges<Rational> edges = joined_edges(triangle, down);
    const bool is_lower = first_lower_y(edges, offset, down) * down <= Index{y} * down;
    const Edge<Rational>* left = &edges.long_edge;
    const Edge<Rational>* right = is_lower ? &edges.lower : &edges.upper;
    if (!edges.long_edge_is_left)
        std::swap(left, right);
    const Rational height = offset.y_of(y);
    Rational left_x = offset.in_columns(left->x_at(height));
    Rational right_x = offset.in_columns(right->x_at(height));
    if (method.depth_at == DepthAt::rounded_ends) {
        left_x = scalar_from<Rational>(first_pixel(left_x, span_rounding(method)));
        right_x = scalar_from<Rational>(last_pixel(right_x, span_rounding(method)));
    }
    return row_between<Rational>(left_x, depth.on_edge(left->name, height), right_x,
                                 depth.on_edge(right->name, height));
}

Rational exact_depth(const Scene& scene, const Piece<Rational>& piece, std::size_t corner,
                     Pixel pixel) {
    if (piece.kind == PrimitiveKind::triangle)
        return depths_of_row(scene, piece, pixel.y).at(pixel.x);
    const EdgeName side{static_cast<std::uint16_t>(corner),
                        static_cast<std::uint16_t>((corner + 1) % piece.count)};
    return line_points(piece, side, depth_rule<Rational>(scene).larger_passes, scene)
        .depth_at(pixel);
}

namespace {

/// The primitives of a scene in exact numbers, each worked out when it is asked for.
class ExactPieces {
public:
    ExactPieces(const Scene& scene, const Plan& plan) : scene_(scene), plan_(plan) {}

    /// The parts of a primitive of a scene with a pipeline, in the list that holds those so far.
    const std::vector<ScreenPrimitive>& parts_of(std::size_t primitive) {
        if (!geometry_)
            std::visit([this](const auto& list) { begin(list); }, *plan_.list);
        const auto [known, is_new] = parts_.try_emplace(primitive);
        if (is_new) {
            for (const std::size_t index : scene_.primitives[primitive].corners())
                if (!geometry_->is_used[index]) {
                    geometry_->is_used[index] = true;
                    move_vertex(scene_, index, *geometry_);
                }
            geometry_->list.primitives.clear();
            add_primitive(scene_, *geometry_, primitive);
            known->second = geometry_->list.primitives;
        }
        return known->second;
    }
    const ScreenList<Rational>& list() const { return geometry_->list; }

    Piece<Rational> piece(std::size_t primitive, std::size_t part) {
        if (const auto* typed = std::get_if<TypedVertices>(plan_.list.get()))
            return piece_in<Rational>(piece_of(scene_, *typed, typed_primitive(scene_, primitive)),
                                      plan_);
        const ScreenPrimitive& one = parts_of(primitive)[part];
        return piece_of(scene_, list(), one);
    }

private:
    /// Begins with the planes of the view that cut a primitive.
    void begin(const TypedVertices&) {}
    template <typename Coordinate> void begin(const ScreenList<Coordinate>& list) {
        geometry_ = empty_geometry<Rational>(scene_);
        geometry_->list.transforms.divides = list.transforms.divides;
        geometry_->list.culled_sides = list.culled_sides;
        std::erase_if(geometry_->list.transforms.planes, [&list](const auto& plane) {
            const auto& kept = list.transforms.planes;
            return std::none_of(kept.begin(), kept.end(),
                                [&plane](const auto& other) { return other.name == plane.name; });
        });
    }

    const Scene& scene_;
    const Plan& plan_;
    std::optional<Geometry<Rational>> geometry_; ///< only the vertices in use are on the screen
    std::map<std::size_t, std::vector<ScreenPrimitive>> parts_; ///< of the primitives in the list
};

/// Draws a list. `Sink` is that of pixels.
template <typename AList, typename Sink> class AdaptiveDrawing {
public:
    AdaptiveDrawing(const Scene& scene, const Plan& plan, const AList& list,
                    const Listener& listener, const Sink& sink, Image& image)
        : scene_(scene), plan_(plan), list_(list), listener_(listener), sink_(sink),
          scratch_(Image::of_one_row(scene.canvas)), trial_{scene, plan, scratch_},
          doubles_{scene, plan, image}, fractions_{scene, plan, image}, exact_(scene, plan) {
        if (!scene.has_depth_buffer())
            return;
        depths_.emplace(plan.stages.depth_region, depth_rule<Rational>(scene),
                        [this](std::uint32_t piece, std::size_t corner, int x, int row) {
                            return exact_depth(scene_, exactly(drawn_[piece]), corner,
                                               {x, scene_.canvas.y_of(row)});
                        });
        const auto share_depths = [this](auto& drawing, auto converted) {
            drawing.depth = &*depths_;
            drawing.owners = {
                [this](std::uint32_t owner) { return drawn_of(owner).primitive; },
                [=, this](std::uint32_t owner) { return corners_of(converted(drawn_of(owner))); }};
        };
        share_depths(trial_, [this](const Drawn& one) { return in_intervals(one); });
        share_depths(doubles_, [this](const Drawn& one) { return in_doubles(in_intervals(one)); });
        share_depths(fractions_, [this](const Drawn& one) { return exactly(one); });
    }

    Fallbacks draw() {
        if constexpr (std::same_as<AList, TypedVertices>)
            for_each_primitive(scene_, list_, [this](const ScreenPrimitive& one) {
                parts_ = 0;
                draw(one, NoFace());
            });
        else
            draw_list();
        fallbacks_.depths = depths_ ? depths_->exact_tests() : 0;
        return fallbacks_;
    }

private:
    void draw_list() {
        auto next = list_.primitives.begin();
        const auto draw_next = [&](const auto& face) { draw(*next++, face); };
        for (std::size_t turn = 0; turn < scene_.primitives.size(); ++turn) {
            const std::size_t index = primitive_at(list_, turn);
            parts_ = 0;
            const auto is_next = [&] {
                return next != list_.primitives.end() && next->primitive == index;
            };
            if (is_next() && next->state == ScreenPrimitive::State::undecided)
                draw_exactly(index, list_.undecided[next++->index]);
            else if (tells_)
                tell(list_, index, draw_next);
            else
                while (is_next())
                    draw_next(NoFace());
        }
    }

    /// A part of a primitive, and its entry in the list, unless it is one of the exact list.
    struct Drawn {
        std::size_t primitive;
        std::size_t part;
        const ScreenPrimitive* listed;
    };
    const Drawn& drawn_of(std::uint32_t owner) const {
        return drawn_[NumberedDepths::piece_of(owner)];
    }
    Piece<Rational> exactly(const Drawn& drawn) {
        return exact_.piece(drawn.primitive, drawn.part);
    }
    Piece<Interval> in_intervals(const Drawn& drawn) {
        return drawn.listed ? piece_in<Interval>(piece_of(scene_, list_, *drawn.listed), plan_)
                            : piece_in<Interval>(exactly(drawn), plan_);
    }

    template <typename Coordinate, typename DrawNext>
    void tell(const ScreenList<Coordinate>& list, std::size_t index, DrawNext&& draw_next) {
        tell_pieces<Coordinate>(scene_, list, index, listener_, draw_next);
    }

    /// Begins the next piece of a primitive.
    void begin(std::size_t primitive, const ScreenPrimitive* listed) {
        drawn_.push_back({primitive, parts_++, listed});
        if (depths_)
            depths_->begin(static_cast<std::uint32_t>(drawn_.size() - 1));
    }

    /// Draws the next piece of the list.
    template <typename AFace> void draw(const ScreenPrimitive& one, const AFace& face) {
        begin(one.primitive, &one);
        const Piece<Interval> piece = in_intervals(drawn_.back());
        try {
            try_out(one, face, piece);
        } catch (const Undecided& open) {
            drawn_.pop_back();
            --parts_;
            // A face is told in fractions, too. That of a part has been told.
            if constexpr (std::same_as<AList, ScreenList<Interval>>)
                if (one.state != ScreenPrimitive::State::part)
                    return draw_exactly(one.primitive, open);
            begin(one.primitive, &one);
            tell_open(PieceNames(scene_, list_, one).piece, open);
            return draw_exactly(list_, one, face);
        }
        if (depths_)
            depths_->draw();
        tell_and_draw(list_, one, face, in_doubles(piece), doubles_, listener_, sink_);
    }

    /// Throws Undecided if intervals leave a decision about a piece open; with a listener, also one
    /// that is only told.
    template <typename AFace>
    void try_out(const ScreenPrimitive& one, const AFace& face, const Piece<Interval>& piece) {
        if (depths_)
            depths_->try_out(tells_);
        if (tells_)
            tell_and_draw(list_, one, face, piece, trial_, unheard_, ListenerSink(unheard_));
        else if (!piece.is_skipped)
            draw_piece(piece, trial_, NullSink());
    }

    /// Tells what is open. What has left the doubles has no difference to tell.
    void tell_open(std::string_view name, const Undecided& open) {
        const bool is_told = std::isfinite(open.difference) && std::isfinite(open.error);
        listener_(
            BoundExceeded<>{.name = name,
                            .difference = is_told ? std::optional(open.difference) : std::nullopt,
                            .error = is_told ? std::optional(open.error) : std::nullopt});
    }

    /// Draws a primitive in fractions, or what clipping has left of it.
    void draw_exactly(std::size_t index, const Undecided& open) {
        tell_open(scene_.primitives[index].name, open);
        auto next = exact_.parts_of(index).begin();
        tell(exact_.list(), index, [&](const auto& face) {
            begin(index, nullptr);
            draw_exactly(exact_.list(), *next++, face);
        });
    }

    /// Draws the piece that has begun in fractions.
    template <typename AnyList, typename AFace>
    void draw_exactly(const AnyList& list, const ScreenPrimitive& one, const AFace& face) {
        ++fallbacks_.primitives;
        if (depths_)
            depths_->draw();
        tell_and_draw(list, one, face, exactly(drawn_.back()), fractions_, listener_, sink_);
    }

    static constexpr auto drop_ = [](const auto&) {};

    const Scene& scene_;
    const Plan& plan_;
    const AList& list_;
    const Listener& listener_;
    const Listener unheard_ = drop_; ///< takes every step, and keeps none
    const bool tells_ = !listener_.takes_nothing();
    const Sink& sink_;
    Image scratch_;
    std::optional<NumberedDepths> depths_;
    SceneDrawing<Interval, NumberedDepths> trial_;
    SceneDrawing<double, NumberedDepths> doubles_;
    SceneDrawing<Rational, NumberedDepths> fractions_;
    ExactPieces exact_;
    std::vector<Drawn> drawn_; ///< the last one is being drawn
    std::size_t parts_ = 0;    ///< of the primitive, so far
    Fallbacks fallbacks_;
};

} // namespace

template <>
Image draw_in<Interval>(const Scene& scene, const Plan& plan, const Listener& listener,
                        Fallbacks* fallbacks) {
    Image image(scene.canvas);
    const auto draw = [&]<typename AList>(const AList& list, const auto& sink) {
        if constexpr (!std::same_as<AList, TypedVertices>)
            tell_geometry(scene, list, listener);
        const Fallbacks found = AdaptiveDrawing(scene, plan, list, listener, sink, image).draw();
        if (fallbacks)
            *fallbacks = found;
    };
    const auto draw_any = [&]<typename AList>(const AList& list) {
        if constexpr (draws<Interval, AList>)
            listener.takes_pixels() ? draw(list, ListenerSink(listener))
                                    : draw(list, SkipSink(listener));
    };
    std::visit(draw_any, *plan.list);
    return image;
}

} // namespace rastertrace
