// SPDX-License-Identifier: MIT
#include "reference.h"

#include <rastertrace/core/draw/model/model.h>

#include <algorithm>
#include <functional>
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

/// The nearest whole number, of two the larger one, or the smaller one.
mpz_class nearest_of(const Rational& x, bool goes_up) {
    const Rational half(1, 2);
    return goes_up ? floor_of(x + half) : ceil_of(x - half);
}

/// Bresenham's line: a pixel for each whole number along the major axis, the other coordinate exact and rounded.
void draw_line(const Scene& scene, const ScenePrimitive& line, Colors& picture) {
    const Rational offset = offset_of(sample_of_lines(scene.method)).exact();
    const auto whole = [&](std::size_t i) {
        const SceneVertex& vertex = scene.vertices[line.vertices[i]];
        return std::pair(nearest_of(vertex.x.exact() - offset, true),
                         nearest_of(vertex.y.exact() - offset, true));
    };
    auto [from_x, from_y] = whole(0);
    auto [to_x, to_y] = whole(1);
    const bool is_x_major = abs(to_x - from_x) >= abs(to_y - from_y);
    if (!is_x_major) {
        std::swap(from_x, from_y);
        std::swap(to_x, to_y);
    }
    const bool begins_at_to = scene.method.from == LineStart::low && to_x < from_x;
    const bool falls = to_y < from_y;
    const Ties ties = line_rules(scene.method).ties;
    const bool goes_up =
        ties == Ties::up && traits_of(scene.method.line).rule == LineRule::rounding;
    const bool stays = ties != Ties::step; // on the side that it comes from

    // Only what the canvas can have.
    const Canvas& canvas = scene.canvas;
    const int low = is_x_major ? canvas.left() : std::min(canvas.top(), canvas.bottom());
    const int high = is_x_major ? canvas.right() : std::max(canvas.top(), canvas.bottom());
    const mpz_class first = std::max<mpz_class>(std::min(from_x, to_x), low);
    const mpz_class last = std::min<mpz_class>(std::max(from_x, to_x), high);
    for (mpz_class along = first; along <= last; ++along) {
        // What is drawn last may be left out.
        if (scene.method.ends == EndPixels::first && along == (begins_at_to ? from_x : to_x))
            continue;
        const Rational across = from_x == to_x
                                    ? Rational(from_y)
                                    : Rational(from_y + Rational(along - from_x) * (to_y - from_y) /
                                                            Rational(to_x - from_x));
        const mpz_class pixel = nearest_of(across, goes_up || stays == falls);
        if (!pixel.fits_sint_p())
            continue;
        const auto a = static_cast<int>(along.get_si());
        const auto b = static_cast<int>(pixel.get_si());
        const Pixel at = is_x_major ? Pixel{a, b} : Pixel{b, a};
        if (canvas.contains(at.x, at.y))
            picture[canvas.offset_of(at)] = line.color;
    }
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
    Scene scene;
    scene.canvas = canvas;
    scene.method = method;
    scene.method.depth = Depth::none;
    for (const ExactPoint& p : triangle) {
        SceneVertex& vertex = scene.vertices.emplace_back();
        vertex.x = Number::fraction(p.x);
        vertex.y = Number::fraction(p.y);
    }
    scene.primitives.emplace_back().vertices = {0, 1, 2};
    const Image drawn = draw_by(ModelRules(scene));
    CoveredPixels covered;
    for (const Color color : drawn.colors())
        covered.push_back(color != no_color);
    return covered;
}

/// Of a fan of triangles, each sample belongs to one.
CoveredPixels covered_by_polygon(const std::vector<ExactPoint>& polygon, const Canvas& canvas) {
    CoveredPixels covered(canvas.area());
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const CoveredPixels part =
            covered_by({polygon[0], polygon[i - 1], polygon[i]}, {.fill = Fill::top_left}, canvas);
        std::transform(covered.begin(), covered.end(), part.begin(), covered.begin(),
                       std::logical_or<>());
    }
    return covered;
}

Colors reference_picture(const Scene& scene) {
    const auto drawn = [](const Scene& one) {
        const Image image = draw_by(ModelRules(one));
        return Colors(image.colors().begin(), image.colors().end());
    };
    // It samples other lines where the canvas is, and walks along Bresenham's.
    if (has_model(scene) || scene.method.line != LineMethod::bresenham)
        return drawn(scene);
    Scene without_lines = scene;
    std::erase_if(without_lines.primitives,
                  [](const ScenePrimitive& one) { return one.kind == PrimitiveKind::line; });
    Colors picture = drawn(without_lines);
    for (const ScenePrimitive& primitive : scene.primitives)
        if (primitive.kind == PrimitiveKind::line)
            draw_line(scene, primitive, picture);
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
