// SPDX-License-Identifier: MIT
// The colors of faces can be told apart, by everybody, and what is written on them can be read.

#include <rastertrace/figures/theme.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace rastertrace {
namespace {

using Triple = std::array<double, 3>;
using Matrix3 = std::array<Triple, 3>;

/// How somebody sees linear sRGB: Machado, Oliveira and Fernandes, A Physiologically-based Model for Simulation of Color
/// Vision Deficiency, 2009, table of severity 1.
struct Vision {
    std::string_view name;
    Matrix3 matrix;
};
constexpr std::array visions{Vision{"normal", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
                             Vision{"protan",
                                    {{{0.152286, 1.052583, -0.204868},
                                      {0.114503, 0.786281, 0.099216},
                                      {-0.003882, -0.048116, 1.051998}}}},
                             Vision{"deutan",
                                    {{{0.367322, 0.860646, -0.227968},
                                      {0.280085, 0.672501, 0.047413},
                                      {-0.011820, 0.042940, 0.968881}}}},
                             Vision{"tritan",
                                    {{{1.255528, -0.076749, -0.178779},
                                      {-0.078411, 0.930809, 0.147602},
                                      {0.004733, 0.691367, 0.303900}}}}};

Triple product(const Matrix3& matrix, const Triple& v) {
    Triple result{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            result[i] += matrix[i][k] * v[k];
    return result;
}

/// IEC 61966-2-1.
Triple linear(Color color) {
    Triple result{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double c = std::array{color.red(), color.green(), color.blue()}[i] / 255.0;
        result[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    }
    return result;
}

/// CIE 1976 L*a*b*, white D65.
Triple lab(const Triple& rgb) {
    constexpr Matrix3 to_xyz{{{0.4124564, 0.3575761, 0.1804375},
                              {0.2126729, 0.7151522, 0.0721750},
                              {0.0193339, 0.1191920, 0.9503041}}};
    constexpr Triple white{0.95047, 1, 1.08883};
    Triple xyz = product(to_xyz, rgb);
    for (std::size_t i = 0; i < 3; ++i) {
        const double t = std::max(xyz[i], 0.0) / white[i];
        xyz[i] = t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
    }
    return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

double distance(const Vision& vision, Color a, Color b) {
    const Triple p = lab(product(vision.matrix, linear(a)));
    const Triple q = lab(product(vision.matrix, linear(b)));
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

/// WCAG 2.1, contrast ratio.
double contrast(Color a, Color b) {
    const auto luminance = [](Color color) {
        const Triple rgb = linear(color);
        return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
    };
    const auto [dark, bright] = std::minmax({luminance(a), luminance(b)});
    return (bright + 0.05) / (dark + 0.05);
}

std::vector<Color> faces(Theme theme) {
    std::vector<Color> colors;
    for (std::size_t n = 0; n < 8; ++n)
        colors.push_back(paint_of(face_role(n), theme).color);
    return colors;
}

TEST(Theme, EverybodyTellsTheColorsOfEightFacesApart) {
    for (const Theme theme : {Theme::light, Theme::dark})
        for (const Vision& vision : visions) {
            std::vector<Color> colors = faces(theme);
            colors.push_back(paint_of(Role::paper, theme).color);
            for (std::size_t i = 0; i < colors.size(); ++i)
                for (std::size_t k = 0; k < i; ++k)
                    EXPECT_GE(distance(vision, colors[i], colors[k]), 12)
                        << vision.name << ", " << (theme == Theme::dark ? "dark" : "light")
                        << ", faces " << k + 1 << " and " << i + 1;
        }
}

TEST(Theme, LettersOnFacesCanBeRead) {
    for (const Theme theme : {Theme::light, Theme::dark})
        for (const Color face : faces(theme))
            for (const Role letters : {Role::cell_text, Role::ink})
                EXPECT_GE(contrast(face, paint_of(letters, theme).color), 4.5)
                    << name_of(letters) << ", " << static_cast<int>(face.red());
}

} // namespace
} // namespace rastertrace
