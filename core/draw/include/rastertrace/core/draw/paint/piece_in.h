// SPDX-License-Identifier: MIT
#pragma once

// A piece on the screen, converted to the numbers that it is drawn with.
//
//     const Piece<double> triangle = piece_in<double>(piece, plan);

#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/interval.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/triangle.h>

#include <array>
#include <concepts>
#include <cstddef>

namespace rastertrace {

/// True if a list of this type can be drawn with Scalar.
template <typename Scalar, typename AList>
inline constexpr bool draws = std::same_as<AList, TypedVertices>;
template <typename Scalar, typename Coordinate>
inline constexpr bool draws<Scalar, ScreenList<Coordinate>> =
    std::same_as<Scalar, Coordinate> ||
    (std::same_as<Scalar, Interval> ? std::same_as<Coordinate, Rational>
                                    : !std::floating_point<Scalar> &&
                                          !std::same_as<Coordinate, float> &&
                                          !std::same_as<Coordinate, Interval>);

/// A coordinate of a vertex as a Scalar, over the plan's denominator if that is a fraction.
template <typename Scalar, typename Coordinate>
Scalar on_grid(const Coordinate& coordinate, const Plan& plan) {
    return written_finer(scalar_from<Scalar>(coordinate, plan.denominator / plan.coarseness),
                         plan.coarseness);
}

/// The channels of the colors of a piece, each converted.
template <typename Scalar, typename Coordinate, typename Convert>
void convert_levels(const Piece<Coordinate>& piece, Piece<Scalar>& result, Convert&& convert) {
    for (const auto& levels : piece.levels) {
        auto& converted = result.levels.emplace_back();
        for (std::size_t i = 0; i < levels.of.size(); ++i)
            converted.of[i] = convert(levels.of[i]);
    }
}

/// A piece with coordinates of type Scalar. A scene typed in pixels has no depths.
template <typename Scalar, typename Coordinate>
requires(!(std::floating_point<Scalar> &&
           std::same_as<Scalar, Coordinate>)) Piece<Scalar> piece_in(const Piece<Coordinate>& piece,
                                                                     const Plan& plan) {
    auto result = without_numbers<Scalar>(piece);
    const auto position_in = [&plan](const Vec<Coordinate, 2>& at) {
        return Vec<Scalar, 2>{on_grid<Scalar>(at.x, plan), on_grid<Scalar>(at.y, plan)};
    };
    for (const Vec<Coordinate, 2>& at : piece.ring)
        result.ring.push_back(position_in(at));
    for (std::size_t i = 0; i < piece.count; ++i)
        result.positions[i] = position_in(piece.positions[i]);
    using D = DepthOf<Scalar>;
    if constexpr (!std::same_as<Coordinate, Number> &&
                  (std::same_as<D, Interval> || std::constructible_from<D, Coordinate>)) {
        const auto depth_in = [](const Coordinate& number) -> D {
            if constexpr (std::same_as<D, Interval>)
                return Conversion<D>::of(number);
            else
                return D(number);
        };
        for (std::size_t i = 0; i < piece.count; ++i) {
            result.depths[i] = depth_in(piece.depths[i]);
            result.inverse_w[i] = depth_in(piece.inverse_w[i]);
        }
        convert_levels(piece, result, depth_in);
    }
    return result;
}

/// Floats and doubles are drawn as they are.
template <std::floating_point Scalar> Piece<Scalar> piece_in(Piece<Scalar> piece, const Plan&) {
    return piece;
}

/// The piece in doubles: of intervals, the middles.
template <typename Coordinate> Piece<double> in_doubles(const Piece<Coordinate>& piece) {
    auto result = without_numbers<double>(piece);
    for (const auto& at : piece.ring)
        result.ring.push_back({to_double(at.x), to_double(at.y)});
    for (std::size_t i = 0; i < piece.count; ++i) {
        result.positions[i] = {to_double(piece.positions[i].x), to_double(piece.positions[i].y)};
        result.depths[i] = to_double(piece.depths[i]);
        result.inverse_w[i] = to_double(piece.inverse_w[i]);
    }
    convert_levels(piece, result, [](const auto& level) { return to_double(level); });
    return result;
}

inline const Piece<double>& in_doubles(const Piece<double>& piece) {
    return piece;
}

/// Where samples lie in the pixels of a scene.
template <typename Scalar>
SampleOffset<Scalar> sample_offset(Sample sample, std::int64_t denominator) {
    const auto offset = scalar_from<Scalar>(offset_of(sample), denominator);
    return {offset, offset};
}

} // namespace rastertrace
