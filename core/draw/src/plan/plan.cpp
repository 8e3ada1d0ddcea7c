// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/core/numbers/adaptive.h>

#include "plan/stages_of.h"

#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/raster/barycentric.h>
#include <rastertrace/core/raster/fill_fan.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <utility>

namespace rastertrace {

/// Where the vertices lie: as typed, or moved there.
using AnyGeometry = std::variant<TypedVertices, Geometry<float>, Geometry<double>,
                                 Geometry<Adaptive>, Geometry<Rational>>;

/// Moves the vertices of a scene to the screen, in the numbers that its kind of scalar asks for.
AnyGeometry geometry_for(const Scene& scene) {
    if (!scene.has_pipeline())
        return TypedVertices{scene.mixes_colors()};
    // Vertices that nothing moves stay as typed.
    if (!scene.needs_pipeline() && scene.method.scalar == ScalarKind::fixed)
        return geometry_of<Rational>(scene);
    switch (scene.method.scalar) {
    case ScalarKind::single_precision:
        return geometry_of<float>(scene);
    case ScalarKind::adaptive:
        // What is left open about one vertex may be of weight for all, like a plane of the view.
        try {
            return geometry_of<Adaptive>(scene);
        } catch (const Undecided&) {
            return geometry_of<Rational>(scene);
        }
    case ScalarKind::exact:
        return geometry_of<Rational>(scene);
    case ScalarKind::fixed:
    case ScalarKind::double_precision:
        break;
    }
    return geometry_of<double>(scene);
}

/// Moves the primitives of a scene to the screen, in the numbers that its kind of scalar asks for.
AnyScreenList screen_list_for(const Scene& scene) {
    return std::visit(
        [&](auto geometry) -> AnyScreenList { return screen_list_of(scene, std::move(geometry)); },
        geometry_for(scene));
}

/// How many bits drawing needs, in fractions over a common denominator. With coordinates n/D, |n| <
/// 2^b and D <= 2^d, an edge is at
///
///     x = n1/D + (dx/dy) ((y D - n0)/D),
///     so   |numerator| < 2^(2b + d + 3),   denominator < 2^(b + 2d + 1)
///
/// and comparing it with a vertex, or its distance to a sample with a half, multiplies by 2D or
/// by 8. A line may need more (LineTraits). Mixing colors multiplies a weight, a
/// quotient of two areas, by 255 three times.
int bits_of_drawing(const Scene& scene, int numerator_bits, int denominator_bits) {
    const int of_edges = 2 * numerator_bits + 2 * denominator_bits + 8;
    const int of_weights = 2 * numerator_bits + denominator_bits + 18;
    const bool has_lines = scene.has(PrimitiveKind::line) || scene.has(PrimitiveKind::outline);
    const int of_lines =
        has_lines ? traits_of(scene.method.line).fraction.of(numerator_bits, denominator_bits) : 0;
    return std::max({of_edges, of_weights, of_lines});
}

/// Calls `is_fine` with every coordinate until one is not; true if all are.
template <typename IsFine>
bool all_coordinates(const Scene& scene, const TypedVertices&, IsFine&& is_fine) {
    return std::all_of(scene.vertices.begin(), scene.vertices.end(),
                       [&](const SceneVertex& one) { return is_fine(one.x) && is_fine(one.y); });
}
template <typename Coordinate, typename IsFine>
bool all_coordinates(const Scene&, const ScreenList<Coordinate>& list, IsFine&& is_fine) {
    return std::all_of(list.vertices.begin(), list.vertices.end(),
                       [&](const ScreenVertex<Coordinate>& one) {
                           return is_fine(one.position.x) && is_fine(one.position.y);
                       });
}

/// The type of numbers to draw with, and their denominator.
struct NumberChoice {
    NumberType number = NumberType::binary64;
    std::int64_t denominator = 1;
    std::int64_t coarseness = 1; ///< as in Plan
};

/// The narrowest type of fractions over `denominator` in which no step of drawing can overflow.
template <typename AList>
NumberChoice choose_fractions(const Scene& scene, const AList& list, std::int64_t denominator) {
    std::uint64_t largest = 0;
    const bool all_fit =
        all_coordinates(scene, list, [&largest, denominator](const auto& coordinate) {
            const auto numerator = nearest_numerator(coordinate, denominator);
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

/// The narrowest exact type in which no step of the fill can overflow, for all of the scene. Depths,
/// and colors in a perspective, are quotients of quotients: for them, any size.
template <typename AList> NumberChoice choose_exact_numbers(const Scene& scene, const AList& list) {
    if (scene.has_depth_buffer() || scene.mixes_in_perspective())
        return {.number = NumberType::rational};

    // The least common multiple of the denominators as typed, and of the sample point's.
    std::int64_t common = sample_of(scene.method) == Sample::center ? 2 : 1;
    const bool has_common = all_coordinates(scene, list, [&common](const auto& coordinate) {
        const auto denominator = denominator_of(coordinate);
        if (!denominator)
            return false;
        const bool divides = common % *denominator == 0;
        return divides || !__builtin_mul_overflow(common / std::gcd(common, *denominator),
                                                  *denominator, &common);
    });
    if (!has_common)
        return {.number = NumberType::rational};
    return choose_fractions(scene, list, common);
}

/// How many bytes a depth has.
std::size_t depth_size_of(NumberType number) {
    switch (number) {
    case NumberType::binary32:
        return sizeof(DepthOf<float>);
    case NumberType::rational:
        return sizeof(DepthOf<Rational>);
    case NumberType::adaptive: // beside the depth, the number of a piece
        return sizeof(double) + sizeof(std::uint32_t);
    case NumberType::binary64:
    case NumberType::fraction64:
    case NumberType::fraction128:
        break;
    }
    return sizeof(double);
}

/// The type of numbers for the scene's kind of scalar. `grid` is what `fixed` snaps to.
template <typename AList>
NumberChoice choose_numbers(const Scene& scene, const AList& list, std::int64_t grid) {
    switch (scene.method.scalar) {
    case ScalarKind::exact:
        if constexpr (std::same_as<AList, TypedVertices> ||
                      std::same_as<AList, ScreenList<Rational>>)
            return choose_exact_numbers(scene, list);
        break;
    case ScalarKind::adaptive:
        // Fractions that fit leave nothing open, and are as fast.
        if constexpr (std::same_as<AList, TypedVertices>) {
            const NumberChoice exact = choose_exact_numbers(scene, list);
            if (exact.number != NumberType::rational)
                return exact;
        }
        return {.number = NumberType::adaptive};
    case ScalarKind::fixed:
        // Rationals lie on the grid too. The centers of pixels, which are halves, are not snapped,
        // however coarse it is.
        if constexpr (!std::same_as<AList, ScreenList<Adaptive>>) {
            const std::int64_t halves = sample_of(scene.method) == Sample::center ? 2 : 1;
            const std::int64_t denominator = std::lcm(grid, halves);
            return {choose_fractions(scene, list, denominator).number, denominator,
                    denominator / grid};
        }
        break;
    case ScalarKind::single_precision:
        return {.number = NumberType::binary32};
    case ScalarKind::double_precision:
        break;
    }
    return {};
}

/// True if, in numbers of type Real, some pixel of the canvas may have an infinite weight in a
/// triangle: a weight is a quotient of two areas, and the triangle's own may be almost 0.
template <typename Real> bool weights_may_overflow(const Triangle<Real>& triangle) {
    Real extent = largest_canvas_side;
    for (const auto& vertex : triangle.vertices)
        extent = std::max({extent, std::abs(vertex.x), std::abs(vertex.y)});
    const Real area2 = Barycentric<Real>(triangle).area2();
    return area2 != 0 && !std::isfinite(16 * extent * extent / area2);
}

/// The first thing about a piece that would make an infinity or overflow. Real is the type that the
/// scene is drawn with, or double where that cannot overflow.
template <typename Real, typename Coordinate>
std::optional<Unfit> unfit_of(const Piece<Coordinate>& piece, const Method& method,
                              bool mixes_colors, bool has_tested_lines) {
    using What = Unfit::What;
    const bool is_rounded = method.scalar == ScalarKind::double_precision ||
                            method.scalar == ScalarKind::single_precision;
    const bool is_triangle = piece.kind == PrimitiveKind::triangle;
    const FillTraits fill = traits_of(method.fill);
    const bool is_fan = is_triangle && fill.rule == PixelRule::lines;
    const bool is_on_grid = is_fan || (!is_triangle && traits_of(method.line).is_on_grid);
    const bool has_weights =
        is_rounded && is_triangle && (mixes_colors || fill.rule == PixelRule::samples);

    std::array<std::array<double, 2>, 3> at{};
    for (std::size_t i = 0; i < piece.count; ++i)
        at[i] = {to_double(piece.positions[i].x), to_double(piece.positions[i].y)};
    const auto unfit = [&](What what, std::size_t from, std::size_t to, double limit = 0) {
        return Unfit{what, piece.vertices[from], piece.vertices[to], at[from], at[to], limit};
    };

    // Coordinates.
    using Limits = std::numeric_limits<Real>;
    const double largest_of_differences = std::ldexp(1.0, Limits::max_exponent - 2);
    const double largest_of_products = std::ldexp(1.0, Limits::max_exponent / 2 - 12);
    const double largest_of_fixed = std::ldexp(1.0, 36);
    const double largest_of_lines = std::ldexp(1.0, 51);
    for (std::size_t i = 0; i < piece.count; ++i) {
        const double farthest = std::max(std::abs(at[i][0]), std::abs(at[i][1]));
        if (!std::isfinite(at[i][0]) || !std::isfinite(at[i][1]))
            return unfit(What::position, i, i);
        const auto largest_index = static_cast<double>(farthest_index);
        if (method.snap != Snap::none && farthest >= largest_index)
            return unfit(What::coordinate_of_snap, i, i, largest_index);
        if (is_rounded && farthest > largest_of_differences)
            return unfit(What::coordinate, i, i, largest_of_differences);
        if (method.scalar == ScalarKind::fixed && farthest > largest_of_fixed)
            return unfit(What::coordinate_of_fixed, i, i, largest_of_fixed);
        if (has_weights && farthest > largest_of_products)
            return unfit(What::coordinate_of_weights, i, i, largest_of_products);
        if (is_on_grid && farthest > largest_of_lines)
            return unfit(What::coordinate_of_line, i, i, largest_of_lines);
    }

    // Depths are interpolated as differences times differences.
    if ((is_triangle || has_tested_lines) && !decides_exactly(method)) {
        double farthest = 1;
        for (const auto& [x, y] : at)
            farthest = std::max({farthest, std::abs(x), std::abs(y)});
        for (std::size_t i = 0; i < piece.count; ++i)
            if (!(8 * std::abs(to_double(piece.depths[i])) * farthest <
                  static_cast<double>(Limits::max())))
                return unfit(What::depth_times_size, i, i);
    }

    // The area, and the edges.
    Triangle<Real> triangle{};
    for (std::size_t i = 0; i < piece.count; ++i)
        triangle.vertices[i] = {static_cast<Real>(at[i][0]), static_cast<Real>(at[i][1])};
    if (has_weights && weights_may_overflow(triangle))
        return unfit(What::area_of_weights, 0, 2);
    for (std::size_t from = 0; from < piece.count; ++from) {
        const std::size_t to = (from + 1) % piece.count;
        const Real dx = triangle.vertices[to].x - triangle.vertices[from].x;
        const Real dy = triangle.vertices[to].y - triangle.vertices[from].y;
        if (is_rounded && dy != 0 && !std::isfinite(dx / dy))
            return unfit(What::slope, from, to);
        const auto longest = static_cast<Real>(longest_fan_edge);
        if (is_fan && (std::abs(dx) > longest || std::abs(dy) > longest))
            return unfit(What::edge_of_fan, from, to, static_cast<double>(longest_fan_edge));
    }
    return std::nullopt;
}

/// The first vertex that a primitive needs and that has no finite place before clipping, or no
/// depth.
template <typename Coordinate>
std::optional<Unfit> unfit_vertex(const Scene& scene, const Geometry<Coordinate>& geometry) {
    if constexpr (std::floating_point<Coordinate>) {
        const auto is_infinite = [](const std::optional<Matrix<Coordinate>>& matrix) {
            return matrix &&
                   std::any_of(matrix->rows.begin(), matrix->rows.end(), [](const auto& row) {
                       return !std::all_of(row.begin(), row.end(),
                                           [](Coordinate entry) { return std::isfinite(entry); });
                   });
        };
        const auto& transforms = geometry.list.transforms;
        if (is_infinite(transforms.view) || is_infinite(transforms.projection) ||
            is_infinite(transforms.viewport) ||
            std::any_of(transforms.models.begin(), transforms.models.end(), is_infinite))
            return Unfit{Unfit::What::matrix, 0, 0, {}, {}, 0};
        for (std::size_t i = 0; i < geometry.vertices.size(); ++i) {
            const auto& at = geometry.vertices[i].clip;
            if (geometry.is_used[i] && !(std::isfinite(at.x) && std::isfinite(at.y) &&
                                         std::isfinite(at.z) && std::isfinite(at.w)))
                return Unfit{Unfit::What::position, i, i, {at.x, at.y}, {at.x, at.y}, 0};
        }
    }
    // In a perspective, clipping leaves only what lies in front of the eye. Elsewhere nothing does.
    const bool tests_all = scene.has_depth_buffer();
    if (scene.depth() == Depth::inverse_z && !is_perspective(scene.projection.type))
        for (const ScenePrimitive& primitive : scene.primitives)
            if (primitive.kind == PrimitiveKind::triangle || tests_all)
                for (const std::size_t i : primitive.corners()) {
                    const Coordinate& exact = geometry.vertices[i].distance;
                    const double distance = to_double(exact);
                    if (!(scalar_from<Coordinate>(0) < exact) || !std::isfinite(1 / distance))
                        return Unfit{Unfit::What::depth, i, i, {distance, 0}, {distance, 0}, 0};
                }
    return std::nullopt;
}
std::optional<Unfit> unfit_vertex(const Scene&, const TypedVertices&) {
    return std::nullopt;
}

/// The first piece in the scene's order that would make an infinity or overflow.
template <typename AList> std::optional<Unfit> unfit_piece(const Scene& scene, const AList& list) {
    const bool is_single = scene.method.scalar == ScalarKind::single_precision;
    const bool has_tested_lines = scene.has_tested_lines();
    std::optional<Unfit> first;
    std::size_t primitive = scene.primitives.size();
    for_each_piece(scene, list, [&](const auto& piece) {
        if (piece.primitive >= primitive)
            return;
        const auto unfit =
            is_single ? unfit_of<float>(piece, scene.method, list.mixes_colors, has_tested_lines)
                      : unfit_of<double>(piece, scene.method, list.mixes_colors, has_tested_lines);
        if (unfit) {
            first = unfit;
            primitive = piece.primitive;
        }
    });
    return first;
}

/// The first triangle whose face would be told with an infinity.
template <typename Coordinate>
std::optional<Unfit> unfit_face(const Scene& scene, const ScreenList<Coordinate>& list) {
    if (!list.infinite_face)
        return std::nullopt;
    const auto [a, b, c] = scene.primitives[*list.infinite_face].vertices;
    const auto& world = vertex_in_space(scene, list.transforms, a).world;
    const std::array<double, 2> at{to_double(world.x), to_double(world.y)};
    return Unfit{Unfit::What::face, a, c, at, at, 0};
}
std::optional<Unfit> unfit_face(const Scene&, const TypedVertices&) {
    return std::nullopt;
}

/// Decides how a scene is drawn, from the scene alone; or tells the first place where drawing it
/// would make an infinity or overflow. `grid` is what `fixed` snaps to: so many places to a pixel.
std::variant<Plan, Unfit> plan_or_unfit(const Scene& scene, std::int64_t grid) {
    const auto plan_with = [&](auto geometry) -> std::variant<Plan, Unfit> {
        if (const auto unfit = unfit_vertex(scene, geometry))
            return *unfit;
        auto list = screen_list_of(scene, std::move(geometry));
        if (const auto unfit = unfit_piece(scene, list))
            return *unfit;
        if (const auto unfit = unfit_face(scene, list))
            return *unfit;

        const NumberChoice choice = choose_numbers(scene, list, grid);
        Plan plan{.number = choice.number,
                  .denominator = choice.denominator,
                  .coarseness = choice.coarseness,
                  .stages = stages_of(scene, list, depth_size_of(choice.number)),
                  .mixes_colors = list.mixes_colors};
        plan.list = std::make_shared<const AnyScreenList>(std::move(list));
        return plan;
    };
    return std::visit(plan_with, geometry_for(scene));
}

/// The plan of a scene that can be drawn.
Plan plan_for(const Scene& scene, std::int64_t grid) {
    return std::get<Plan>(plan_or_unfit(scene, grid));
}

/// Why a scene cannot be drawn, if it cannot.
std::optional<Unfit> find_unfit(const Scene& scene) {
    const auto plan = plan_or_unfit(scene);
    const auto* unfit = std::get_if<Unfit>(&plan);
    return unfit == nullptr ? std::nullopt : std::optional(*unfit);
}

} // namespace rastertrace
