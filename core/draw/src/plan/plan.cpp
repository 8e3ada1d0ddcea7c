// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/plan/plan.h>

#include "plan/unfit.h"

#include <rastertrace/core/draw/paint/exact_depth_buffer.h>

#include <bit>
#include <cstdlib>
#include <limits>
#include <numeric>

namespace rastertrace {

/// The vertices of a scene: as typed, or moved.
using AnyGeometry = OfAnyCoordinate<TypedVertices, Geometry>;

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
        // An open decision about one vertex may count for all, like a plane of the view.
        try {
            return geometry_of<Interval>(scene);
        } catch (const Undecided&) {
            return geometry_of<Rational>(scene);
        }
    case ScalarKind::exact:
        return geometry_of<Rational>(scene);
    case ScalarKind::fixed:
    case ScalarKind::double_precision:
        return geometry_of<double>(scene);
    }
    not_an_enumerator();
}

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
/// by 8. In a polygon two edges are compared, with both denominators multiplied. A line may need
/// more (LineTraits). Mixing colors multiplies a weight, a
/// quotient of two areas, by 255 three times.
///
/// What is rounded to a pixel is first moved by the offset of its sample, with one more denominator.
int bits_of_drawing(const Scene& scene, int numerator_bits, int denominator_bits) {
    const int of_offset =
        sample_of_others(scene.method) == Sample::integer ? 0 : denominator_bits + 1;
    const int of_edges = 2 * numerator_bits + 2 * denominator_bits + 8 + of_offset;
    const int of_weights = 2 * numerator_bits + denominator_bits + 18;
    const bool has_lines = scene.has(PrimitiveKind::line) || scene.has(PrimitiveKind::outline);
    const int of_lines =
        has_lines
            ? traits_of(scene.method.line).fraction.of(numerator_bits, denominator_bits) + of_offset
            : 0;
    const int of_crossings = scene.has(PrimitiveKind::polygon)
                                 ? 3 * numerator_bits + 3 * denominator_bits + 8 + of_offset
                                 : 0;
    return std::max({of_edges, of_weights, of_lines, of_crossings});
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

/// True if no step of drawing can overflow in fractions of 64 bits over `denominator`. `all_of(is_fine)` asks
/// about each coordinate.
template <typename AllOf>
bool fit_fractions(const Scene& scene, std::int64_t denominator, AllOf&& all_of) {
    std::uint64_t largest = 0;
    const bool all_fit = all_of([&largest, denominator](const auto& coordinate) {
        const auto numerator = nearest_numerator(coordinate, denominator);
        if (!numerator || *numerator == std::numeric_limits<std::int64_t>::min())
            return false;
        largest = std::max(largest, static_cast<std::uint64_t>(std::llabs(*numerator)));
        return true;
    });
    const int bits = bits_of_drawing(
        scene, static_cast<int>(std::bit_width(largest)),
        static_cast<int>(std::bit_width(static_cast<std::uint64_t>(denominator - 1))));
    return all_fit && bits < 64;
}

/// A plan with fractions over `denominator`: on 64 bits, if no step of drawing can overflow.
template <typename AList>
Plan plan_in_fractions(const Scene& scene, const AList& list, std::int64_t denominator) {
    const bool fits = fit_fractions(
        scene, denominator, [&](auto&& is_fine) { return all_coordinates(scene, list, is_fine); });
    if (!fits)
        return {.number = NumberType::rational};
    return {.number = NumberType::fraction64, .denominator = denominator};
}

bool fits_fractions(const Scene& scene, const Piece<double>& piece, const Plan& plan) {
    const auto corners = piece.corners();
    return fit_fractions(scene, plan.denominator, [&](auto&& is_fine) {
        return std::all_of(corners.begin(), corners.end(), [&](const Vec<double, 2>& at) {
            return is_fine(at.x) && is_fine(at.y);
        });
    });
}

/// The least common multiple of two denominators, if both are known and it fits.
std::optional<std::int64_t> common_denominator(std::int64_t a, std::optional<std::int64_t> b) {
    if (!b || a % *b == 0)
        return b ? std::optional(a) : std::nullopt;
    std::int64_t common = 0;
    const bool is_too_large = __builtin_mul_overflow(a / std::gcd(a, *b), *b, &common);
    return is_too_large ? std::nullopt : std::optional(common);
}

/// That of the places of the samples of triangles, lines and all others.
std::int64_t denominator_of_samples(const Scene& scene) {
    const Method& method = scene.method;
    for (const Sample sample :
         {sample_of(method), sample_of_lines(method), sample_of_others(method)})
        if (sample == Sample::center)
            return 2;
    return 1;
}

/// True if clipping has made colors that are no whole levels.
bool has_cut_colors(const TypedVertices&) {
    return false;
}
template <typename Coordinate> bool has_cut_colors(const ScreenList<Coordinate>& list) {
    return !list.levels.empty();
}

/// A plan with the narrowest exact type in which no step of the fill can overflow, for all of the
/// scene: fractions on 64 bits, or of any size. Depths, and colors in a perspective or of cut edges, are quotients of quotients: for them, any size.
template <typename AList> Plan plan_in_exact_numbers(const Scene& scene, const AList& list) {
    if (scene.has_depth_buffer() || scene.mixes_in_perspective() || scene.mixes_lines_in_space() ||
        has_cut_colors(list))
        return {.number = NumberType::rational};

    // The least common multiple of the denominators as typed, and of the samples'.
    std::optional<std::int64_t> common = denominator_of_samples(scene);
    const bool has_common = all_coordinates(scene, list, [&](const auto& coordinate) {
        common = common_denominator(*common, denominator_of(coordinate));
        return common.has_value();
    });
    if (!has_common)
        return {.number = NumberType::rational};
    return plan_in_fractions(scene, list, *common);
}

/// The size of an element of the depth buffer, in bytes.
std::size_t depth_size_of(NumberType number) {
    switch (number) {
    case NumberType::binary32:
        return sizeof(DepthOf<float>);
    case NumberType::rational:
        return sizeof(ExactDepthBuffer::Cell);
    case NumberType::interval: // the depth, and the number of a piece
        return sizeof(double) + sizeof(std::uint32_t);
    case NumberType::binary64:
    case NumberType::fraction64:
        return sizeof(double);
    }
    not_an_enumerator();
}

/// A list whose coordinates are not rounded.
template <typename AList>
concept ExactList = std::same_as<AList, TypedVertices> || std::same_as<AList, ScreenList<Rational>>;

/// A plan with fractions on the grid that `fixed` snaps to: so many positions to a pixel. Samples stay
/// where they are, however coarse the grid is.
template <typename AList>
Plan plan_on_grid(const Scene& scene, const AList& list, std::int64_t grid) {
    const auto common = common_denominator(grid, denominator_of_samples(scene));
    const std::int64_t denominator = common.value_or(grid);
    return {.number = plan_in_fractions(scene, list, denominator).number,
            .denominator = denominator,
            .coarseness = denominator / grid};
}

/// Begins a plan with the type of numbers for the scene's kind of scalar. `grid` is what `fixed`
/// snaps to.
template <typename AList>
Plan plan_with_numbers(const Scene& scene, const AList& list, std::int64_t grid) {
    switch (scene.method.scalar) {
    case ScalarKind::exact:
        if constexpr (ExactList<AList>)
            return plan_in_exact_numbers(scene, list);
        break;
    case ScalarKind::adaptive:
        // Fractions that fit leave nothing open, and are as fast.
        if constexpr (std::same_as<AList, TypedVertices>) {
            const Plan exact = plan_in_exact_numbers(scene, list);
            if (exact.number != NumberType::rational)
                return exact;
        }
        return {.number = NumberType::interval};
    case ScalarKind::fixed:
        if constexpr (ExactList<AList> || std::same_as<AList, ScreenList<double>>)
            return plan_on_grid(scene, list, grid);
        break;
    case ScalarKind::single_precision:
        return {.number = NumberType::binary32};
    case ScalarKind::double_precision:
        return {.number = NumberType::binary64};
    }
    not_an_enumerator(); // or a list that geometry_for does not make for this kind of scalar
}

std::variant<Plan, Unfit> plan_or_unfit(const Scene& scene, std::int64_t grid) {
    const auto plan_with = [&](auto geometry) -> std::variant<Plan, Unfit> {
        if (const auto unfit = unfit_vertex(scene, geometry))
            return *unfit;
        auto list = screen_list_of(scene, std::move(geometry));
        if (const auto unfit = unfit_piece(scene, list))
            return *unfit;
        if (const auto unfit = unfit_face(scene, list))
            return *unfit;

        Plan plan = plan_with_numbers(scene, list, grid);
        plan.mixes_colors = list.mixes_colors;
        plan.list = std::make_shared<const AnyScreenList>(std::move(list));
        plan.stages = stages_of(scene, *plan.list, depth_size_of(plan.number));
        return plan;
    };
    return std::visit(plan_with, geometry_for(scene));
}

Plan plan_for(const Scene& scene, std::int64_t grid) {
    return std::get<Plan>(plan_or_unfit(scene, grid));
}

std::optional<Unfit> find_unfit(const Scene& scene) {
    const auto plan = plan_or_unfit(scene);
    const auto* unfit = std::get_if<Unfit>(&plan);
    return unfit == nullptr ? std::nullopt : std::optional(*unfit);
}

} // namespace rastertrace
