// SPDX-License-Identifier: MIT
// Where the vertices are in the world, exactly: what a camera is fitted to.

#include <rastertrace/core/draw/list/geometry.h>

#include <rastertrace/core/numbers/irrational.h>
#include <rastertrace/core/transform/matrix.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace rastertrace {

namespace {

/// Places as whole numbers over one denominator: fractions would be reduced in each of their sums.
struct WholePlaces {
    std::vector<std::array<mpz_class, 3>> above;
    mpz_class below = 1;
};

/// The vertices first .. end - 1 that are used, moved by a matrix.
WholePlaces whole_places(const Scene& scene, const std::vector<bool>& is_used, std::size_t first,
                         std::size_t end, const Matrix<Rational>& matrix) {
    WholePlaces places;
    std::vector<std::array<Rational, 3>> typed;
    mpz_class below_typed = 1;
    for (std::size_t i = first; i < end; ++i) {
        if (!is_used[i])
            continue;
        const SceneVertex& vertex = scene.vertices[i];
        typed.push_back({vertex.x.exact(), vertex.y.exact(), vertex.z.exact()});
        for (const Rational& coordinate : typed.back())
            below_typed = lcm(below_typed, coordinate.get_den());
    }
    mpz_class below_matrix = 1;
    for (const auto& row : matrix.rows)
        for (const Rational& entry : row)
            below_matrix = lcm(below_matrix, entry.get_den());
    const auto whole = [](const Rational& value, const mpz_class& below) {
        return mpz_class(value.get_num() * (below / value.get_den()));
    };

    std::array<std::array<mpz_class, 4>, 3> rows;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            rows[i][j] = whole(matrix.rows[i][j], below_matrix);
    places.below = below_matrix * below_typed;
    for (const auto& [x, y, z] : typed) {
        const mpz_class whole_x = whole(x, below_typed);
        const mpz_class whole_y = whole(y, below_typed);
        const mpz_class whole_z = whole(z, below_typed);
        auto& place = places.above.emplace_back();
        for (std::size_t i = 0; i < 3; ++i)
            place[i] = rows[i][0] * whole_x + rows[i][1] * whole_y + rows[i][2] * whole_z +
                       rows[i][3] * below_typed;
    }
    return places;
}

/// Calls `visit` with the places in the world, from `origin`, of each object that has any.
template <typename Visit>
void for_each_object(const Scene& scene, const Vec<Rational, 3>& origin, Visit&& visit) {
    const std::vector<bool> is_used = used_vertices(scene);
    const auto from_origin = translation<Rational>(Vec<Rational, 3>{} - origin);
    std::size_t first = 0;
    const auto visit_next = [&](std::size_t end, const Matrix<Rational>& model) {
        const WholePlaces places = whole_places(scene, is_used, first, end, from_origin * model);
        if (!places.above.empty())
            visit(places);
        first = end;
    };
    for (const SceneObject& object : scene.objects)
        visit_next(object.end_vertex, object.model.matrix());
    visit_next(scene.vertices.size(), identity<Rational>());
}

} // namespace

Box world_box(const Scene& scene) {
    std::optional<Box> box;
    for_each_object(scene, {}, [&box](const WholePlaces& places) {
        std::array<mpz_class, 3> low = places.above.front();
        std::array<mpz_class, 3> high = low;
        for (const auto& place : places.above)
            for (std::size_t i = 0; i < 3; ++i) {
                low[i] = std::min(low[i], place[i]);
                high[i] = std::max(high[i], place[i]);
            }
        for (const auto& corner : {low, high})
            include(box,
                    {quotient_of(corner[0], places.below), quotient_of(corner[1], places.below),
                     quotient_of(corner[2], places.below)});
    });
    return *box;
}

Rational farthest_square(const Scene& scene, const Vec<Rational, 3>& center) {
    Rational farthest = 0;
    for_each_object(scene, center, [&farthest](const WholePlaces& places) {
        mpz_class square = 0;
        for (const auto& [x, y, z] : places.above)
            square = std::max<mpz_class>(square, x * x + y * y + z * z);
        farthest = std::max(farthest, quotient_of(square, mpz_class(places.below * places.below)));
    });
    return farthest;
}

} // namespace rastertrace
