// SPDX-License-Identifier: MIT
#pragma once

// A plain rasterizer in fractions, beside the book: what the methods of a scene have in common, written
// once and without any thought of speed. Each rule that it decides by is a function. With the rules of
// a scene it draws what the book draws in `exact`; a mistake is another function in the place of one of
// them (mistakes.h).
//
//     ModelRules rules(scene);
//     rules.slope = [](const ModelEdge& edge) { ... };  // dy/dx for dx/dy
//     draw_by(rules);
//
// Where the samples of pixels lie, x and y are whole numbers here. y counts rows, downward in the
// picture for triangles; for lines as the canvas has it.

#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/draw/tell/listener.h>
#include <rastertrace/core/numbers/rational.h>
#include <rastertrace/core/raster/bounding_box.h>
#include <rastertrace/core/raster/clip.h>
#include <rastertrace/core/raster/line.h>
#include <rastertrace/core/raster/mixed_colors.h>

#include <array>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace rastertrace {

/// A vertex on the screen.
struct ModelVertex {
    Vec<Rational, 2> at{};
    Rational depth{};         ///< if there is a depth buffer
    Rational inverse_w = 1;   ///< if colors are mixed
    Levels<Rational> color{}; ///< of the primitive, unless colors are mixed
    std::uint16_t index = 0;  ///< among the corners of the primitive, or of its part
};
using ModelTriangle = std::array<ModelVertex, 3>;

/// An edge of a triangle or of a polygon, from its upper to its lower vertex.
struct ModelEdge {
    enum class Role { long_edge, upper, lower, of_polygon };
    Role role;
    ModelVertex from;
    ModelVertex to;
    Rational dx_dy = 0; ///< 0 of a horizontal one
};

/// A line that goes in single steps along its major axis.
struct ModelLine {
    Vec<Rational, 2> from{};
    Vec<Rational, 2> to{};
    bool is_x_major = true;
    Index first = 0; ///< column, or row, of the first step
    Index last = 0;  ///< that of the last
    Rational slope = 0;

    // Of Bresenham's line.
    GridPoint start{};
    GridPoint straight{};
    GridPoint diagonal{};
    GridPoint kept{}; ///< of a diagonal step: what of it the next one begins from
    Index steps = 0;
    Index d = 0;
    Index d_straight = 0;
    Index d_diagonal = 0;
};

/// The weights of a triangle's vertices; they sum to 1.
using ModelWeights = std::array<Rational, 3>;

/// A matrix, and the factors that it is the product of; none of a matrix that a mistake has made.
struct ModelMatrix {
    MatrixFactors<Rational> factors;
    Matrix<Rational> product;
};

/// The rules of a scene. Functions refer to it, so it stays where it is.
struct ModelRules {
    explicit ModelRules(Scene of_scene);
    ModelRules(const ModelRules&) = delete;
    ModelRules& operator=(const ModelRules&) = delete;

    using Point2 = Vec<Rational, 2>;
    using Point3 = Vec<Rational, 3>;
    using Point4 = Vec<Rational, 4>;
    using Corners = std::vector<ClipVertex<Rational>>;

    Scene scene;

    // From object space to the screen.
    std::vector<ModelMatrix> models; ///< of the scene's objects
    ModelMatrix view;
    ModelMatrix projection;
    ModelMatrix viewport;
    std::vector<ClipPlane<Rational>> planes;
    std::function<bool(const Corners& unclipped)> drops; ///< a primitive as a whole
    std::function<Point3(const Point4& clip)> divided;
    std::function<Point2(const Point2& screen)> placed;
    bool paints_farthest_first = true; ///< of the painter

    // Faces.
    std::function<Rational(const Point3& normal, const Point3& view)>
        facing; ///< seen if it is above 0
    std::function<double(const Point3& normal, const Point3& light)> intensity;

    // Triangles by rows.
    std::function<ModelTriangle(const ModelTriangle&)> sorted_from_top;
    std::function<Rational(const ModelEdge&)> slope;
    std::function<Rational(const ModelEdge&, Index y)> x_on;
    std::function<std::pair<Index, Index>(const Rational& top, const Rational& bottom)> rows;
    std::function<Index(const ModelTriangle& sorted)> first_lower_row; ///< of the lower short edge
    std::function<std::pair<Index, Index>(const Rational& left, const Rational& right)> span;
    bool draws_outlines = false; ///< as lines, when the triangle is filled

    // Triangles by samples.
    std::optional<Rational>
        sample; ///< from a pixel's integer point, in x and in y; none: as the method says
    std::function<BoundingBox(const ModelTriangle&)> box;
    std::function<bool(const Rational& weight, const ModelVertex& from, const ModelVertex& to,
                       const ModelVertex& opposite)>
        admits; ///< a sample with this weight of the vertex opposite to an edge
    std::function<bool(const ModelTriangle&, GridPoint pixel, const ModelWeights&)> covers;

    // Lines.
    std::function<ModelLine(const Point2& from, const Point2& to)> line;
    std::function<Rational(const ModelLine&, Index along)> across;
    std::function<Color(const GridLine&, GridPoint pixel, Index step, Index steps)> color_of_step;

    // Depths, colors, pixels.
    std::function<Rational(const Rational& distance, const Point4& clip)> depth_of;
    std::optional<Rational> cleared; ///< what the buffer starts with; none: every depth passes
    std::function<bool(const Rational& depth, const std::optional<Rational>& stored)> passes;
    std::function<ModelWeights(const ModelTriangle&, const ModelWeights& on_screen)>
        shares; ///< in a color
    std::function<std::uint8_t(const Rational& channel)> level;
    std::function<std::optional<GridPoint>(GridPoint)>
        beside_canvas; ///< where a pixel off the canvas is stored; none: nowhere
};

/// The farthest coordinate, as typed and in the world, that the model goes to from pixel to pixel: 100,000; 2,000 of
/// triangles that are filled by a fan.
Index farthest_of_model(const Scene& scene);

/// True if no coordinate of a scene is larger than that.
bool has_model(const Scene& scene);

/// Draws a scene by these rules, and tells the listener what is decided by them.
Image draw_by(const ModelRules& rules, const Listener& listener = {});

} // namespace rastertrace
