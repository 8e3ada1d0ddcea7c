// SPDX-License-Identifier: MIT
#include "reference.h"

#include <rastertrace/core/raster/shading.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <utility>

namespace rastertrace {

namespace {

mpz_class floor_of(const Rational& x) {
    mpz_class whole;
    mpz_fdiv_q(whole.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
    return whole;
}

mpz_class ceil_of(const Rational& x) {
    mpz_class whole;
    mpz_cdiv_q(whole.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
    return whole;
}

/// The whole number nearest to x: floor(x + 1/2), but for ties.
mpz_class nearest_of(const Rational& x, Ties ties) {
    const mpz_class up = floor_of(x + Rational(1, 2));
    const mpz_class down = ceil_of(x - Rational(1, 2));
    switch (ties) {
    case Ties::up:
    case Ties::step:
        return up;
    case Ties::start:
        return down;
    case Ties::away:
        return sgn(x) < 0 ? down : up;
    case Ties::even:
        break;
    }
    return mpz_even_p(up.get_mpz_t()) ? up : down;
}

/// E(p) = a x + b y + c of a directed edge.
ExactPlane edge_function(const ExactPoint& p, const ExactPoint& q) {
    const Rational a = p.y - q.y;
    const Rational b = q.x - p.x;
    return {a, b, -a * p.x - b * p.y};
}

/// The functions of a polygon's sides, positive inside. The polygon must have area.
std::vector<ExactPlane> inward_functions(const std::vector<ExactPoint>& polygon) {
    Rational area2 = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const auto& p = polygon[i];
        const auto& q = polygon[(i + 1) % polygon.size()];
        area2 += p.x * q.y - q.x * p.y;
    }
    std::vector<ExactPlane> functions;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        ExactPlane f = edge_function(polygon[i], polygon[(i + 1) % polygon.size()]);
        if (area2 < 0)
            f = {-f.a, -f.b, -f.c};
        // A side of no length is no side.
        if (f.a != 0 || f.b != 0)
            functions.push_back(f);
    }
    return functions;
}

/// Calls `visit(place, sample)` with every pixel of a canvas.
template <typename Visit>
void for_each_sample(const Canvas& canvas, const ExactPoint& offset, Visit&& visit) {
    std::size_t place = 0;
    for (int row = 0; row < canvas.height; ++row)
        for (int column = 0; column < canvas.width; ++column)
            visit(place++, ExactPoint{Rational(canvas.left() + column + offset.x),
                                      Rational(canvas.y_of(row) + offset.y)});
}

CoveredPixels covered_samples(const std::vector<ExactPoint>& polygon, bool is_closed,
                              const ExactPoint& offset, const Canvas& canvas, int down) {
    CoveredPixels covered(canvas.area());
    const auto functions = inward_functions(polygon);
    // On an edge, a sample is inside if the edge is a left one (the inside lies to its right) or a
    // top one (horizontal, and the inside lies below it in the picture).
    const auto admits = [&](const ExactPlane& f, const ExactPoint& sample) {
        const int side = sgn(f.at(sample));
        const bool is_top_left = f.a > 0 || (f.a == 0 && f.b * down > 0);
        return side > 0 || (side == 0 && (is_closed || is_top_left));
    };
    for_each_sample(canvas, offset, [&](std::size_t place, const ExactPoint& sample) {
        covered[place] = std::all_of(functions.begin(), functions.end(),
                                     [&](const ExactPlane& f) { return admits(f, sample); });
    });
    return covered;
}

ExactPoint exact_offset(Sample sample) {
    const Rational offset = offset_of(sample).exact();
    return {offset, offset};
}

/// A triangle as seen from the samples.
std::array<ExactPoint, 3> moved(std::array<ExactPoint, 3> triangle, const ExactPoint& offset) {
    for (ExactPoint& p : triangle)
        p = {Rational(p.x - offset.x), Rational(p.y - offset.y)};
    return triangle;
}

/// Row by row: the part of the row's line that lies in the closed triangle, its ends rounded.
CoveredPixels covered_rows(const std::array<ExactPoint, 3>& triangle, const SpanRounding& rule,
                           const Canvas& canvas) {
    CoveredPixels covered(canvas.area());
    const auto rounded_end = [&rule](const Rational& x, bool is_left) {
        switch (rule.rounding) {
        case Rounding::floor:
            return floor_of(x);
        case Rounding::nearest:
            return nearest_of(x, rule.ties);
        case Rounding::truncate:
            return sgn(x) < 0 ? ceil_of(x) : floor_of(x);
        case Rounding::half_open:
            return is_left ? ceil_of(x) : mpz_class(ceil_of(x) - 1);
        case Rounding::inside:
            break;
        }
        return is_left ? ceil_of(x) : floor_of(x);
    };
    for (int row = 0; row < canvas.height; ++row) {
        const Rational y = canvas.y_of(row);
        std::vector<Rational> meets;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& p = triangle[i];
            const auto& q = triangle[(i + 1) % 3];
            if (p.y == y)
                meets.push_back(p.x);
            if ((p.y < y && y < q.y) || (q.y < y && y < p.y))
                meets.push_back(p.x + (y - p.y) * (q.x - p.x) / (q.y - p.y));
        }
        if (meets.empty())
            continue;
        const auto [left, right] = std::minmax_element(meets.begin(), meets.end());
        const mpz_class first = std::max<mpz_class>(rounded_end(*left, true), canvas.left());
        const mpz_class last = std::min<mpz_class>(rounded_end(*right, false), canvas.right());
        for (mpz_class x = first; x <= last; ++x)
            covered[static_cast<std::size_t>(row) * static_cast<std::size_t>(canvas.width) +
                    static_cast<std::size_t>(x.get_si() - canvas.left())] = true;
    }
    return covered;
}

} // namespace

