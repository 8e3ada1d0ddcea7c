// SPDX-License-Identifier: MIT
#pragma once

// What the workings of all kinds of steps are written on, and the numbers in them.

#include "formulas_of.h"
#include "step_text.h"

#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/transform/matrix.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

/// What a working is made of, and its lines so far.
struct Sheet {
    explicit Sheet(const StepContext& of_step, std::size_t step_before = 0)
        : at(of_step), numbers(at), step(at.trace().step(at.step())), primitive(primitive_of(at)),
          drew_over(step_before) {}

    StepContext at;
    Numbers numbers;
    StepView step;
    PrimitiveText primitive;
    std::size_t drew_over; ///< the step that had plotted the same pixel; 0 for none
    std::vector<std::string> lines = {};

    void put(std::string line) { lines.push_back(std::move(line)); }

    const Trace& trace() const { return at.trace(); }

    /// The formula that a field of the step is worked out by, if it has this form.
    template <typename Form> std::optional<Form> form(std::string_view field) const {
        return form_of<Form>(numbers, at.step(), field);
    }
    const Method& method() const { return trace().method.triangles; }

    /// From the integer points of the primitive's pixels to their samples.
    SampleOffset<Rational> samples() const { return told_samples(trace()).of(primitive.kind); }

    /// True if a result is what the trace tells.
    bool agrees(const Rational& worked_out, const Rational& told) const {
        return rastertrace::agrees(worked_out, told, trace());
    }
};

template <std::size_t size>
std::optional<std::array<Rational, size>> numbers_in(const std::vector<std::string>& texts) {
    std::array<Rational, size> numbers;
    if (texts.size() < size)
        return std::nullopt;
    for (std::size_t i = 0; i < size; ++i) {
        const auto number = number_in(texts[i]);
        if (!number)
            return std::nullopt;
        numbers[i] = *number;
    }
    return numbers;
}

/// 2 (-3), (-2) (-3)
std::string product(const Rational& a, const Rational& b);

/// The function of an edge, E = a (x - x1) + b (y - y1) from its first end.
struct EdgeFunctionText {
    Rational a, b;
    Vec2 from;
    bool is_top_left;
    bool is_bottom_rule = false; ///< bottom and left edges have their samples

    Rational value_at(const Vec2& p) const { return a * (p.x - from.x) + b * (p.y - from.y); }

    /// 8 (1/2) + (-8) (1/2) = 0: on a top or left edge, inside
    std::string at(const Vec2& p) const;
};

/// That of an `edge` step, if it has one.
std::optional<EdgeFunctionText> edge_function_in(const Trace& trace, const EdgeStep& edge,
                                                 const PrimitiveText& primitive);

// The workings of steps in space (working_in_space.cpp): matrices and vertices on their way to the screen,
// faces and their light.
void write_triangulation(Sheet& sheet);
void write_matrix(Sheet& sheet);
void write_vertex(Sheet& sheet);
void write_face(Sheet& sheet);
void write_light(Sheet& sheet);

/// Where an edge meets the plane that cuts it, of a vertex that clipping made (working_of_clipping.cpp).
void write_meeting_point(Sheet& sheet);

/// The matrix of this name, if there is one before the step.
std::optional<Matrix<Rational>> matrix_named(const Sheet& sheet, std::string_view name);

/// The levels of a pixel's color, and of the color that a line of a fan begins with (working_of_color.cpp).
void write_color(Sheet& sheet);
void write_ray(Sheet& sheet);

/// z of a pixel from the plane of its face in the camera's space, A x + B y + C z + D = 0, and from where
/// it is seen on the view plane: z = -d D / (A x' + B y' + d C) (T0). `told` is the 1/z of the trace.
void write_plane_in_camera_space(Sheet& sheet, const Vec2& sample, const Rational& told);

} // namespace rastertrace
