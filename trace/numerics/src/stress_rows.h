// SPDX-License-Identifier: MIT
#pragma once

// What the cases of the catalogue are made of: rows, and the ways to come by them.

#include "reference.h"

#include <rastertrace/core/draw/list/screen_list.h>
#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/interval.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/numerics/stress.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/text/method_names.h>
#include <rastertrace/trace/text/problem.h>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

/// What is documented of some scalars. A scalar that is not named is right.
struct DocumentedOf {
    std::string_view scalars; ///< separated by blanks; "all" for every one
    Documented documented;
};
using DocumentedOfScalars = std::vector<DocumentedOf>;

/// Documentation in few words.
inline Documented right(std::string_view note = {}) {
    return {.verdict = Verdict::right, .note = note};
}
inline Documented wrong(std::uint64_t count, std::string_view worst = {},
                        std::string_view note = {}) {
    return {.verdict = Verdict::wrong, .wrong = count, .worst = worst, .note = note};
}
inline Documented within(double bound) {
    return {.verdict = Verdict::within, .bound = bound};
}
inline Documented refused(std::string_view message) {
    return {.verdict = Verdict::refused, .note = message};
}

/// What is documented of one scalar.
Documented documented_of(const DocumentedOfScalars& documented, std::string_view scalar);

/// The values of the method's key `scalar`.
const std::vector<std::string_view>& scalar_names();

/// Reads a case's scene.
Result<Scene> scene_in(std::string_view json, const MethodOverrides& method = {});

/// The scenes of a case; of one that has only one.
using Scenes = std::vector<StressScene>;
inline Scenes only(std::string_view json) {
    return {{"", std::string(json)}};
}

/// A case's scene that can be read, whatever the scalar.
Scene readable_scene(std::string_view json, const MethodOverrides& method = {});

/// Its scalar set.
MethodOverrides with_scalar_named(MethodOverrides method, std::string_view scalar);

/// Draws it and reads the trace back, or what kept it from being read.
Result<Trace> trace_in(std::string_view json, const MethodOverrides& method = {},
                       const std::vector<StepKind>& only = {});

/// How many steps of a trace are of a kind.
std::uint64_t count_of(const Trace& trace, StepKind kind);

/// Calls `use.template operator()<Scalar>()`. What `adaptive` leaves open is done again with exact
/// numbers, as in draw.h.
template <typename Scalar, typename Use> auto decided_with(Use&& use) {
    if constexpr (std::same_as<Scalar, Interval>) {
        try {
            return use.template operator()<Interval>();
        } catch (const Undecided&) {
            return use.template operator()<Rational>();
        }
    } else {
        return use.template operator()<Scalar>();
    }
}

/// Calls `use.template operator()<Scalar>(plan)` with the C++ type that a scene is drawn with.
template <typename Use> auto with_numbers_of(const Scene& scene, Use&& use) {
    const Plan plan = plan_for(scene);
    return with_scalar(plan, [&]<typename Chosen>() {
        return decided_with<Chosen>(
            [&]<typename Scalar>() { return use.template operator()<Scalar>(plan); });
    });
}

/// Calls `use.template operator()<Scalar>()` with the C++ type that vertices are moved in, and faces
/// tested in.
template <typename Scalar> Scalar coordinate_type_of(const ScreenList<Scalar>&);
Rational coordinate_type_of(const TypedVertices&);
template <typename Use> auto with_coordinates_of(const Scene& scene, Use&& use) {
    const AnyScreenList list = screen_list_for(scene);
    return std::visit(
        [&](const auto& one) { return decided_with<decltype(coordinate_type_of(one))>(use); },
        list);
}

/// A vertex of a scene where it is drawn.
template <typename Scalar>
Vec<Scalar, 2> place_of(const Scene& scene, std::size_t vertex, const Plan& plan) {
    return {scalar_from<Scalar>(scene.vertices[vertex].x, plan.denominator),
            scalar_from<Scalar>(scene.vertices[vertex].y, plan.denominator)};
}

