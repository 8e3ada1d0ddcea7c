// SPDX-License-Identifier: MIT
// C: coverage by edge functions. Samples at the centers of pixels, the top-left rule, y down, 64x64
// unless said.

#include "stress_rows.h"

#include <rastertrace/core/raster/barycentric.h>
#include <rastertrace/core/raster/edge_function.h>
#include <rastertrace/core/raster/triangle.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rastertrace {

namespace {

/// How many of the triangles, each drawn alone, plot the row's pixel; for "reference", how many have it.
std::uint64_t owners_of(const TableRow& row, std::string_view scalar) {
    const Scene scene = row.scene(scalar);
    const JsonElements pixel = row.json.find("pixel")->elements();
    const auto place =
        scene.canvas.offset_of({number_in<int>(pixel[0].text), number_in<int>(pixel[1].text)});
    std::uint64_t owners = 0;
    for (std::size_t i = 0; i < scene.primitives.size(); ++i) {
        const bool has_pixel = scalar == "reference" ? covered_by(exact_corners(scene, i),
                                                                  scene.method, scene.canvas)[place]
                                                     : drawn_alone(scene, i)[place] != no_color;
        owners += has_pixel ? 1 : 0;
    }
    return owners;
}

Measured owners(const TableRow& row, std::string_view scalar) {
    return counted_as(row, owners_of(row, scalar));
}

Measured further_owners(const TableRow& row, std::string_view scalar) {
    return {.wrong = owners_of(row, scalar) - 1, .unit = "owner"};
}

/// C5: the exact pictures of the scene and of its vertices on a grid of 1/16.
Measured coarse_grid(const TableRow& row, std::string_view scalar) {
    const Scene scene = row.scene(scalar);
    return {.wrong =
                differing(reference_picture(snapped_to_grid(scene, 16)), reference_picture(scene)),
            .unit = "pixel",
            .note = "no area"};
}

template <typename Scalar> Triangle<Scalar> triangle_of(const Scene& scene, const Plan& plan) {
    return {{place_of<Scalar>(scene, 0, plan), place_of<Scalar>(scene, 1, plan),
             place_of<Scalar>(scene, 2, plan)}};
}

/// Twice the signed area of a triangle, in the numbers that it is drawn with.
Measured area(const TableRow& row, std::string_view scalar) {
    const Scene scene = row.scene(scalar);
    const Rational found = with_numbers_of(scene, [&scene]<typename Scalar>(const Plan& plan) {
        return exact_value(Barycentric<Scalar>(triangle_of<Scalar>(scene, plan)).area2());
    });
    return {.wrong = found == exact_area2(exact_corners(scene, 0)) ? 0u : 1u,
            .unit = "area",
            .note = fmt::format("2A = {}", found.get_str())};
}

/// The constant term of the edge function from p to q.
template <typename Scalar> Scalar constant_term(const Vec<Scalar, 2>& p, const Vec<Scalar, 2>& q) {
    const Scalar a = p.y - q.y;
    const Scalar b = q.x - p.x;
    return -(a * p.x) - b * p.y;
}

/// C8: that of the first two vertices.
Measured constant_term_of_edge(const TableRow& row, std::string_view scalar) {
    const Scene scene = row.scene(scalar);
    const Rational found = with_numbers_of(scene, [&scene]<typename Scalar>(const Plan& plan) {
        const auto triangle = triangle_of<Scalar>(scene, plan);
        return exact_value(constant_term<Scalar>(triangle.vertices[0], triangle.vertices[1]));
    });
    return {.wrong = found == -33'554'432 ? 0u : 1u, .unit = "term", .note = found.get_str()};
}

/// C9: the largest extent, in pixels, for which no edge value (the difference of two products of
/// extents) exceeds an integer of "bits", with vertices on a grid of 1/2^"subpixel_bits".
Measured safe_extent(const TableRow& row, std::string_view) {
    const mpz_class largest = (mpz_class(1) << (row.number<unsigned>("bits") - 1)) - 1;
    const mpz_class most = sqrt(mpz_class(largest / 2));
    return counted_as(row, mpz_class(most >> row.number<unsigned>("subpixel_bits")).get_ui());
}

/// C12: the edge function from (0, 0) to b, at b = (0.1, 0.3) itself.
Measured own_vertex(const TableRow&, std::string_view scalar) {
    return with_type(scalar, []<typename Real>() -> Measured {
        const Vec<Real, 2> b{nearest_scalar<Real>(Rational(1, 10)),
                             nearest_scalar<Real>(Rational(3, 10))};
        const Vec<Real, 2> origin{0, 0};
        const Real value = edge_function<Real>({origin, 0}, {b, 1}).at(b);
        return {.wrong = value == 0 ? 0u : 1u, .unit = "value"};
    });
}

/// C12: the same by a fused multiply-add.
Measured fused_edge(const TableRow&, std::string_view scalar) {
    return with_real(scalar, []<typename Real>() -> Measured {
        const auto x = nearest_scalar<Real>(Rational(1, 10));
        const auto y = nearest_scalar<Real>(Rational(3, 10));
        const Real value = std::fma(x, y, -(y * x));
        return {.wrong = value == 0 ? 0u : 1u,
                .unit = "value",
                .worst = std::abs(static_cast<double>(value)),
                .worst_unit = "px^2"};
    });
}

/// C12: the same for 10,000 vertices on a grid of 1/10, seen from (1/10, 1/10).
template <bool is_fused> Measured edges_on_grid(const TableRow&, std::string_view scalar) {
    return with_real(scalar, []<typename Real>() {
        Measured measured{.unit = "value", .note = "of 10000"};
        for (int i = 1; i <= 100; ++i)
            for (int k = 1; k <= 100; ++k) {
                const Real x = static_cast<Real>(i) * static_cast<Real>(0.1);
                const Real y = static_cast<Real>(k) * static_cast<Real>(0.1);
                const Real value = is_fused ? std::fma(x, y, -(y * x)) : x * y - y * x;
                measured.wrong += value == 0 ? 0 : 1;
            }
        return measured;
    });
}

/// C15: two triangles PMB and MQB below an edge PQ, and one, PQT, above; M lies next to PQ, not on it. The samples in
/// the hull of P, T, Q and B that are in none of the triangles, or those in more than one.
template <bool is_gap> Measured junction(const TableRow& row, std::string_view scalar) {
    const Scene scene = row.scene(scalar);
    std::vector<int> layers(scene.canvas.area());
    for (std::size_t i = 0; i < scene.primitives.size(); ++i) {
        const auto picture = drawn_alone(scene, i);
        for (std::size_t place = 0; place < picture.size(); ++place)
            layers[place] += picture[place] == no_color ? 0 : 1;
    }
    // The hull without M: P, T, Q, B. What an edge of it excludes belongs to nobody.
    const auto at = [&scene](std::size_t vertex) {
        return ExactPoint{scene.vertices[vertex].x.exact(), scene.vertices[vertex].y.exact()};
    };
    const auto hull = covered_by_polygon({at(0), at(2), at(1), at(4)}, scene.canvas);
    const auto width = static_cast<std::size_t>(scene.canvas.width);
    Measured measured{.unit = "pixel"};
    for (std::size_t i = 0; i < layers.size(); ++i)
        if ((is_gap ? hull[i] && layers[i] == 0 : layers[i] > 1) && ++measured.wrong == 1)
            measured.note = fmt::format("({}, {})", i % width, i / width);
    return measured;
}

/// A picture moved on its canvas; what was outside comes in empty.
Colors moved_picture(const Colors& picture, const Canvas& canvas, int right, int down) {
    Colors moved(picture.size(), no_color);
    for (int row = 0; row < canvas.height; ++row)
        for (int column = 0; column < canvas.width; ++column) {
            const int from_row = row - down;
            const int from_column = column - right;
            if (0 <= from_row && from_row < canvas.height && 0 <= from_column &&
                from_column < canvas.width)
                moved[static_cast<std::size_t>(row * canvas.width + column)] =
                    picture[static_cast<std::size_t>(from_row * canvas.width + from_column)];
        }
    return moved;
}

/// C17: a triangle's vertices in each order, moved by whole pixels: the pixels that are not those of the still one,
/// moved.
Measured orders_and_places(const TableRow& row, std::string_view scalar) {
    const Scene still = row.scene("exact");
    const auto reference = reference_picture(still);
    const auto corners = exact_corners(still, 0);
    Measured measured{.unit = "pixel", .note = "18 pictures"};
    for (const auto& [right, down] : {std::pair{0, 0}, std::pair{29, 7}, std::pair{-3, -1}}) {
        const auto expected = moved_picture(reference, still.canvas, right, down);
        std::array<std::size_t, 3> order{0, 1, 2};
        do {
            Scene moved = row.scene(scalar);
            for (std::size_t i = 0; i < 3; ++i) {
                moved.vertices[i].x = Number::fraction(corners[order[i]].x + right);
                moved.vertices[i].y = Number::fraction(corners[order[i]].y + down);
            }
            measured.wrong += differing(drawn_picture(moved), expected);
        } while (std::next_permutation(order.begin(), order.end()));
    }
    return measured;
}

/// C17: twice the area of the triangle in float, moved to the right by "shift".
Measured moved_area(const TableRow& row, std::string_view) {
    const auto corners = exact_corners(row.scene({}), 0);
    const auto shift = row.number<float>("shift");
    Triangle<float> triangle{};
    for (std::size_t i = 0; i < 3; ++i)
        triangle.vertices[i] = {shift + nearest_float(corners[i].x), nearest_float(corners[i].y)};
    const Rational found = exact_value(Barycentric<float>(triangle).area2());
    const Rational exact = exact_area2(corners);
    return {.wrong = found == exact ? 0u : 1u,
            .unit = "area",
            .note = fmt::format("2A = {}, exactly {}", found.get_str(), exact.get_str())};
}

constexpr auto measures_of_edge_functions = std::to_array<NamedMeasure>({
    {"owners", owners},
    {"further owners", further_owners},
    {"coarse grid", coarse_grid},
    {"area", area},
    {"constant term", constant_term_of_edge},
    {"safe extent", safe_extent},
    {"own vertex", own_vertex},
    {"fused edge", fused_edge},
    {"edges on a grid", edges_on_grid<false>},
    {"fused edges on a grid", edges_on_grid<true>},
    {"gap", junction<true>},
    {"overlap", junction<false>},
    {"orders and places", orders_and_places},
    {"moved area", moved_area},
});

} // namespace

std::span<const NamedMeasure> edge_function_measures() {
    return measures_of_edge_functions;
}

} // namespace rastertrace
