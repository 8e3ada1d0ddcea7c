// SPDX-License-Identifier: MIT
#pragma once

// How bright a face is: by the cosine of the angle between its normal and the way to the light.
//
// Source: T3 (flat shading by n . l); Lambert's cosine law.
//
//     lit(color, *cosine_between(normal, light), ColorRounding::nearest);

#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/facing.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/rounding.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace rastertrace {

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
/// A color in light of an intensity from 0 to 1.
template <typename Number> Color lit(Color color, const Number& intensity, ColorRounding rounding) {
    const auto level = [&intensity, rounding](std::uint8_t channel) {
        return level_of(Number(scalar_from<Number>(channel) * intensity), rounding);
    };
    return {level(color.red()), level(color.green()), level(color.blue()), color.alpha()};
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
