// SPDX-License-Identifier: MIT
#pragma once

// What is decided about a scene before the first pixel: the type of number that it is drawn with.
//
//     const Plan plan = plan_for(scene);
//     with_scalar(plan, [&]<typename Scalar>() { draw<Scalar>(scene, plan, sink); });

#include <rastertrace/core/barycentric.h>
#include <rastertrace/core/fill_fan.h>
#include <rastertrace/core/scalar.h>
#include <rastertrace/core/scene.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace rastertrace {

/// The C++ type that stands for the scene's kind of scalar.
enum class NumberType { binary64, fraction64, fraction128, rational };

/// The decisions taken before drawing.
struct Plan {
    NumberType number = NumberType::binary64;
    std::int64_t denominator = 1; ///< common to all coordinates, when they are fractions
};

/// The grid that `fixed` snaps to: 1/256 pixel, as graphics hardware does.
inline constexpr std::int64_t fixed_grid = 256;

/// How many bits drawing needs, in fractions over a common denominator. With coordinates n/D, |n| <
/// 2^b and D <= 2^d, an edge is at
///
///     x = n1/D + (dx/dy) ((y D - n0)/D),
///     so   |numerator| < 2^(2b + d + 3),   denominator < 2^(b + 2d + 1)
///
/// and comparing it with a vertex, or its distance to a sample with a half, multiplies by 2D or
/// by 8. A naive line has the denominator of the slope twice. Mixing colors multiplies a weight, a
/// quotient of two areas, by 255 three times.
inline int bits_of_drawing(const Scene& scene, int numerator_bits, int denominator_bits) {
    const int of_edges = 2 * numerator_bits + 2 * denominator_bits + 8;
    const int of_weights = 2 * numerator_bits + denominator_bits + 18;
    const bool has_lines = scene.has(PrimitiveKind::line) || scene.has(PrimitiveKind::outline);
    const int of_lines = has_lines && scene.method.line == LineMethod::naive
                             ? 3 * numerator_bits + 2 * denominator_bits + 8
                             : 0;
    return std::max({of_edges, of_weights, of_lines});
}

/// Calls `is_fine` with every coordinate until one is not; true if all are.
template <typename IsFine> bool all_numbers(const Scene& scene, IsFine&& is_fine) {
    return std::all_of(scene.vertices.begin(), scene.vertices.end(),
                       [&](const SceneVertex& one) { return is_fine(one.x) && is_fine(one.y); });
}

/// The narrowest type of fractions over `denominator` in which no step of drawing can overflow.
inline Plan plan_of_fractions(const Scene& scene, std::int64_t denominator) {
    std::uint64_t largest = 0;
    const bool all_fit = all_numbers(scene, [&largest, denominator](const Number& number) {
        auto numerator = number.numerator_over(denominator);
        if (!numerator)
            numerator = number.nearest_numerator_over(denominator);
        if (!numerator || *numerator == std::numeric_limits<std::int64_t>::min())
            return false;
        largest = std::max(largest, static_cast<std::uint64_t>(std::llabs(*numerator)));
        return true;
    });
    const int bits = bits_of_drawing(
        scene, static_cast<int>(std::bit_width(largest)),
        static_cast<int>(std::bit_width(static_cast<std::uint64_t>(denominator - 1))));
    if (!all_fit || bits >= 128)
        return {.number = NumberType::rational};
    return {.number = bits < 64 ? NumberType::fraction64 : NumberType::fraction128,
            .denominator = denominator};
}

/// The narrowest exact type in which no step of the fill can overflow, for all of the scene.
inline Plan plan_of_exact_numbers(const Scene& scene) {
    const Plan any_size{.number = NumberType::rational};

    // The least common multiple of the denominators as typed, and of the sample point's.
    std::int64_t common = sample_of(scene.method) == Sample::center ? 2 : 1;
    const bool has_common = all_numbers(scene, [&common](const Number& number) {
        const auto denominator = number.denominator();
        return denominator && !__builtin_mul_overflow(common / std::gcd(common, *denominator),
                                                      *denominator, &common);
    });
    if (!has_common)
        return any_size;

    return plan_of_fractions(scene, common);
}

/// Decides how a scene is drawn, from the scene alone.
inline Plan plan_for(const Scene& scene) {
    switch (scene.method.scalar) {
    case ScalarKind::exact:
        return plan_of_exact_numbers(scene);
    case ScalarKind::fixed:
        return plan_of_fractions(scene, fixed_grid);
    case ScalarKind::double_precision:
        break;
    }
    return {};
}