/// By Cramer's rule.
ExactPlane plane_through(const std::array<ExactPoint, 3>& p, const std::array<Rational, 3>& d) {
    const Rational area2 = exact_area2(p);
    const Rational a =
        ((d[1] - d[0]) * (p[2].y - p[0].y) - (d[2] - d[0]) * (p[1].y - p[0].y)) / area2;
    const Rational b =
        ((d[2] - d[0]) * (p[1].x - p[0].x) - (d[1] - d[0]) * (p[2].x - p[0].x)) / area2;
    return {a, b, d[0] - a * p[0].x - b * p[0].y};
}

namespace {

/// Triangles in the order in which they are drawn.
std::vector<std::size_t> drawing_order(const Scene& scene) {
    std::vector<std::size_t> order;
    std::vector<Rational> keys(scene.primitives.size());
    for (std::size_t i = 0; i < scene.primitives.size(); ++i) {
        if (scene.primitives[i].kind != PrimitiveKind::triangle)
            continue;
        order.push_back(i);
        std::array<Rational, 3> z;
        for (std::size_t k = 0; k < 3; ++k)
            z[k] = scene.vertices[scene.primitives[i].vertices[k]].z.exact();
        keys[i] = scene.method.painter_key == PainterKey::nearest
                      ? *std::min_element(z.begin(), z.end())
                  : scene.method.painter_key == PainterKey::farthest
                      ? *std::max_element(z.begin(), z.end())
                      : Rational((z[0] + z[1] + z[2]) / 3);
    }
    if (scene.depth() == Depth::painter)
        std::stable_sort(order.begin(), order.end(),
                         [&keys](std::size_t a, std::size_t b) { return keys[a] > keys[b]; });
    return order;
}

void draw_triangles(const Scene& scene, Colors& picture) {
    const ExactPoint offset = exact_offset(sample_of(scene.method));
    const Depth depth = scene.depth();
    const bool has_buffer = scene.has_depth_buffer();
    std::vector<std::optional<Rational>> nearest(picture.size());
    for (const std::size_t number : drawing_order(scene)) {
        const ScenePrimitive& primitive = scene.primitives[number];
        const auto corners = exact_corners(scene, number);
        const CoveredPixels covered = covered_by(corners, scene.method, scene.canvas);
        const Color color = scene.shade() == Shade::faces ? color_of_face(number) : primitive.color;

        // The larger, the nearer: 1/z, or -z.
        std::array<Rational, 3> nearness;
        for (std::size_t i = 0; i < 3 && has_buffer; ++i) {
            const Rational z = scene.vertices[primitive.vertices[i]].z.exact();
            nearness[i] = depth == Depth::inverse_z ? Rational(1 / z) : Rational(-z);
        }
        std::optional<ExactPlane> plane;
        if (has_buffer && exact_area2(corners) != 0)
            plane = plane_through(corners, nearness);
        for_each_sample(scene.canvas, offset, [&](std::size_t place, const ExactPoint& sample) {
            if (!covered[place])
                return;
            if (plane) {
                Rational here = plane->at(sample);
                if (nearest[place] && !(here > *nearest[place]))
                    return;
                nearest[place] = std::move(here);
            }
            picture[place] = color;
        });
    }
}

void plot(const Scene& scene, const mpz_class& x, const mpz_class& y, Color color,
          Colors& picture) {
    if (!x.fits_slong_p() || !y.fits_slong_p() || !scene.canvas.contains(x.get_si(), y.get_si()))
        return;
    picture[scene.canvas.offset_of({static_cast<int>(x.get_si()), static_cast<int>(y.get_si())})] =
        color;
}

/// A pixel for each whole number along the major axis, the other coordinate exact and rounded.
void draw_line(const Scene& scene, const ScenePrimitive& line, Colors& picture) {
    const ExactPoint offset = exact_offset(sample_of_lines(scene.method));
    const auto whole = [&](std::size_t i) {
        const SceneVertex& vertex = scene.vertices[line.vertices[i]];
        return std::pair(nearest_of(vertex.x.exact() - offset.x, Ties::up),
                         nearest_of(vertex.y.exact() - offset.y, Ties::up));
    };
    auto [from_x, from_y] = whole(0);
    auto [to_x, to_y] = whole(1);
    const bool is_x_major = abs(to_x - from_x) >= abs(to_y - from_y);
    if (!is_x_major) {
        std::swap(from_x, from_y);
        std::swap(to_x, to_y);
    }

    const bool begins_at_to = scene.method.from == LineStart::low && to_x < from_x;

    // Of a long line, only what the canvas can have.
    const Canvas& canvas = scene.canvas;
    const int low = is_x_major ? canvas.left() : std::min(canvas.top(), canvas.bottom());
    const int high = is_x_major ? canvas.right() : std::max(canvas.top(), canvas.bottom());
    const mpz_class first = std::max<mpz_class>(std::min(from_x, to_x), low);
    const mpz_class last = std::min<mpz_class>(std::max(from_x, to_x), high);
    const bool falls = to_y < from_y;
    const bool is_on_grid = traits_of(scene.method.line).rule == LineRule::grid;
    for (mpz_class along = first; along <= last; ++along) {
        const Rational across = from_x == to_x
                                    ? Rational(from_y)
                                    : Rational(from_y + Rational(along - from_x) * (to_y - from_y) /
                                                            Rational(to_x - from_x));
        // What is drawn last may be left out.
        if (scene.method.ends == EndPixels::first && along == (begins_at_to ? from_x : to_x))
            continue;
        // At a tie Bresenham's line stays on the side that it comes from, or goes to the other one.
        const Ties ties = line_rules(scene.method).ties;
        const bool steps = ties == Ties::step;
        const bool stays = !steps && (is_on_grid || ties == Ties::start);
        const mpz_class pixel =
            nearest_of(across, stays || steps ? (stays == falls ? Ties::up : Ties::start) : ties);
        plot(scene, is_x_major ? along : pixel, is_x_major ? pixel : along, line.color, picture);
    }
}

} // namespace

