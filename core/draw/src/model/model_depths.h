// SPDX-License-Identifier: MIT
#pragma once

// What is nearest in each pixel of the model: a face, and a point or a line.

#include "model/model_pieces.h"
#include "tell/listener_sink.h"

#include <rastertrace/core/draw/model/model.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace rastertrace {

/// A line, or a point, whose pixels are tested. Where pixels have their samples, x and y are whole numbers.
struct ModelSegment {
    std::size_t primitive;
    Thickness thickness;
    std::array<std::size_t, 2> ends; ///< vertices of the scene
    ModelVertex from;
    ModelVertex to;
};

class ModelDepths {
public:
    ModelDepths(const ModelRules& rules, const ListenerSink& sink);

    /// The face that the depths which follow are of: a triangle like the ends of a ModelSegment.
    void begin_face(std::size_t primitive, const ModelTriangle& triangle);

    /// Tests a pixel of that face, and keeps its depth; false if something hides it.
    bool keeps_face(Pixel pixel, const Rational& depth);

    /// Tests a pixel of a line, and keeps its depth; false if something hides it.
    bool keeps_line(Pixel pixel, const ModelSegment& segment);

private:
    /// A face, in all pixels that it has been drawn in.
    struct Face {
        std::size_t primitive;
        ModelTriangle triangle;
    };
    struct OfFace {
        Rational depth;
        std::size_t face; ///< in faces_
    };
    struct OfLine {
        Rational depth;
        std::size_t primitive;
        Thickness thickness;
    };
    struct Cell {
        std::optional<OfFace> face;
        std::optional<OfLine> line;
    };

    Cell& cell_at(Pixel pixel) { return cells_[canvas_.offset_of(pixel)]; }
    bool is_nearer(const Rational& depth, const Rational& other) const {
        return rules_.passes(depth, other);
    }
    bool is_behind_line(const Cell& cell, const Rational& depth, Thickness thickness) const;
    std::optional<Rational> stored(const Cell& cell) const;
    const Face* face_before(Pixel pixel, const ModelSegment& segment, const ModelVertex& point);
    bool hides(const Face& face, const ModelVertex& point) const;
    bool is_side(const ModelSegment& segment, std::size_t primitive) const;
    std::string_view name_of(std::size_t primitive) const;

    const ModelRules& rules_;
    const Canvas& canvas_;
    const ListenerSink& sink_;
    std::vector<Cell> cells_;
    std::vector<Face> faces_;
};

} // namespace rastertrace
