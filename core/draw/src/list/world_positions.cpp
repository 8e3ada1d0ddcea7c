// SPDX-License-Identifier: MIT
// The exact positions of vertices in the world, which a camera is fitted to.

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

/// Positions as whole numbers over one denominator. GMP would reduce a fraction after each sum.
struct WholePositions {
    std::vector<std::array<mpz_class, 3>> numerators;
    mpz_class denominator = 1;
};

/// The vertices first .. end - 1 that are used, moved by a matrix.
WholePositions whole_positions(const Scene& scene, const std::vector<bool>& is_used,
                               std::size_t first, std::size_t end, const Matrix<Rational>& matrix) {
    WholePositions positions;
    std::vector<std::array<Rational, 3>> typed;
    mpz_class typed_denominator = 1;
    for (std::size_t i = first; i < end; ++i) {
        if (!is_used[i])
            continue;
        const SceneVertex& vertex = scene.vertices[i];
        typed.push_back({vertex.x.exact(), vertex.y.exact(), vertex.z.exact()});
        for (const Rational& coordinate : typed.back())
            typed_denominator = lcm(typed_denominator, coordinate.get_den());
    }
    const auto [whole_matrix, matrix_denominator] = over_one_denominator(matrix);
    const auto whole = [](const Rational& value, const mpz_class& denominator) {
        return mpz_class(value.get_num() * (denominator / value.get_den()));
    };

    const auto& rows = whole_matrix.rows;
    positions.denominator = matrix_denominator * typed_denominator;
    for (const auto& [x, y, z] : typed) {
        const mpz_class whole_x = whole(x, typed_denominator);
        const mpz_class whole_y = whole(y, typed_denominator);
        const mpz_class whole_z = whole(z, typed_denominator);
        auto& position = positions.numerators.emplace_back();
        for (std::size_t i = 0; i < 3; ++i)
            position[i] = rows[i][0] * whole_x + rows[i][1] * whole_y + rows[i][2] * whole_z +
                          rows[i][3] * typed_denominator;
    }
    return positions;
}

/// Calls `visit` with the positions of each object in the world, relative to `origin`. An object
/// without vertices is left out.
template <typename Visit>
void for_each_object(const Scene& scene, const Vec<Rational, 3>& origin, Visit&& visit) {
    const std::vector<bool> is_used = used_vertices(scene);
    const auto from_origin = translation<Rational>(Vec<Rational, 3>{} - origin);
    std::size_t first = 0;
    const auto visit_next = [&](std::size_t end, const Matrix<Rational>& model) {
        const WholePositions positions =
            whole_positions(scene, is_used, first, end, from_origin * model);
        if (!positions.numerators.empty())
            visit(positions);
        first = end;
    };
    for (const SceneObject& object : scene.objects)
        visit_next(object.end_vertex, object.model.matrix());
    visit_next(scene.vertices.size(), identity<Rational>());
}

} // namespace

Box world_box(const Scene& scene) {
    std::optional<Box> box;
    for_each_object(scene, {}, [&box](const WholePositions& positions) {
        std::array<mpz_class, 3> low = positions.numerators.front();
        std::array<mpz_class, 3> high = low;
        for (const auto& position : positions.numerators)
            for (std::size_t i = 0; i < 3; ++i) {
                low[i] = std::min(low[i], position[i]);
                high[i] = std::max(high[i], position[i]);
            }
        for (const auto& corner : {low, high})
            include(box, {quotient_of(corner[0], positions.denominator),
                          quotient_of(corner[1], positions.denominator),
                          quotient_of(corner[2], positions.denominator)});
    });
    return *box;
}

Rational farthest_square(const Scene& scene, const Vec<Rational, 3>& center) {
    Rational farthest = 0;
    for_each_object(scene, center, [&farthest](const WholePositions& positions) {
        mpz_class square = 0;
        for (const auto& [x, y, z] : positions.numerators)
            square = std::max<mpz_class>(square, x * x + y * y + z * z);
        farthest =
            std::max(farthest,
                     quotient_of(square, mpz_class(positions.denominator * positions.denominator)));
    });
    return farthest;
}

} // namespace rastertrace
