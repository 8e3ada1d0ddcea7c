// SPDX-License-Identifier: MIT
#pragma once

// What is decided about a scene before the first pixel: the type of number that it is drawn with.
//
//     const Plan plan = plan_for(scene);
//     with_scalar(plan, [&]<typename Scalar>() { draw<Scalar>(scene, plan, sink); });

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

/// How many bits the scanline fill needs beyond those of its input, in fractions over a common
/// denominator. With coordinates n/D, |n| < 2^b and D <= 2^d, an edge is at
///
///     x = n1/D + (dx/dy) ((y D - n0)/D),   so   |numerator| < 2^(2b + d + 3),  denominator < 2^(b
///     + 2d + 1)
///
/// and comparing it with a vertex or doubling its distance to a pixel multiplies by D or by 4.
inline int bits_of_scanline(int numerator_bits, int denominator_bits) {
    return 2 * numerator_bits + 2 * denominator_bits + 6;
}

/// The narrowest exact type in which no step of the fill can overflow, for all of the scene.
inline Plan plan_of_exact_numbers(const Scene& scene) {
    const Plan any_size{.number = NumberType::rational};

    // The least common multiple of the denominators as typed.
    std::int64_t common = 1;
    const auto for_each_number = [&scene](auto&& f) {
        for (const SceneVertex& vertex : scene.vertices)
            if (!f(vertex.x) || !f(vertex.y))
                return false;
        return true;
    };
    const bool has_common = for_each_number([&common](const Number& number) {
        const auto denominator = number.denominator();
        return denominator && !__builtin_mul_overflow(common / std::gcd(common, *denominator),
                                                      *denominator, &common);
    });
    if (!has_common)
        return any_size;

    // The largest numerator over it.
    std::uint64_t largest = 0;
    const bool all_fit = for_each_number([&largest, common](const Number& number) {
        const auto numerator = number.numerator_over(common);
        if (!numerator || *numerator == std::numeric_limits<std::int64_t>::min())
            return false;
        largest = std::max(largest, static_cast<std::uint64_t>(std::llabs(*numerator)));
        return true;
    });
    if (!all_fit)
        return any_size;

    const auto numerator_bits = static_cast<int>(std::bit_width(largest));
    const auto denominator_bits =
        static_cast<int>(std::bit_width(static_cast<std::uint64_t>(common - 1)));
    const int bits = bits_of_scanline(numerator_bits, denominator_bits);
    if (bits < 64)
        return {.number = NumberType::fraction64, .denominator = common};
    if (bits < 128)
        return {.number = NumberType::fraction128, .denominator = common};
    return any_size;
}

/// Decides how a scene is drawn, from the scene alone.
inline Plan plan_for(const Scene& scene) {
    switch (scene.method.scalar) {
    case ScalarKind::exact:
        return plan_of_exact_numbers(scene);
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

/// Two vertices (or one, twice) that a double cannot draw between.
struct Overflow {
    enum class What {
        coordinate, ///< beyond 2^1022: the difference of two such numbers may be infinite
        slope,      ///< dx/dy is beyond the largest double
    };
    What what;
    std::size_t from; ///< place in Scene::vertices
    std::size_t to;
};

/// The first place where drawing the scene in double would make an infinity, if there is one.
/// Exact numbers cannot overflow.
inline std::optional<Overflow> find_overflow(const Scene& scene) {
    if (scene.method.scalar != ScalarKind::double_precision)
        return std::nullopt;

    const double largest = std::ldexp(1.0, 1022);
    for (const SceneTriangle& triangle : scene.triangles) {
        for (const std::size_t place : triangle.vertices) {
            const SceneVertex& vertex = scene.vertices[place];
            if (std::abs(vertex.x.nearest_double()) > largest ||
                std::abs(vertex.y.nearest_double()) > largest)
                return Overflow{Overflow::What::coordinate, place, place};
        }
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t from = triangle.vertices[i];
            const std::size_t to = triangle.vertices[(i + 1) % 3];
            const double dx =
                scene.vertices[to].x.nearest_double() - scene.vertices[from].x.nearest_double();
            const double dy =
                scene.vertices[to].y.nearest_double() - scene.vertices[from].y.nearest_double();
            if (dy != 0 && !std::isfinite(dx / dy))
                return Overflow{Overflow::What::slope, from, to};
        }
    }
    return std::nullopt;
}

} // namespace rastertrace
