// SPDX-License-Identifier: MIT
#pragma once

// The table of the catalogue, stress/cases.json, its scenes, stress/scenes.json, and what its rows are measured with.
//
// A row of the table gives one row of results for each scalar, or for the one that "scalar" names. "method" is
// what it is called.
//
//     "scene", "by"     what is drawn, and keys of the method by which
//     "pixels"          how many the exact picture has
//     "against"         keys of the method of the exact picture, if they are others
//     "picture"         the exact picture, as [column, row, color] of each pixel
//     "reference"       "clipped": the exact picture is clipped_picture()
//     "measure"         a function (NamedMeasure) in place of the comparison with the exact picture;
//                       it reads further keys
//     "expected", "unit"  the count that it must find
//     "verdict"         what is documented of all scalars, or by their names, separated by blanks; what is not
//                       named is right. "within_units" is a bound in roundings of one operation
//     "slow"            `quick` has it with the first scalar only
//     "source"          where a number comes from
//
// Rows in "each" take turns: all of them with one scalar, then with the next.
//
// A scene is an object, and printed as it is typed; or an array: the name of another scene, and what replaces "$1",
// "$2", ... there. A string is pasted without its quotes, since NaN is no JSON; "layers" is the list of Z7's layers.

#include "reference.h"

#include <rastertrace/core/draw/list/screen_list.h>
#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/interval.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/line.h>
#include <rastertrace/numerics/stress.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/text/json_document.h>
#include <rastertrace/trace/text/method_names.h>
#include <rastertrace/trace/text/problem.h>

#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

/// A number of the table.
template <typename Real> Real number_in(std::string_view text) {
    Real number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

/// A row of the table.
struct TableRow {
    JsonValue json;

    bool has(std::string_view key) const { return json.find(key).has_value(); }

    /// "" if it does not have the key.
    std::string text(std::string_view key) const;
    template <typename Real = Index> Real number(std::string_view key) const {
        return number_in<Real>(text(key));
    }

    /// Keys of a method. If `scalar` is one of the method's, it is set, too.
    MethodOverrides method(std::string_view scalar, std::string_view key = "by") const;

    /// The scene that it names, which can be read.
    Scene scene(std::string_view scalar, std::string_view key = "scene",
                std::string_view method_key = "by") const;

    /// Its trace.
    Trace trace(std::string_view scalar) const;
};

/// What is documented of one scalar.
Documented documented_of(const TableRow& row, std::string_view scalar);

/// The text of a scene by its name.
std::string scene_text(std::string_view name);

/// A case's scene that can be read, whatever the scalar.
Scene readable_scene(std::string_view json, const MethodOverrides& method);

/// The trace of a scene.
Trace trace_of(const Scene& scene);

/// What a row finds with a scalar.
struct NamedMeasure {
    std::string_view name;
    Measured (*measure)(const TableRow& row, std::string_view scalar);
};
std::span<const NamedMeasure> line_measures();
std::span<const NamedMeasure> scanline_measures();
std::span<const NamedMeasure> edge_function_measures();
std::span<const NamedMeasure> depth_measures();
std::span<const NamedMeasure> pipeline_measures();
std::span<const NamedMeasure> stage_measures();

/// Right if `found` is `expected`, and wrong by one otherwise.
Measured expected_count(std::uint64_t found, std::uint64_t expected, std::string_view unit);

/// The same by the row's "expected"; what has no such key is wrong by `found`.
Measured counted_as(const TableRow& row, std::uint64_t found);

/// How many steps of a trace are of a kind.
std::uint64_t count_of(const Trace& trace, StepKind kind);

/// A scene's picture.
Colors drawn_picture(const Scene& scene);

/// One of its primitives alone.
Colors drawn_alone(const Scene& scene, std::size_t primitive);

/// The reference of scenes that are cut at the near plane.
Colors clipped_picture(const Scene& scene);

/// How many pixels differ.
std::uint64_t differing(const Colors& a, const Colors& b);

/// How many pixels are drawn.
std::uint64_t drawn_in(const Colors& picture);

/// How many pixels are covered; in both.
std::uint64_t count_in(const CoveredPixels& covered);
std::uint64_t common_pixels(const CoveredPixels& a, const CoveredPixels& b);

/// Calls `use.template operator()<Real>()` with the C++ type of a textbook's loop.
template <typename Use> auto with_real(std::string_view scalar, Use&& use) {
    return scalar == "float" ? use.template operator()<float>() : use.template operator()<double>();
}
template <typename Use> auto with_type(std::string_view scalar, Use&& use) {
    return scalar == "exact" ? use.template operator()<Rational>() : with_real(scalar, use);
}

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

/// A vertex at a place in whole pixels.
inline GridPoint whole_place(const Scene& scene, std::size_t vertex) {
    return {floor_index(scene.vertices[vertex].x.exact()),
            floor_index(scene.vertices[vertex].y.exact())};
}

} // namespace rastertrace
