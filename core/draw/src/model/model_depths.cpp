// SPDX-License-Identifier: MIT
#include "model/model_depths.h"

#include "hidden-lines/sides.h"
#include "model/model_drawing.h"

#include <algorithm>
#include <cstdlib>

namespace rastertrace {

namespace {

/// The point of a line that a pixel stands for: at its sample along the longer axis; beyond an end, that end. Of
/// a line that is seen end-on, the nearer end.
ModelVertex point_at(Pixel pixel, const ModelSegment& segment, const ModelRules& rules) {
    const ModelVertex& from = segment.from;
    const ModelVertex& to = segment.to;
    const bool is_x_major = abs(to.at.x - from.at.x) >= abs(to.at.y - from.at.y);
    const auto along = [is_x_major](const Vec<Rational, 2>& p) { return is_x_major ? p.x : p.y; };
    const Rational run = along(to.at) - along(from.at);
    if (run == 0)
        return rules.passes(to.depth, from.depth) ? to : from;
    const Rational way = std::clamp<Rational>(
        ((is_x_major ? pixel.x : pixel.y) - along(from.at)) / run, Rational(0), Rational(1));
    ModelVertex point = from;
    point.at.x += way * (to.at.x - from.at.x);
    point.at.y += way * (to.at.y - from.at.y);
    point.depth += way * (to.depth - from.depth);
    return point;
}

} // namespace

ModelDepths::ModelDepths(const ModelRules& rules, const ListenerSink& sink)
    : rules_(rules), canvas_(rules.scene.canvas), sink_(sink),
      cells_(static_cast<std::size_t>(canvas_.width) * static_cast<std::size_t>(canvas_.height)) {}

void ModelDepths::begin_face(std::size_t primitive, const ModelTriangle& triangle) {
    faces_.push_back({primitive, triangle});
}

/// Of equal depths the thinner one passes, and of equally thin ones the first stays.
bool ModelDepths::is_behind_line(const Cell& cell, const Rational& depth,
                                 Thickness thickness) const {
    return cell.line && (thickness < cell.line->thickness ? is_nearer(cell.line->depth, depth)
                                                          : !is_nearer(depth, cell.line->depth));
}

/// What a depth is compared with: the nearer one of the face and of the line.
std::optional<Rational> ModelDepths::stored(const Cell& cell) const {
    if (cell.line && !(cell.face && is_nearer(cell.face->depth, cell.line->depth)))
        return cell.line->depth;
    return cell.face ? std::optional(cell.face->depth) : rules_.cleared;
}

bool ModelDepths::keeps_face(Pixel pixel, const Rational& depth) {
    Cell& cell = cell_at(pixel);
    const auto held = stored(cell);
    const bool is_nearest_face =
        rules_.passes(depth, cell.face ? std::optional(cell.face->depth) : rules_.cleared);
    const bool passes = is_nearest_face && !is_behind_line(cell, depth, Thickness::face);
    sink_(DepthTested<Rational>{
        .x = pixel.x, .y = pixel.y, .depth = depth, .stored = held, .pass = passes});
    if (is_nearest_face)
        cell.face = {depth, faces_.size() - 1};
    return passes;
}

bool ModelDepths::keeps_line(Pixel pixel, const ModelSegment& segment) {
    Cell& cell = cell_at(pixel);
    const ModelVertex point = point_at(pixel, segment, rules_);
    DepthTested<Rational> told{
        .x = pixel.x, .y = pixel.y, .depth = point.depth, .stored = stored(cell), .pass = false};
    if (const Face* const hiding = face_before(pixel, segment, point)) {
        told.behind = name_of(hiding->primitive);
    } else if (is_behind_line(cell, point.depth, segment.thickness)) {
        // A line does not hide the points at its ends.
        told.stored = cell.line->depth;
        told.pass =
            segment.thickness < cell.line->thickness && is_side(segment, cell.line->primitive);
        if (told.pass)
            told.side_of = name_of(cell.line->primitive);
    } else if (cell.face && is_nearer(cell.face->depth, point.depth)) {
        const std::size_t face = faces_[cell.face->face].primitive;
        told.pass = true;
        (is_side(segment, face) ? told.side_of : told.beside) = name_of(face);
    } else {
        told.pass = cell.face || rules_.passes(point.depth, rules_.cleared);
    }
    sink_(told);
    if (told.pass)
        cell.line = {point.depth, segment.primitive, segment.thickness};
    return told.pass;
}

/// The face, in a pixel or in the eight around it, that hides a point of a line.
const ModelDepths::Face* ModelDepths::face_before(Pixel pixel, const ModelSegment& segment,
                                                  const ModelVertex& point) {
    for (const int dy : {0, -canvas_.down(), canvas_.down()})
        for (const int dx : {0, -1, 1}) {
            const Pixel at{pixel.x + dx, pixel.y + dy};
            if (!canvas_.contains(at.x, at.y) || !cell_at(at).face)
                continue;
            const Face& face = faces_[cell_at(at).face->face];
            if (!is_side(segment, face.primitive) && hides(face, point))
                return &face;
        }
    return nullptr;
}

/// True if a face covers a point, its sides included, and is nearer there.
bool ModelDepths::hides(const Face& face, const ModelVertex& point) const {
    const auto& [a, b, c] = face.triangle;
    if (area2_of(face.triangle) == 0)
        return false;
    const ModelWeights weights = weights_at(face.triangle, point.at);
    return std::all_of(weights.begin(), weights.end(), [](const Rational& w) { return w >= 0; }) &&
           is_nearer(weights[0] * a.depth + weights[1] * b.depth + weights[2] * c.depth,
                     point.depth);
}

bool ModelDepths::is_side(const ModelSegment& segment, std::size_t primitive) const {
    return is_side_of(rules_.scene, segment.ends, primitive);
}

std::string_view ModelDepths::name_of(std::size_t primitive) const {
    return rules_.scene.primitives[primitive].name;
}

} // namespace rastertrace
