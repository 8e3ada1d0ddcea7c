// SPDX-License-Identifier: MIT
#pragma once

// Which way a face is turned: to the eye or away, and how much to the light.
//
// The normal of P1, P2, P3 is n = (P2 - P1) x (P3 - P1): outward on a solid whose faces run
// counter-clockwise as seen from outside, in right-handed space. The view leads from the face to the
// eye, and the front is seen if n . view > 0. Taken from the eye to the face, the same test has the
// opposite sign: the mistake of T0's text, where wrong numbers hid a wrong sign.
//
// Sources: T1 (hidden surfaces, normal . toward-the-eye, 0 is culled); T0 with its figures 22 to 28
// put right; T3 (flat shading by n . l).
//
//     is_culled(Cull::back, dot(normal, view));

#include <rastertrace/core/numbers/irrational.h>
#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/scene/method.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace rastertrace {

/// On which side of the line from a to b a point lies, in a plane where y points up: positive left
/// of it, negative right of it, 0 on it. Where y points down, the sides change. Source: T1.
template <typename Scalar>
Scalar left_of(const Vec<Scalar, 2>& a, const Vec<Scalar, 2>& b, const Vec<Scalar, 2>& point) {
    return (b.x - a.x) * (point.y - a.y) - (point.x - a.x) * (b.y - a.y);
}

/// True if a convex polygon runs counter-clockwise where y points up: every vertex lies left of
/// every side that it is not on. Source: T1, "positive orientation".
template <typename Scalar> bool has_positive_orientation(std::span<const Vec<Scalar, 2>> polygon) {
    bool has_area = false;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        for (const auto& vertex : polygon) {
            const Scalar side =
                left_of<Scalar>(polygon[i], polygon[(i + 1) % polygon.size()], vertex);
            if (side < scalar_from<Scalar>(0))
                return false;
            has_area = has_area || scalar_from<Scalar>(0) < side;
        }
    return has_area;
}

/// (b - a) x (c - a): at a right angle to the face, as long as twice its area.
template <typename Scalar>
Vec<Scalar, 3> normal_of(const Vec<Scalar, 3>& a, const Vec<Scalar, 3>& b,
                         const Vec<Scalar, 3>& c) {
    return cross(b - a, c - a);
}

/// The mean of three points.
template <typename Scalar>
Vec<Scalar, 3> centroid_of(const Vec<Scalar, 3>& a, const Vec<Scalar, 3>& b,
                           const Vec<Scalar, 3>& c) {
    const Scalar three = scalar_from<Scalar>(3);
    return {Scalar((a.x + b.x + c.x) / three), Scalar((a.y + b.y + c.y) / three),
            Scalar((a.z + b.z + c.z) / three)};
}

template <typename Scalar> bool has_no_length(const Vec<Scalar, 3>& vector) {
    const Scalar zero = scalar_from<Scalar>(0);
    const bool surely_has_some = surely_differ(vector.x, zero) || surely_differ(vector.y, zero) ||
                                 surely_differ(vector.z, zero);
    return !surely_has_some && vector.x == zero && vector.y == zero && vector.z == zero;
}

/// The cosine of the angle between two vectors, a.b/(|a| |b|); none if one of them has no length.
/// T1 prints the denominator as |a.b|, which leaves only 1, -1 and 0/0.
inline std::optional<double> cosine_between(const Vec<double, 3>& a, const Vec<double, 3>& b) {
    // Each is first brought to a size of about 1, so that no square overflows or vanishes.
    const auto scaled = [](const Vec<double, 3>& v) {
        const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
        // plan.cpp refuses what is not finite.
        const bool has_size = largest > 0 && std::isfinite(largest);
        const int exponent = has_size ? std::ilogb(largest) : 0;
        return Vec<double, 3>{std::scalbn(v.x, -exponent), std::scalbn(v.y, -exponent),
                              std::scalbn(v.z, -exponent)};
    };
    if (has_no_length<double>(a) || has_no_length<double>(b))
        return std::nullopt;
    const auto p = scaled(a);
    const auto q = scaled(b);
    return std::clamp(dot(p, q) / std::sqrt(dot(p, p) * dot(q, q)), -1.0, 1.0);
}
inline std::optional<double> cosine_between(const Vec<float, 3>& a, const Vec<float, 3>& b) {
    return cosine_between(Vec<double, 3>{a.x, a.y, a.z}, Vec<double, 3>{b.x, b.y, b.z});
}
inline std::optional<double> cosine_between(const Vec<Rational, 3>& a, const Vec<Rational, 3>& b) {
    if (has_no_length<Rational>(a) || has_no_length<Rational>(b))
        return std::nullopt;
    const Rational product = dot(a, b);
    const Rational square = product * product / (dot(a, a) * dot(b, b));
    return sgn(product) * nearest_double(square_root(square));
}

inline std::optional<Adaptive> cosine_between(const Vec<Adaptive, 3>& a,
                                              const Vec<Adaptive, 3>& b) {
    if (has_no_length<Adaptive>(a) || has_no_length<Adaptive>(b))
        return std::nullopt;
    const Adaptive product = dot(a, b);
    const Adaptive square = product * product / (dot(a, a) * dot(b, b));
    // Each of the roots is rounded once.
    const double low =
        std::sqrt(std::max(0.0, square.value() - square.error())) / Adaptive::widening;
    const double high =
        std::min(1.0, std::sqrt(square.value() + square.error()) * Adaptive::widening);
    const double middle = (low + high) / 2;
    return Adaptive(product < Adaptive(0) ? -middle : middle,
                    (high - low) / 2 * Adaptive::widening);
}

/// True if a face with this normal . view is not drawn.
template <typename Scalar> bool is_culled(Cull cull, const Scalar& dot) {
    const Scalar zero = scalar_from<Scalar>(0);
    switch (cull) {
    case Cull::back:
    case Cull::light:
        return !(zero < dot);
    case Cull::front:
        return !(dot < zero);
    case Cull::both:
        return true;
    case Cull::none:
        break;
    }
    return false;
}

/// A color in light of an intensity from 0 to 1.
inline Color lit(Color color, double intensity, ColorRounding rounding) {
    const auto level = [intensity, rounding](std::uint8_t channel) {
        return level_of(channel * intensity, rounding);
    };
    return {level(color.red()), level(color.green()), level(color.blue()), color.alpha()};
}

/// The same for an intensity with an error. Throws Undecided if a level hangs on it.
inline Color lit(Color color, Adaptive intensity, ColorRounding rounding) {
    const Color darkest =
        lit(color, std::max(0.0, intensity.value() - intensity.error()), rounding);
    if (lit(color, std::min(1.0, intensity.value() + intensity.error()), rounding) != darkest)
        Adaptive::leave_open(intensity.value(), intensity.error());
    return darkest;
}

/// The color of the primitive with this number, for `shade: faces`.
inline Color color_of_face(std::size_t number) {
    constexpr std::array<std::array<std::uint8_t, 3>, 12> colors{{{230, 25, 75},
                                                                  {60, 180, 75},
                                                                  {0, 130, 200},
                                                                  {255, 225, 25},
                                                                  {145, 30, 180},
                                                                  {70, 240, 240},
                                                                  {245, 130, 48},
                                                                  {240, 50, 230},
                                                                  {128, 128, 0},
                                                                  {0, 128, 128},
                                                                  {170, 110, 40},
                                                                  {128, 128, 128}}};
    const auto& [red, green, blue] = colors[number % colors.size()];
    return {red, green, blue};
}

} // namespace rastertrace