/// A number as it is, without rounding. An interval of more than one number leaves it open.
template <std::floating_point Real> Rational exact_value(Real value) {
    return Rational(value);
}
inline Rational exact_value(const Rational& value) {
    return value;
}
template <typename Integer> Rational exact_value(const Fraction<Integer>& value) {
    return exact(value);
}
inline Rational exact_value(const Interval& value) {
    if (!value.is_exact())
        Interval::leave_open(value, value);
    return Rational(value.low());
}

/// How far a number lies from the exact one, rounded to a double. An interval that holds it is as
/// good as exact.
template <typename Scalar> double distance_from(const Rational& exact, const Scalar& value) {
    return nearest_double(abs(exact_value(value) - exact));
}
inline double distance_from(const Rational& exact, const Interval& value) {
    const bool is_held = Rational(value.low()) <= exact && exact <= Rational(value.high());
    return is_held ? 0 : nearest_double(abs(exact_value(value) - exact));
}

/// The same over the exact one.
template <typename Scalar>
double relative_distance_from(const Rational& exact, const Scalar& value) {
    return distance_from(exact, value) / nearest_double(abs(exact));
}

/// The largest relative error of one correctly rounded operation: 2^-24 for float, 2^-53 for double,
/// 0 for what is exact.
template <typename Scalar> constexpr double rounding_unit() {
    if constexpr (std::floating_point<Scalar>)
        return static_cast<double>(std::numeric_limits<Scalar>::epsilon()) / 2;
    else
        return 0;
}

/// The rows of a case, as they are found.
class StressRows {
public:
    explicit StressRows(const StressOptions& options) : options_(options) {}

    bool is_quick() const { return options_.quick; }

    void add(std::string_view scalar, std::string_view method, Measured measured,
             const Documented& documented);

    /// Adds a row for every scalar: `measure(scalar)` is what was found.
    template <typename Measure>
    void add_for_all(std::string_view method, const DocumentedOfScalars& documented,
                     Measure&& measure) {
        for (const std::string_view scalar : scalar_names())
            add(scalar, method, measure(scalar), documented_of(documented, scalar));
    }

    /// Adds a row that is right if `found` is `expected`, and wrong by one otherwise.
    void expect_same(std::string_view scalar, std::string_view method, std::uint64_t found,
                     std::uint64_t expected, std::string_view unit);

    /// Draws a scene with every scalar and compares each pixel with the reference. For `fixed` the
    /// reference is that of the vertices snapped to 1/256 pixel. The reference must have
    /// `pixels` pixels, if that is said.
    using ReferenceOf = Colors (*)(const Scene& scene);
    void add_pictures(std::string_view json, std::string_view label, const MethodOverrides& method,
                      std::optional<std::uint64_t> pixels,
                      const DocumentedOfScalars& documented = {},
                      ReferenceOf reference = reference_picture);

    /// Tries to read a scene with every scalar: it must be refused, with this in the message.
    void add_refusals(std::string_view json, std::string_view label, std::string_view message,
                      const MethodOverrides& method = {});

    std::vector<StressRow> take() { return std::move(rows_); }

private:
    StressOptions options_;
    std::vector<StressRow> rows_;
};

/// A scene's picture.
Colors drawn_picture(const Scene& scene);

/// A picture moved on its canvas; what was outside comes in empty.
Colors moved_picture(const Colors& picture, const Canvas& canvas, Index right, Index down);

/// How many pixels differ.
std::uint64_t differing(const Colors& a, const Colors& b);

/// How many pixels are drawn.
std::uint64_t drawn_in(const Colors& picture);

/// How many pixels are covered in both.
std::uint64_t common_pixels(const CoveredPixels& a, const CoveredPixels& b);

// The families: each a table at the end of its file, below one function for each case.
std::span<const StressCase> line_cases();
std::span<const StressCase> scanline_cases();
std::span<const StressCase> edge_function_cases();
std::span<const StressCase> depth_cases();
std::span<const StressCase> pipeline_cases();
std::span<const StressCase> stage_cases();

} // namespace rastertrace
