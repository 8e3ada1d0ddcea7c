// SPDX-License-Identifier: MIT
#pragma once

// What sentences and workings write alike: numbers as they stand in a formula, and the primitive that
// the formulas are about.

#include "formula.h"

#include "told_samples.h"
#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/line.h>
#include <rastertrace/core/raster/mixed_colors.h>
#include <rastertrace/trace/record/step_context.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/text/language.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// How many values a pattern has a {} for.
constexpr std::size_t places_in(std::string_view pattern) {
    return static_cast<std::size_t>(std::count(pattern.begin(), pattern.end(), '{'));
}

/// Words with a {} for each of so many values. Any others do not compile.
template <std::size_t values> struct WordsFor {
    consteval WordsFor(const char* english) : words(english) { // NOLINT: words are a text
        if (places_in(english) != values)
            throw "a {} for each value is needed";
    }

    Words words;
};

/// Words in the language of steps, with values for their {}.
template <typename... Values>
std::string said(const WordsFor<sizeof...(Values)>& pattern, const Values&... values) {
    return fmt::vformat(pattern.words.in(language_of_steps()), fmt::make_format_args(values...));
}

/// `1 row`, `2 rows`; `1 linha`, `2 linhas`: more than one have an `s` in both languages.
std::string said_count(std::uint64_t count, const Words& noun);

/// A long fraction as its first digits, and what it is: 49977918.../10141204... = 4.928204, or
/// 79999999.../40000000... < 2 where it lies a hair beside.
std::string in_sentence(const std::string& number);

/// A long fraction as seven digits of it; any other number as it is.
std::string in_formula(const std::string& number);

/// A number of a trace, exactly as it is written there.
std::optional<Rational> number_in(std::string_view text);

/// The number that a JSON value stands for: a number for the nearest double, or float, if there is
/// one; a fraction in quotes for itself.
Rational as_stored(const Rational& number, std::string_view json, bool is_float);
std::optional<Rational> stored_number_in(const TracedNumber& told, bool is_float);

/// The same for the coordinates of a point.
using Vec2 = Vec<Rational, 2>;
using Vec3 = Vec<Rational, 3>;
std::optional<Vec2> vec2_in(const std::vector<std::string>& texts);
std::optional<Vec3> vec3_in(const std::vector<std::string>& texts);

/// A fraction that a reader would write, a decimal of up to fifteen digits, or seven digits of it.
std::string text(const Rational& number);
std::string text(const Vec2& v);
std::string text(const Vec3& v);

/// `+ 3` for "3" and `- 3` for "-3": a number as the second term of a sum.
std::string plus(const std::string& number);

/// `- 3` for "3" and `+ 3` for "-3": a number that is taken away.
std::string minus(const std::string& number);

/// True if a number that was worked out is the one that a trace tells, as far as the trace's numbers go.
bool agrees(const Rational& worked_out, const Rational& told, const Trace& trace);

/// `1 / 3`, with brackets around fractions that have none.
std::string quotient(const std::string& above, const std::string& below);

/// A number to six places, without zeros at its end.
std::string six_places(double number);

/// The angle of a cosine, in degrees.
double degrees_of_cosine(double cosine);

/// (2, 5)
std::string point(std::vector<std::string> coordinates);

/// What the formulas need of the primitive that is being drawn. A view, as its step is.
struct PrimitiveText {
    TracedWord<PrimitiveKind> kind;
    std::string name;
    std::vector<std::string> vertices;
    std::vector<std::vector<std::string>> positions;
    TracedList<TracedNumber> depths;
    TracedList<TracedColor> colors;
    std::optional<Index> radius;
    TracedList<TracedList<TracedNumber>> levels;

    /// The channels of a vertex's color; of one that clipping has made they are no whole levels.
    std::optional<Levels<Rational>> color_of(std::size_t vertex) const;
};

/// What is said behind the sentence of a step that does not tell what its numbers give (Trace::numbers_give): what these
/// give; "" for any other.
std::string what_numbers_give(const Trace& trace, std::size_t step);

/// What stands behind the sentence of a step that tells its place in the program, and that place; "" for any other.
std::string place_in_code(const Trace& trace, std::size_t step);

/// What a `primitive` step says.
PrimitiveText primitive_in(const StepView& step);

/// AB, or A1-B1: the edge between two of its vertices.
std::string edge_name(const PrimitiveText& primitive, std::size_t from, std::size_t to);

/// The primitive that the step of a context belongs to.
PrimitiveText primitive_of(const StepContext& context);

/// Where the corners of a triangle are drawn.
std::optional<std::array<Vec2, 3>> corners_of(const PrimitiveText& primitive);

/// The ends of an edge, found by its name.
struct EdgeEnds {
    std::vector<std::string> from;
    std::vector<std::string> to;
    std::array<std::size_t, 2> vertices; ///< which of the primitive's they are
};

std::optional<EdgeEnds> ends_of_edge(const PrimitiveText& primitive, const std::string& edge);

/// The ends of a line.
struct LineEnds {
    Vec2 from;
    Vec2 to;
};

