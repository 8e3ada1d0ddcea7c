// SPDX-License-Identifier: MIT
#pragma once

// The drawing of a scene by the rules of the model. model.cpp: one piece after the other, and its pixels;
// model_fills.cpp: triangles and polygons; model_lines.cpp: lines and circles; model_depths.cpp: what is nearest.

#include "model/model_depths.h"
#include "model/model_pieces.h"
#include "tell/listener_sink.h"

#include <rastertrace/core/draw/model/model.h>
#include <rastertrace/core/raster/image.h>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace rastertrace {

/// The weights of the vertices in a point: the areas of the triangles that it makes with the edges, over that of all.
ModelWeights weights_at(const ModelTriangle& triangle, const Vec<Rational, 2>& p);

/// Twice its area; negative if it is wound the other way.
Rational area2_of(const ModelTriangle& triangle);

/// Where an edge meets a row.
struct ModelCrossing {
    const ModelEdge* edge;
    Rational x;
    int turn = 0; ///< what it adds to the winding number: 1 if a polygon runs down along it
};

class ModelDrawing {
public:
    ModelDrawing(const ModelRules& rules, const Listener& listener);

    Image drawn();

private:
    void draw(const ModelPiece& piece);

    // Pixels. Those beside the canvas are told in runs.
    std::optional<Pixel> place_of(GridPoint at);
    template <typename ColorOf> void plot(GridPoint at, ColorOf&& color_of) {
        if (const auto pixel = place_of(at))
            put(*pixel, color_of());
    }
    void put(Pixel pixel, Color color);
    void reject(GridPoint at);
    void tell_rejected();
    std::optional<Pixel> stored_at(GridPoint at) const;
    Index reach() const;
    std::pair<Index, Index> within_reach(Index from, Index to) const;
    void for_each_in_row(Index row, Index from, Index to,
                         const std::function<void(GridPoint)>& visit);

    // Triangles and polygons.
    void fill(const ModelTriangle& triangle, Color color);
    void fill_by_samples(const ModelTriangle& triangle);
    void fill_by_rows(const ModelTriangle& triangle);
    void fill_row(const ModelTriangle& triangle, Index row, const ModelEdge& left,
                  const ModelEdge& right);
    void fill_fan(const ModelTriangle& triangle);
    void fill_polygon(const ModelPiece& polygon);
    std::vector<ScanlineSpanned<Rational>>
    spans_inside(Index row, const std::vector<ModelCrossing>& met) const;
    void fill_spans(Index row, const std::vector<ModelCrossing>& met,
                    const std::vector<ScanlineSpanned<Rational>>& spans, Color color);
    ModelEdge edge_between(ModelEdge::Role role, const ModelVertex& from,
                           const ModelVertex& to) const;
    ScanlineSpanned<Rational> span_between(Index row, const ModelCrossing& left,
                                           const ModelCrossing& right,
                                           const Rational& offset) const;
    void test_and_put(const ModelTriangle& triangle, GridPoint at,
                      const std::function<Rational()>& depth);
    Color mixed(const ModelTriangle& triangle, GridPoint at) const;
    ModelVertex on_rows(const ModelVertex& vertex, const Rational& offset) const;
    Rational offset_of_triangles() const;

    // Points, lines and circles.
    bool draw_side(const ModelPiece& piece, std::uint16_t side);
    bool draw_line(const ModelVertex& from, const ModelVertex& to);
    void draw_circle(const ModelVertex& center, Index radius);
    void walk(const ModelLine& line, Index last, bool is_told,
              const std::function<void(Index step, GridPoint pixel)>& visit);
    std::pair<Index, Index> steps_within_reach(bool is_x_major, Index first, bool goes_back,
                                               Index last_step) const;
    void sample(const ModelLine& line, const GridLine& pixels, Index last);
    bool sample_diamonds(const ModelVertex& from, const ModelVertex& to, const GridLine& pixels);
    LineColors line_colors(const ModelVertex& from, const ModelVertex& to) const;

    const ModelRules& rules_;
    const Scene& scene_;
    const Method& method_;
    const Canvas& canvas_;
    const int down_;
    ListenerSink sink_;
    Image image_;
    std::optional<ModelDepths> depths_;
    bool is_painted_ = true;              ///< the piece that is drawn
    std::optional<ModelSegment> segment_; ///< the line that is tested against depths
    Color color_;                         ///< of a fill, unless
    bool mixes_ = false;                  ///< they are mixed
    std::optional<std::pair<GridPoint, GridPoint>> rejected_; ///< the first and last of a run
};

} // namespace rastertrace