/// Calls `draw_with.template operator()<Scalar>()` with the scalar that the plan has chosen.
template <typename DrawWith> decltype(auto) with_scalar(const Plan& plan, DrawWith&& draw_with) {
    switch (plan.number) {
    case NumberType::fraction64:
        return draw_with.template operator()<Fraction64>();
    case NumberType::fraction128:
        return draw_with.template operator()<Fraction128>();
    case NumberType::rational:
        return draw_with.template operator()<Rational>();
    case NumberType::binary64:
        break;
    }
    return draw_with.template operator()<double>();
}

/// Why a scene cannot be drawn by its method, and between which vertices.
struct Unfit {
    enum class What {
        coordinate_of_double, ///< beyond 2^1022: the difference of two such numbers may be infinite
        slope_of_double,      ///< dx/dy or dy/dx is beyond the largest double
        coordinate_of_weights, ///< beyond 2^500: a product of two such numbers may be infinite
        area_of_weights,       ///< so small that a weight of a pixel may be infinite
        coordinate_of_fixed,   ///< beyond 2^36 pixels: edges could not be evaluated in 128 bits
        coordinate_of_line,    ///< beyond 2^51 pixels: Bresenham's d could not be held in 64 bits
        edge_of_fan,           ///< longer than longest_fan_edge
    };
    What what;
    std::size_t from; ///< place in Scene::vertices
    std::size_t to;
};

/// True if, in double, some pixel of the canvas may have an infinite weight in a triangle: a weight
/// is a quotient of two areas, and the triangle's own may be almost 0.
inline bool weights_may_overflow(const Scene& scene, const ScenePrimitive& primitive) {
    Triangle<double> triangle{};
    double extent = largest_canvas_side;
    for (std::size_t i = 0; i < 3; ++i) {
        const SceneVertex& vertex = scene.vertices[primitive.vertices[i]];
        triangle.vertices[i] = {vertex.x.nearest_double(), vertex.y.nearest_double()};
        extent =
            std::max({extent, std::abs(triangle.vertices[i].x), std::abs(triangle.vertices[i].y)});
    }
    const double area2 = Barycentric<double>(triangle).area2();
    return area2 != 0 && !std::isfinite(16 * extent * extent / area2);
}

/// The first place where drawing the scene would make an infinity or overflow, if there is one.
inline std::optional<Unfit> find_unfit(const Scene& scene) {
    using What = Unfit::What;
    const bool in_double = scene.method.scalar == ScalarKind::double_precision;
    const double largest = in_double ? std::ldexp(1.0, 1022)
                           : scene.method.scalar == ScalarKind::fixed
                               ? std::ldexp(1.0, 36)
                               : std::numeric_limits<double>::max();
    const bool mixes_colors = scene.mixes_colors();
    for (const ScenePrimitive& primitive : scene.primitives) {
        const bool has_weights = in_double && primitive.kind == PrimitiveKind::triangle &&
                                 (mixes_colors || scene.method.fill == Fill::barycentric ||
                                  scene.method.fill == Fill::top_left);
        const bool is_fan =
            primitive.kind == PrimitiveKind::triangle && scene.method.fill == Fill::fan;
        const bool is_on_grid = is_fan || (primitive.kind != PrimitiveKind::triangle &&
                                           scene.method.line == LineMethod::bresenham);
        const auto corners = primitive.corners();
        for (const std::size_t place : corners) {
            const SceneVertex& vertex = scene.vertices[place];
            const double farthest =
                std::max(std::abs(vertex.x.nearest_double()), std::abs(vertex.y.nearest_double()));
            if (farthest > largest)
                return Unfit{in_double ? What::coordinate_of_double : What::coordinate_of_fixed,
                             place, place};
            if (has_weights && farthest > std::ldexp(1.0, 500))
                return Unfit{What::coordinate_of_weights, place, place};
            if (is_on_grid && farthest > std::ldexp(1.0, 51))
                return Unfit{What::coordinate_of_line, place, place};
        }
        if (has_weights && weights_may_overflow(scene, primitive))
            return Unfit{What::area_of_weights, corners[0], corners[2]};
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const std::size_t from = corners[i];
            const std::size_t to = corners[(i + 1) % corners.size()];
            const double dx =
                scene.vertices[to].x.nearest_double() - scene.vertices[from].x.nearest_double();
            const double dy =
                scene.vertices[to].y.nearest_double() - scene.vertices[from].y.nearest_double();
            if (in_double && dy != 0 && !std::isfinite(dx / dy))
                return Unfit{What::slope_of_double, from, to};
            const auto longest = static_cast<double>(longest_fan_edge);
            if (is_fan && (std::abs(dx) > longest || std::abs(dy) > longest))
                return Unfit{What::edge_of_fan, from, to};
        }
    }
    return std::nullopt;
}

} // namespace rastertrace