/// Those of the line that is being drawn: the primitive, a side of an outline, or a line of a `fan`, from its
/// edge to the vertex beyond. Where lines are drawn between pixels, those.
std::optional<LineEnds> ends_of_line(const StepContext& context, const PrimitiveText& primitive);

/// What the colors of a primitive's corners are divided by in a perspective, where that is not the same: z, or the w of
/// clip space.
struct Divisors {
    std::string_view name;
    std::vector<Rational> of;
};
std::optional<Divisors> divisors_of(const StepContext& context, const PrimitiveText& primitive);

/// Shares of corners in space: each divided by its z or w, and by the sum of all. Nothing if that is not above 0.
struct SharesInSpace {
    std::vector<Rational> divided;
    Rational sum;
    std::vector<Rational> shares;
};
std::optional<SharesInSpace> shares_in_space(const std::vector<Rational>& on_screen,
                                             const Divisors& divisors);

/// What mixes the colors of a line's ends in the current step's pixel.
struct ColorOnLine {
    Levels<Rational> from;
    Levels<Rational> to;
    std::array<std::string, 2> names;
    Rational step;        ///< along the longer direction ...
    Rational steps;       ///< ... of so many
    Rational to_end = {}; ///< squares of the distance to the far end, and of the line's length
    Rational length = {};
    ColorLerp lerp = ColorLerp::axis;
    Color color = {};                      ///< what they make
    Rational way = {};                     ///< in space: the part of the way on the screen
    std::optional<Divisors> divisors = {}; ///< of both ends, in space

    /// What part of the color is that of the end `to`.
    Rational share_by(ColorLerp lerp) const;
    Rational share() const { return share_by(lerp); }
};
std::optional<ColorOnLine> color_on_line(const StepContext& context,
                                         const PrimitiveText& primitive);

/// The same in the pixel of a fan's edge that the current line begins in.
std::optional<ColorOnLine> color_on_edge_of_fan(const StepContext& context,
                                                const PrimitiveText& primitive);

/// True for a line of octant 1, 4, 5 or 8, which goes from column to column; `nullopt` if its step tells none.
std::optional<bool> is_x_major_octant(std::optional<Index> octant);

/// True if a step is about a pixel, or about a run of pixels that it is one of.
bool covers(const StepView& step, Pixel pixel);

/// Where a line is at an x, in y; or, where y is the longer direction, at a y, in x.
Lerp lerp_on(const LineEnds& ends, bool is_x_major, const Rational& at);

/// A line as y = m x + b, or, where y is the longer direction, as x = m y + b.
struct SlopeForm {
    Rational m;
    Rational b;
};
std::optional<SlopeForm> slope_form_of(const LineEnds& ends, bool is_x_major);

/// The decisions of Bresenham's line, if the ends are pixels.
std::optional<BresenhamDecisions> decisions_between(const Trace& trace, const LineEnds& ends);

/// The d of the next decision of the same line or circle, if the trace tells it a few steps later. A mistake, or another
/// rasterizer, may add something else than the decision says.
std::optional<Rational> next_d_told(const StepContext& context);

/// Where a circle decides, seen from the pixel of its center.
struct CircleDecision {
    Rational x;
    Rational y;
    Rational increment; ///< what is added to d
};
std::optional<CircleDecision> circle_decision(const PrimitiveText& primitive,
                                              const DecideStep& step, const Trace& trace);

/// The pixel of a circle's center: the nearest one, a half up.
std::optional<Vec2> center_of(const PrimitiveText& primitive, const Trace& trace);

/// The name of the matrix that leads into a space; "" if none does.
std::string_view matrix_into(std::string_view space);

/// The x of the samples of lines in a column, or the y of those in a row.
Rational sample_of_lines(const Trace& trace, bool is_column, Index at);

/// True if bottom and left edges have the samples on them, not top and left ones.
bool has_bottom_rule(const Trace& trace);

/// Whose rule decided: `, by the rule of direct3d`; "" without a convention.
std::string by_convention(const Trace& trace);

/// The sample point of the pixel that a step is about.
std::optional<Vec2> sample_of(const Trace& trace, const StepView& step);

/// The weights of that sample in the step's triangle, if it has an area.
std::optional<Weights> weights_of_sample(const Trace& trace, const StepView& step,
                                         const PrimitiveText& primitive);

/// An end of a row.
struct EndOfRow {
    bool is_left;
    TracedText edge;
    Index y;
    TracedNumber x;
    TracedNumber depth;
    Index pixel;

    /// "left" or "right", in the language of steps.
    std::string name() const;
};

/// The left one, and the right one.
std::array<EndOfRow, 2> ends_of(const ScanlineStep& row);

/// How an end of a row becomes its pixel: ` -> floor`; or how it lies to the pixel's sample.
std::string rule_of_end(const Trace& trace, const EndOfRow& end,
                        const TracedWord<PrimitiveKind>& kind);

/// The `along` step before this one on the same line; 0 if there is none.
std::size_t along_before(const StepContext& context);

/// The row, line or sample that the pixel of the current step belongs to: the last step before it in its
/// primitive that is not about a pixel; 0 if there is none.
std::size_t reason_of_pixel(const StepContext& context);

} // namespace rastertrace
