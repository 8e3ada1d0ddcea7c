// SPDX-License-Identifier: MIT
#include "plan/unfit.h"

#include <rastertrace/core/raster/barycentric.h>
#include <rastertrace/core/raster/fill_fan.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rastertrace {

namespace {

using What = Unfit::What;

/// True if, in numbers of type Real, some pixel of the canvas may have an infinite weight in a
/// triangle: a weight is a quotient of two areas, and the triangle's own may be almost 0.
template <typename Real> bool weights_may_overflow(const Triangle<Real>& triangle) {
    Real extent = largest_canvas_side;
    for (const auto& vertex : triangle.vertices)
        extent = std::max({extent, std::abs(vertex.x), std::abs(vertex.y)});
    const Real area2 = Barycentric<Real>(triangle).area2();
    return area2 != 0 && !std::isfinite(16 * extent * extent / area2);
}

/// What drawing a piece does with its coordinates.
struct PieceUse {
    bool is_rounded;  ///< in floats or doubles
    bool is_fan;      ///< filled by a fan
    bool is_on_grid;  ///< drawn by lines from pixel to pixel
    bool has_weights; ///< barycentric weights, which are rounded
};

PieceUse use_of(const Piece<double>& piece, const Method& method, bool mixes_colors) {
    const bool is_rounded = method.scalar == ScalarKind::double_precision ||
                            method.scalar == ScalarKind::single_precision;
    const bool is_triangle = piece.kind == PrimitiveKind::triangle;
    const PixelRule rule = traits_of(method.fill).rule;
    const bool is_fan = is_triangle && rule == PixelRule::lines;
    return {.is_rounded = is_rounded,
            .is_fan = is_fan,
            .is_on_grid =
                is_fan || (!is_filled(piece.kind) && traits_of(method.line).rule == LineRule::grid),
            .has_weights =
                is_rounded && is_triangle && (mixes_colors || rule == PixelRule::samples)};
}

/// The farthest that a vertex lies from x = 0 or y = 0.
double extent_of(const Vec<double, 2>& at) {
    return std::max(std::abs(at.x), std::abs(at.y));
}

Unfit unfit_between(What what, const Piece<double>& piece, std::size_t from, std::size_t to,
                    double limit = 0) {
    const auto& a = piece.corners()[from];
    const auto& b = piece.corners()[to];
    return {what, piece.vertex(from), piece.vertex(to), {a.x, a.y}, {b.x, b.y}, limit};
}

/// The first coordinate beyond a limit of what is done with it.
template <typename Real>
std::optional<Unfit> unfit_coordinate(const Piece<double>& piece, const PieceUse& use,
                                      const Method& method) {
    constexpr int exponent = std::numeric_limits<Real>::max_exponent;
    const double largest_of_differences = std::ldexp(1.0, exponent - 2);
    const double largest_of_products = std::ldexp(1.0, exponent / 2 - 12);
    constexpr double largest_of_fixed = 0x1p36;
    constexpr double largest_of_lines = 0x1p51;
    constexpr auto largest_index = static_cast<double>(farthest_index);
    for (std::size_t i = 0; i < piece.corners().size(); ++i) {
        const Vec<double, 2>& at = piece.corners()[i];
        if (!std::isfinite(at.x) || !std::isfinite(at.y))
            return unfit_between(What::position, piece, i, i);
        const double extent = extent_of(at);
        if (method.snap != Snap::none && extent >= largest_index)
            return unfit_between(What::coordinate_of_snap, piece, i, i, largest_index);
        if (use.is_rounded && extent > largest_of_differences)
            return unfit_between(What::coordinate, piece, i, i, largest_of_differences);
        if (method.scalar == ScalarKind::fixed && extent > largest_of_fixed)
            return unfit_between(What::coordinate_of_fixed, piece, i, i, largest_of_fixed);
        if (use.has_weights && extent > largest_of_products)
            return unfit_between(What::coordinate_of_weights, piece, i, i, largest_of_products);
        if (use.is_on_grid && extent > largest_of_lines)
            return unfit_between(What::coordinate_of_line, piece, i, i, largest_of_lines);
    }
    return std::nullopt;
}

/// The first depth that is too large. Depths are interpolated as differences times differences.
template <typename Real> std::optional<Unfit> unfit_depth(const Piece<double>& piece) {
    double farthest = 1;
    for (const Vec<double, 2>& at : piece.positions)
        farthest = std::max(farthest, extent_of(at));
    for (std::size_t i = 0; i < piece.count; ++i)
        if (!(8 * std::abs(piece.depths[i]) * farthest <
              static_cast<double>(std::numeric_limits<Real>::max())))
            return unfit_between(What::depth_times_size, piece, i, i);
    return std::nullopt;
}

/// An area that is too small for weights, or the first edge that is too steep or too long.
template <typename Real>
std::optional<Unfit> unfit_edge(const Piece<double>& piece, const PieceUse& use) {
    const auto corners = piece.corners();
    const auto in_real = [](const Vec<double, 2>& at) {
        return Vec<Real, 2>{static_cast<Real>(at.x), static_cast<Real>(at.y)};
    };
    if (use.has_weights && weights_may_overflow(Triangle<Real>{
                               {in_real(corners[0]), in_real(corners[1]), in_real(corners[2])}}))
        return unfit_between(What::area_of_weights, piece, 0, 2);
    for (std::size_t from = 0; from < corners.size(); ++from) {
        const std::size_t to = (from + 1) % corners.size();
        const auto a = in_real(corners[from]);
        const auto b = in_real(corners[to]);
        const Real dx = b.x - a.x;
        const Real dy = b.y - a.y;
        if (use.is_rounded && dy != 0 && !std::isfinite(dx / dy))
            return unfit_between(What::slope, piece, from, to);
        const auto longest = static_cast<Real>(longest_fan_edge);
        if (use.is_fan && (std::abs(dx) > longest || std::abs(dy) > longest))
            return unfit_between(What::edge_of_fan, piece, from, to,
                                 static_cast<double>(longest_fan_edge));
    }
    return std::nullopt;
}

/// The same for all of a piece. Real is the type that the scene is drawn with, or double where that
/// cannot overflow.
template <typename Real>
std::optional<Unfit> unfit_in(const Piece<double>& piece, const Method& method, bool mixes_colors,
                              bool tests_lines) {
    const PieceUse use = use_of(piece, method, mixes_colors);
    if (const auto unfit = unfit_coordinate<Real>(piece, use, method))
        return unfit;
    const bool has_depths = piece.kind == PrimitiveKind::triangle || tests_lines;
    if (has_depths && !decides_exactly(method))
        if (const auto unfit = unfit_depth<Real>(piece))
            return unfit;
    return unfit_edge<Real>(piece, use);
}

} // namespace

std::optional<Unfit> unfit_of(const Piece<double>& piece, const Method& method, bool mixes_colors,
                              bool tests_lines) {
    return method.scalar == ScalarKind::single_precision
               ? unfit_in<float>(piece, method, mixes_colors, tests_lines)
               : unfit_in<double>(piece, method, mixes_colors, tests_lines);
}

} // namespace rastertrace
