// SPDX-License-Identifier: MIT
#pragma once

// The formulas of the textbook with their numbers: what they come to, and how a hand writes that down. A working
// writes them out; claims are judged by their values, from the claimed numbers, or with a mistake in them (slips.h).
//
//     const Lerp end{.d1 = 2, .i1 = 5, .d2 = -4, .i2 = -3, .i = 2};
//     end.value();        // -1/4
//     end.written_out(end.value());  // "(-4 - 2)/(-3 - 5) (2 - 5) + 2 = 3/4 (-3) + 2 = -1/4"

#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/irrational.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/mixed_colors.h>
#include <rastertrace/core/raster/rounding.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace rastertrace {

/// Twice the area of a triangle, AB x AC: above 0 if it is counter-clockwise where y points up. In exact numbers or in
/// doubles.
template <typename Point> auto doubled_area(const Point& a, const Point& b, const Point& c) {
    using Result = std::remove_cvref_t<decltype(a.x)>;
    return Result((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

/// What a formula comes to: a number, the components of a vector, or 1 and 0 for a decision.
using Values = std::vector<Rational>;

/// The slope of an edge, dx/dy = (x2 - x1) / (y2 - y1).
struct Slope {
    Vec<Rational, 2> from;
    Vec<Rational, 2> to;
    std::optional<Vec<Rational, 2>> other = {}; ///< the triangle's third corner
};

/// d1 + (d2 - d1) / (i2 - i1) (i - i1): the x where an edge meets a row, or the depth there; d1 if i2 = i1.
struct Lerp {
    Rational d1, i1;
    Rational d2, i2;
    Rational i;
    std::optional<Rational> step = {};                 ///< in the place of the quotient
    std::optional<std::array<Rational, 2>> other = {}; ///< d and i of the third corner
    bool is_inverse_z = false;                         ///< d is 1/z

    /// The quotient; nothing of a horizontal edge.
    std::optional<Rational> slope() const;

    /// What it comes to.
    Rational value() const;

    /// The numbers put in; i2 != i1. `result` is its value, or what a trace tells, which may be rounded.
    std::string written_out(const Rational& result) const;
};

/// A coordinate that becomes a pixel.
struct RoundedEnd {
    Rational x;
    SpanRounding rule;
    bool is_last = false; ///< of a row, where the rule tells both ends apart
    Rational per_row = 0; ///< how far x goes for one row

    /// The pixel by another rule.
    Rational by(const SpanRounding& other) const;
};

/// A number that is copied: a vertex as it was typed, or in a space where it stands as in the one before.
struct TakenOver {
    Values values;
};

/// A vertex that becomes a pixel's corner: each of its coordinates is rounded.
struct RoundedPlace {
    Values at;
    SpanRounding rule;

    /// The place by another rule.
    Values by(const SpanRounding& other) const;
};

/// True if a row has the pixel x.
struct InRow {
    RoundedEnd from;
    RoundedEnd to;
    Rational x;
};

/// (B - A) x (C - A); of more corners, the sum of these over the triangles of the fan from the first.
struct FaceNormal {
    std::vector<Vec<Rational, 3>> corners;

    Vec<Rational, 3> value() const;

    /// (-5 (0) - 0 (-3), ...), a term for each triangle
    std::string written_out() const;
};

/// (A + B + C) / 3: the mean of the corners.
struct Centroid {
    std::vector<Vec<Rational, 3>> corners;

    Vec<Rational, 3> value() const;
};

/// A, B, C and D of the plane A x + B y + C z + D = 0 that a face lies in.
struct FacePlane {
    Vec<Rational, 3> normal;
    Vec<Rational, 3> corner;

    Rational constant() const; ///< D

    /// 0 x + 0 y - 4 z + 8 = 0
    std::string written_out() const;
};

/// From the centroid of a face to the eye, or to the light.
struct Toward {
    Vec<Rational, 3> to;
    Vec<Rational, 3> centroid;
    std::vector<Vec<Rational, 3>> corners;
    Vec<Rational, 3> normal;
};

/// normal . view
struct FaceDot {
    Vec<Rational, 3> normal;
    Vec<Rational, 3> view;

    Rational value() const;

    /// 0 (-1) + 0 (-1) + -4 (3) = -12
    std::string written_out() const;
};

/// normal . view / (|normal| |view|); an intensity is not below 0.
struct FaceCosine {
    Vec<Rational, 3> normal;
    Vec<Rational, 3> view;
    std::optional<Rational> dot = {}; ///< in the place of their product
    bool is_intensity = false;

    /// Nothing where a length is 0, or what no double holds.
    std::optional<Rational> value(RootDigits digits = RootDigits::of_double) const;

    /// -12 / (|normal| |view|) = -0.948683
    std::string written_out(std::string_view name_of_view) const;
};

/// True if a face is culled by this product.
struct IsCulled {
    Rational dot;
    bool hides_back = true; ///< what is turned away, or what is turned to the eye
};

/// A matrix times a point: one row for each component.
struct MatrixTimes {
    using Row = std::array<Rational, 4>;

    /// One of those that the matrix is the product of.
    struct Factor {
        std::string name; ///< rotate, translate, scale, ...
        std::array<Row, 4> rows;
    };

    std::vector<Row> rows;
    Row point;
    std::vector<Factor> factors =
        {}; ///< the last one moves a point first; empty if they are not told
    bool is_viewport = false;

    Rational value(std::size_t row) const;

    /// A component: 1 (2) + 0 (5) + 0 (3) + 0 (1)
    std::string written_out(std::size_t row) const;
};

/// (x, y, z) / w
struct DividedByW {
    std::array<Rational, 4> point;

    /// Nothing if w = 0.
    std::optional<Rational> value(std::size_t component) const;
};

/// d before each step of Bresenham's line of `steps` steps: 2 minor - major first.
struct BresenhamDecisions {
    Rational major;
    Rational minor;
    std::size_t steps = 0;
    bool steps_at_ties = false; ///< d = 0 goes diagonally
    int factor_at_start = 2;    ///< of minor, where d begins
    int factor_in_steps = 2;    ///< of what each step adds
    std::optional<Rational> other_start =
        {}; ///< in the place of what they come to, with a mistake in them
    std::optional<Rational> other_straight = {};
    std::optional<Rational> other_diagonal = {};

    Rational start() const;
    Rational straight() const; ///< what a step along the major axis adds
    Rational diagonal() const; ///< what a step along both axes adds

    /// True if a d steps along both axes.
    bool is_diagonal(const Rational& d) const;

    /// What follows a d.
    Rational next(const Rational& d) const;

    /// -3 + 8 = 5: a d and the next.
    std::string written_out(const Rational& d) const;
};

/// The pixels of Bresenham's line: x and y of each in turn.
struct LinePixels {
    BresenhamDecisions decisions;
    Vec<Rational, 2> from;
    Vec<Rational, 2> straight; ///< the step along the longer direction
    Vec<Rational, 2> diagonal; ///< the step along both
};

/// A line as y = m x + b: m and b. Of y: as x = m y + b.
struct LineForm {
    Vec<Rational, 2> from;
    Vec<Rational, 2> to;
    bool is_of_y = false;
};

/// How many pixels or rows there are from the first to the last.
struct InclusiveCount {
    Rational first;
    Rational last;
    bool is_of_rows = false; ///< of a primitive
};

/// Red, green and blue of colors, each by its weight, which become whole levels.
struct MixedColor {
    std::vector<Levels<Rational>> corners;
    std::vector<Rational> weights;
    bool is_cut = false; ///< to the level below; otherwise rounded
    std::vector<Rational> other_weights =
        {}; ///< by distance in the place of steps, or the other way round; on the screen for in space
};

/// A depth between others, by their weights: those of a triangle's corners, or of the ends of a row.
struct MixedDepth {
    std::vector<Rational> weights;
    std::vector<Rational> depths;
    bool gives_inverse = false; ///< 1 over the depth is asked for

    /// In a triangle's row: the weights of its corners, and their depths.
    std::vector<Rational> corner_weights = {};
    std::vector<Rational> corner_depths = {};

    /// The sum of the products.
    Rational depth() const;

    /// 1/2 (1) + 1/4 (2) + 1/4 (4) = 2
    std::string written_out(const Rational& result) const;
};

/// True if a depth passes against the one that is stored.
struct DepthComparison {
    Rational depth;
    Rational stored;
    bool larger_passes = false;
};

/// The weights of a sample in a triangle: 1 - u - v, u, v, by the cross product (ABx, ACx, PAx) x (ABy, ACy, PAy) (T3).
struct Weights {
    std::array<Vec<Rational, 2>, 3> corners;
    Vec<Rational, 2> sample;

    Vec<Rational, 3> xs() const; ///< ABx, ACx, PAx
    Vec<Rational, 3> ys() const; ///< ABy, ACy, PAy

    /// Twice the areas of B, of C, and of all three together.
    Vec<Rational, 3> areas() const;

    /// Of A, B and C; nothing of a triangle without area.
    std::optional<std::array<Rational, 3>> value() const;

    /// (5, 2, -1) x (0, 4, -1) = (2, 5, 20)
    std::string written_out() const;
};

/// True if a sample lies in its triangle.
struct InTriangle {
    Weights weights;
    bool has_its_edge =
        false; ///< a sample on the edge that this one lies on belongs to the triangle
};

struct Formula {
    std::variant<TakenOver, Slope, Lerp, RoundedEnd, RoundedPlace, InRow, FaceNormal, Centroid,
                 FacePlane, Toward, FaceDot, FaceCosine, IsCulled, MatrixTimes, DividedByW,
                 BresenhamDecisions, LinePixels, LineForm, InclusiveCount, MixedColor, MixedDepth,
                 DepthComparison, Weights, InTriangle>
        of;
};

/// (y1 z2 - z1 y2, z1 x2 - x1 z2, x1 y2 - y1 x2), with the numbers put in.
std::string cross_written_out(const Vec<Rational, 3>& a, const Vec<Rational, 3>& b);

/// What a formula is, for who has to find it: in words of the language of steps, and in letters.
struct FormulaRule {
    std::string_view rule;
    std::string_view formula;
};
FormulaRule rule_of(const Formula& formula);

/// What it comes to; nothing where it divides by 0, or of a list that is too long for a hand.
Values value_of(const Formula& formula);

} // namespace rastertrace
