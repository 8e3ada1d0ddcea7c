// SPDX-License-Identifier: MIT
// The right rules of the model: a method's choices, each in its formula.

#include <rastertrace/core/draw/model/model.h>

#include <rastertrace/core/draw/list/geometry.h>
#include <rastertrace/core/draw/list/light.h>
#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/raster/line_sampling.h>
#include <rastertrace/core/raster/shading.h>

#include <cstdlib>
#include <utility>

namespace rastertrace {

namespace {

Index sign(Index number) {
    return number < 0 ? -1 : 1;
}

/// The column or row of a coordinate that `snap` moves to a whole one.
Rational snapped(const Rational& x, const Method& method) {
    switch (method.snap) {
    case Snap::floor:
        return floor_index(x);
    case Snap::truncate:
        return truncate_index(x);
    case Snap::nearest:
        return nearest_index(x, method.ties.value_or(Ties::up));
    case Snap::none:
        break;
    }
    return x;
}

} // namespace

ModelRules::ModelRules(Scene of_scene) : scene(std::move(of_scene)) {
    const Method& method = scene.method;
    const Canvas& canvas = scene.canvas;

    // Matrices and planes as the scene says them.
    for (const SceneObject& object : scene.objects)
        models.push_back({factors_of(object.model.steps()), object.model.matrix()});
    const ViewAxis axis = view_axis_of(scene.projection.type);
    view = scene.camera
               ? ModelMatrix{factors_of(*scene.camera, axis), view_matrix(*scene.camera, axis)}
               : ModelMatrix{{}, identity<Rational>()};
    projection.factors = scene.projection.type == ProjectionType::none ||
                                 scene.projection.type == ProjectionType::clip_space
                             ? MatrixFactors<Rational>()
                             : factors_of(scene.projection, canvas);
    viewport.factors = scene.viewport.type == ViewportType::none
                           ? MatrixFactors<Rational>()
                           : factors_of(scene.viewport, canvas);
    for (ModelMatrix* const matrix : {&projection, &viewport})
        matrix->product = product_of(matrix->factors);
    planes = clip_planes(scene.projection, half_extent(scene.viewport, canvas.width),
                         half_extent(scene.viewport, canvas.height), guard_band);
    drops = [](const auto&) { return false; };
    divided = [](const Vec<Rational, 4>& clip) {
        return Vec<Rational, 3>{clip.x / clip.w, clip.y / clip.w, clip.z / clip.w};
    };
    placed = [&method](const Vec<Rational, 2>& screen) {
        return Vec<Rational, 2>{snapped(screen.x, method), snapped(screen.y, method)};
    };

    // A face is seen if normal . view > 0; it is as bright as the cosine of its angle to the light.
    facing = [](const auto& normal, const auto& to_eye) { return dot(normal, to_eye); };
    intensity = [](const Vec<Rational, 3>& normal, const Vec<Rational, 3>& light) {
        return std::max(cosine_between(normal, light).value_or(0), 0.0);
    };

    // By rows: vertices from top to bottom, on one height from left to right.
    sorted_from_top = [](ModelTriangle triangle) {
        std::sort(triangle.begin(), triangle.end(), [](const ModelVertex& a, const ModelVertex& b) {
            return a.at.y != b.at.y   ? a.at.y < b.at.y
                   : a.at.x != b.at.x ? a.at.x < b.at.x
                                      : a.index < b.index;
        });
        return triangle;
    };
    slope = [](const ModelEdge& edge) {
        const Rational height = edge.to.at.y - edge.from.at.y;
        return height == 0 ? Rational(0) : Rational((edge.to.at.x - edge.from.at.x) / height);
    };
    x_on = [](const ModelEdge& edge, Index y) {
        return Rational(edge.from.at.x + edge.dx_dy * (y - edge.from.at.y));
    };
    rows = [&method](const Rational& top, const Rational& bottom) {
        return std::pair{ceil_index(top), rows_of_triangles(method) == RowRule::closed
                                              ? floor_index(bottom)
                                              : ceil_index(bottom) - 1};
    };
    first_lower_row = [](const ModelTriangle& triangle) {
        const auto& [top, middle, bottom] = triangle;
        const bool has_flat_bottom = middle.at.y == bottom.at.y && top.at.y != bottom.at.y;
        return has_flat_bottom ? floor_index(bottom.at.y) + 1 : ceil_index(middle.at.y);
    };
    span = [&method](const Rational& left, const Rational& right) {
        const SpanRounding rule = span_rounding(method);
        return std::pair{first_pixel(left, rule), last_pixel(right, rule)};
    };

    // By samples: a weight of 0 lies on the edge opposite to its vertex.
    box = [](const ModelTriangle& triangle) {
        const auto& [a, b, c] = triangle;
        return BoundingBox{ceil_index(std::min({a.at.x, b.at.x, c.at.x})),
                           floor_index(std::max({a.at.x, b.at.x, c.at.x})),
                           ceil_index(std::min({a.at.y, b.at.y, c.at.y})),
                           floor_index(std::max({a.at.y, b.at.y, c.at.y}))};
    };
    admits = [&method](const Rational& weight, const ModelVertex& from, const ModelVertex& to,
                       const ModelVertex& opposite) {
        if (method.fill == Fill::barycentric)
            return weight >= 0;
        if (weight != 0)
            return weight > 0;
        if (from.at.y == to.at.y)
            return (from.at.y < opposite.at.y) == (method.horizontal_edge == HorizontalEdge::top);
        const Rational x =
            from.at.x + (to.at.x - from.at.x) / (to.at.y - from.at.y) * (opposite.at.y - from.at.y);
        return x < opposite.at.x; // a left edge
    };
    covers = [this](const ModelTriangle& triangle, GridPoint,
                    const std::array<Rational, 3>& weights) {
        for (std::size_t i = 0; i < 3; ++i)
            if (!admits(weights[i], triangle[(i + 1) % 3], triangle[(i + 2) % 3], triangle[i]))
                return false;
        return true;
    };

    // Lines: the major axis is the longer one, x if both are equal.
    line = [&method](const Vec<Rational, 2>& from, const Vec<Rational, 2>& to) {
        ModelLine path{.from = from, .to = to};
        const bool is_on_grid = method.line == LineMethod::bresenham;
        const GridPoint a = nearest_pixel(from, SampleOffset<Rational>());
        const GridPoint b = nearest_pixel(to, SampleOffset<Rational>());
        const Rational dx = is_on_grid ? Rational(b.x - a.x) : Rational(to.x - from.x);
        const Rational dy = is_on_grid ? Rational(b.y - a.y) : Rational(to.y - from.y);
        path.is_x_major = abs(dx) >= abs(dy);
        path.first = path.is_x_major ? a.x : a.y;
        path.last = path.is_x_major ? b.x : b.y;
        if (const Rational& run = path.is_x_major ? dx : dy; run != 0)
            path.slope = (path.is_x_major ? dy : dx) / run;

        const Index columns = b.x - a.x;
        const Index rise = b.y - a.y;
        path.start = a;
        path.diagonal = path.kept = {sign(columns), sign(rise)};
        path.straight = path.is_x_major ? GridPoint{sign(columns), 0} : GridPoint{0, sign(rise)};
        path.steps = std::abs(path.last - path.first);
        const Index minor = std::min(std::abs(columns), std::abs(rise));
        path.d = 2 * minor - path.steps;
        path.d_straight = 2 * minor;
        path.d_diagonal = 2 * (minor - path.steps);
        return path;
    };
    across = [](const ModelLine& path, Index at) {
        return path.is_x_major ? Rational(path.from.y + path.slope * (at - path.from.x))
                               : Rational(path.from.x + path.slope * (at - path.from.y));
    };
    color_of_step = [&method](const GridLine& path, GridPoint pixel, Index step, Index steps) {
        return color_on_line(path, line_rules(method), pixel, step, steps);
    };

    // Depths at vertices.
    depth_of = [this](const Rational& distance, const Vec<Rational, 4>& clip) -> Rational {
        switch (scene.depth()) {
        case Depth::linear_z:
            return distance;
        case Depth::inverse_z:
            return distance == 0 ? Rational(0) : Rational(1 / distance);
        case Depth::ndc_z:
            return scene.viewport.depths ? Rational(viewport.product.rows[2][2] * divided(clip).z +
                                                    viewport.product.rows[2][3])
                                         : divided(clip).z;
        case Depth::none:
        case Depth::painter:
            break;
        }
        return 0;
    };
    const DepthRule<Rational> rule = depth_rule<Rational>(scene);
    cleared = rule.cleared;
    passes = [larger = rule.larger_passes](const Rational& depth,
                                           const std::optional<Rational>& stored) {
        return !stored || (larger ? *stored < depth : depth < *stored);
    };

    // In a perspective, the share of a vertex is its weight over its w.
    shares = [this](const ModelTriangle& triangle, const std::array<Rational, 3>& on_screen) {
        if (!scene.mixes_in_perspective())
            return on_screen;
        std::array<Rational, 3> in_space;
        for (std::size_t i = 0; i < 3; ++i)
            in_space[i] = on_screen[i] * triangle[i].inverse_w;
        const Rational sum = in_space[0] + in_space[1] + in_space[2];
        if (sum <= 0)
            return on_screen;
        for (Rational& share : in_space)
            share /= sum;
        return in_space;
    };
    level = [&method](const Rational& channel) { return level_of(channel, method.color_rounding); };
}

} // namespace rastertrace
