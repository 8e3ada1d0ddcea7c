// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/model/model.h>

#include "model/model_drawing.h"

#include <algorithm>

namespace rastertrace {

ModelDrawing::ModelDrawing(const ModelRules& rules, const Listener& listener)
    : rules_(rules), scene_(rules.scene), method_(scene_.method), canvas_(scene_.canvas),
      down_(canvas_.down()), sink_(listener), image_(canvas_) {
    if (scene_.has_depth_buffer())
        depths_.emplace(rules_, sink_);
}

Image ModelDrawing::drawn() {
    for_each_piece(rules_, sink_, [this](const ModelPiece& piece) {
        draw(piece);
        tell_rejected();
    });
    return std::move(image_);
}

void ModelDrawing::draw(const ModelPiece& piece) {
    is_painted_ = scene_.primitives[piece.primitive].is_painted;
    segment_.reset();
    if (piece.kind == PrimitiveKind::polygon)
        return fill_polygon(piece);
    if (piece.kind == PrimitiveKind::circle)
        return draw_circle(piece.corners[0], scene_.primitives[piece.primitive].radius);
    const std::size_t corners = piece.corners.size();
    std::size_t sides = corners < 3 ? 1 : corners;
    if (piece.kind == PrimitiveKind::triangle) {
        const Rational offset = offset_of(sample_of_lines(method_)).exact();
        ModelTriangle on_lines, triangle;
        for (std::size_t i = 0; i < 3; ++i) {
            on_lines[i] = on_samples(piece.corners[i], offset);
            triangle[i] = on_rows(piece.corners[i], offset_of_triangles());
        }
        if (depths_)
            depths_->begin_face(piece.primitive, on_lines);
        fill(triangle, piece.color);
        sides = rules_.draws_outlines ? corners : 0;
    }
    bool has_pixels = sides == 0;
    for (std::uint16_t side = 0; side < sides; ++side)
        has_pixels = draw_side(piece, side) || has_pixels;
    if (!has_pixels)
        sink_(PrimitiveSkipped<>{.why = method_.line == LineMethod::diamond_exit
                                            ? SkipReason::leaves_no_diamond
                                            : SkipReason::last_pixel_only});
}

// --- Pixels --------------------------------------------------------------------------------------

std::optional<Pixel> ModelDrawing::stored_at(GridPoint at) const {
    if (canvas_.contains(at.x, at.y))
        return pixel_at(at);
    const auto elsewhere = rules_.beside_canvas ? rules_.beside_canvas(at) : std::nullopt;
    return elsewhere ? std::optional(pixel_at(*elsewhere)) : std::nullopt;
}

/// Where a pixel of a point or a line is put; none if it is off the canvas, or hidden.
std::optional<Pixel> ModelDrawing::place_of(GridPoint at) {
    const auto pixel = stored_at(at);
    if (!pixel)
        reject(at);
    else if (!segment_ || depths_->keeps_line(*pixel, *segment_))
        return pixel;
    return std::nullopt;
}

void ModelDrawing::put(Pixel pixel, Color color) {
    tell_rejected();
    if (!is_painted_)
        return;
    image_.at(pixel) = color;
    sink_(PixelPlotted<>{.x = pixel.x, .y = pixel.y, .color = color});
}

void ModelDrawing::reject(GridPoint at) {
    rejected_ = {rejected_ ? rejected_->first : at, at};
}

void ModelDrawing::tell_rejected() {
    if (!rejected_)
        return;
    const auto& [from, to] = *rejected_;
    sink_(pixels_off_canvas(from.x, from.y, to.x, to.y));
    rejected_.reset();
}

/// How far off the canvas pixels are drawn. A rule where these are stored may bring back what lies as far off as the
/// canvas has pixels.
Index ModelDrawing::reach() const {
    return rules_.beside_canvas ? Index{canvas_.width} * canvas_.height : 0;
}

/// The pixels of a row that are drawn.
std::pair<Index, Index> ModelDrawing::within_reach(Index from, Index to) const {
    return {std::max<Index>(from, canvas_.left() - reach()),
            std::min<Index>(to, canvas_.right() + reach())};
}

/// Visits the pixels of a row that are drawn, and tells the others.
void ModelDrawing::for_each_in_row(Index row, Index from, Index to,
                                   const std::function<void(GridPoint)>& visit) {
    const Index y = row * down_;
    const auto [first, last] = within_reach(from, to);
    if (from <= to && from < first)
        sink_(pixels_off_canvas(from, y, std::min(to, first - 1), y));
    for (Index x = first; x <= last; ++x)
        visit({x, row});
    tell_rejected();
    if (from <= to && last < to)
        sink_(pixels_off_canvas(std::max(from, last + 1), y, to, y));
}

// -------------------------------------------------------------------------------------------------

Index farthest_of_model(const Scene& scene) {
    // A fan has a line for each pixel of an edge.
    const bool has_fan = scene.has(PrimitiveKind::triangle) && scene.method.fill == Fill::fan;
    return has_fan ? 2'000 : 100'000;
}

bool has_model(const Scene& scene) {
    const Rational farthest = farthest_of_model(scene);
    const auto is_near = [&farthest](const Rational& x) { return abs(x) <= farthest; };
    const Matrix<Rational> as_typed = identity<Rational>();
    auto object = scene.objects.begin();
    for (std::size_t i = 0; i < scene.vertices.size(); ++i) {
        while (object != scene.objects.end() && object->end_vertex <= i)
            ++object;
        const SceneVertex& typed = scene.vertices[i];
        const Vec<Rational, 4> world =
            (object == scene.objects.end() ? as_typed : object->model.matrix()) *
            Vec<Rational, 4>{typed.x.exact(), typed.y.exact(), typed.z.exact(), 1};
        // Behind a camera a z can be a column or a row.
        if (!is_near(typed.x.exact()) || !is_near(typed.y.exact()) || !is_near(world.x) ||
            !is_near(world.y) || (scene.camera && !is_near(world.z)))
            return false;
    }
    return true;
}

Image draw_by(const ModelRules& rules, const Listener& listener) {
    return ModelDrawing(rules, listener).drawn();
}

} // namespace rastertrace