std::array<ExactPoint, 3> exact_corners(const Scene& scene, std::size_t primitive) {
    std::array<ExactPoint, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
        const SceneVertex& vertex = scene.vertices[scene.primitives[primitive].vertices[i]];
        corners[i] = {vertex.x.exact(), vertex.y.exact()};
    }
    return corners;
}

Rational exact_area2(const std::array<ExactPoint, 3>& t) {
    return (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (t[1].y - t[0].y);
}

CoveredPixels covered_by(const std::array<ExactPoint, 3>& triangle, const Method& method,
                         const Canvas& canvas) {
    const FillTraits fill = traits_of(method.fill);
    const ExactPoint offset = exact_offset(sample_of(method));
    if (fill.rule == PixelRule::row_ends)
        return covered_rows(moved(triangle, offset), span_rounding(method), canvas);
    if (exact_area2(triangle) == 0)
        return CoveredPixels(canvas.area());
    return covered_samples({triangle.begin(), triangle.end()}, fill.is_closed, offset, canvas,
                           canvas_of_samples(method, canvas).down());
}

CoveredPixels covered_by_polygon(const std::vector<ExactPoint>& polygon, const Canvas& canvas) {
    return covered_samples(polygon, false, {Rational(1, 2), Rational(1, 2)}, canvas, canvas.down());
}

Colors reference_picture(const Scene& scene) {
    Colors picture(scene.canvas.area(), no_color);
    draw_triangles(scene, picture);
    for (const ScenePrimitive& primitive : scene.primitives) {
        if (primitive.kind == PrimitiveKind::line)
            draw_line(scene, primitive, picture);
        if (primitive.kind == PrimitiveKind::point) {
            const SceneVertex& at = scene.vertices[primitive.vertices[0]];
            const ExactPoint offset = exact_offset(sample_of_others(scene.method));
            plot(scene, nearest_of(at.x.exact() - offset.x, Ties::up),
                 nearest_of(at.y.exact() - offset.y, Ties::up), primitive.color, picture);
        }
    }
    return picture;
}

Scene snapped_to_grid(Scene scene, int parts) {
    const auto snap = [parts](Number& number) {
        Rational snapped(floor_of(number.exact() * parts + Rational(1, 2)), parts);
        snapped.canonicalize();
        number = Number::fraction(snapped);
    };
    for (SceneVertex& vertex : scene.vertices) {
        snap(vertex.x);
        snap(vertex.y);
    }
    return scene;
}

} // namespace rastertrace
