// SPDX-License-Identifier: MIT
#pragma once

// What is decided about a scene before the first pixel: what is drawn where on the screen, and the
// type of number that it is drawn with.
//
//     const Plan plan = plan_for(scene);
//     const Image picture = draw(scene, plan);

#include <rastertrace/core/draw/plan/stages.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/interval.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <variant>

namespace rastertrace {

/// The grid that `fixed` snaps to: 1/256 pixel, as graphics hardware does.
inline constexpr std::int64_t fixed_grid = 256;

/// The C++ type that stands for the scene's kind of scalar.
enum class NumberType { binary32, binary64, interval, fraction64, rational };

/// Moves the primitives of a scene to the screen, in the numbers that its kind of scalar asks for.
AnyScreenList screen_list_for(const Scene& scene);

/// The decisions taken before drawing.
struct Plan {
    NumberType number = NumberType::binary64;
    std::int64_t denominator = 1; ///< common to all coordinates, when they are fractions
    std::int64_t coarseness = 1;  ///< vertices lie on multiples of this many of its units
    std::shared_ptr<const AnyScreenList> list = {}; ///< what is drawn, for all copies of the plan
    Stages stages = {};                             ///< which of them run
    bool mixes_colors = false;                      ///< vertices have colors that count
};

/// How often intervals left a decision open.
struct Fallbacks {
    std::uint64_t primitives = 0; ///< or parts of one: drawn in fractions
    std::uint64_t depths = 0;     ///< tests of single pixels
};

/// Calls `draw_with.template operator()<Scalar>()` with the scalar that the plan has chosen.
template <typename DrawWith> decltype(auto) with_scalar(const Plan& plan, DrawWith&& draw_with) {
    switch (plan.number) {
    case NumberType::binary32:
        return draw_with.template operator()<float>();
    case NumberType::interval:
        return draw_with.template operator()<Interval>();
    case NumberType::fraction64:
        return draw_with.template operator()<Fraction64>();
    case NumberType::rational:
        return draw_with.template operator()<Rational>();
    case NumberType::binary64:
        return draw_with.template operator()<double>();
    }
    not_an_enumerator();
}

/// Why a scene cannot be drawn by its method, and between which vertices.
struct Unfit {
    enum class What {
        matrix,     ///< a matrix has an entry beyond the largest number
        position,   ///< a vertex has no finite position on its way to the screen
        coordinate, ///< beyond the limit: the difference of two such numbers may be infinite
        slope,      ///< dx/dy or dy/dx is beyond the largest number
        coordinate_of_weights, ///< beyond the limit: a product of two such numbers may be infinite
        area_of_weights,       ///< so small that a weight of a pixel may be infinite
        coordinate_of_fixed,   ///< beyond the limit: edges could not be evaluated in 128 bits
        coordinate_of_snap,    ///< beyond the limit: no index is that large
        coordinate_of_line,    ///< beyond the limit: Bresenham's d could not be held in 64 bits
        edge_of_fan,           ///< longer than longest_fan_edge
        face,                  ///< its normal, or that times the view or the light, is no number
        depth,                 ///< 0 or less from the eye, where 1/distance is asked for
        depth_times_size,      ///< so large that its product with a coordinate may be infinite
    };
    What what;
    std::size_t from; ///< index in Scene::vertices
    std::size_t to;
    std::array<double, 2> from_at; ///< where they are to be drawn
    std::array<double, 2> to_at;
    double limit; ///< of a coordinate
};

/// Decides how a scene is drawn, from the scene alone; or finds the first vertex where drawing it
/// would make an infinity or overflow. `fixed` snaps to 1/`grid` pixel.
std::variant<Plan, Unfit> plan_or_unfit(const Scene& scene, std::int64_t grid = fixed_grid);

/// The plan of a scene that can be drawn.
Plan plan_for(const Scene& scene, std::int64_t grid = fixed_grid);

/// Why a scene cannot be drawn, if it cannot.
std::optional<Unfit> find_unfit(const Scene& scene);

} // namespace rastertrace
