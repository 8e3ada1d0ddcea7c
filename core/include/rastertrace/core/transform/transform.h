// SPDX-License-Identifier: MIT
#pragma once

// From object space to world space: scale, move, turn and shear, composed in the order in which the
// scene lists them.
//
//     model_matrix({Scale{{2, 2, 2}}, Translate{{0, 0, 4}}});  // scales first, then moves
//
// Matrices are made of exact numbers, once; what is irrational in them is the nearest double. Each
// Scalar then rounds each entry once.

#include <rastertrace/core/numbers/irrational.h>
#include <rastertrace/core/numbers/number.h>
#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/transform/matrix.h>

#include <algorithm>
#include <array>
#include <span>
#include <variant>

namespace rastertrace {

/// x, y and z as typed.
using Numbers3 = std::array<Number, 3>;

/// Multiplies x, y and z each by its own number.
struct Scale {
    Numbers3 by;
};

/// Adds to x, y and z.
struct Translate {
    Numbers3 by;
};

/// Turns about an axis through the origin; counter-clockwise as seen from the axis's tip.
struct Rotate {
    Numbers3 axis; ///< of any length but 0
    Number degrees;
};

/// Adds to each coordinate multiples of the others: x grows by xy y + xz z, and so on.
struct Shear {
    Number xy;
    Number xz;
    Number yx;
    Number yz;
    Number zx;
    Number zy;
};

/// One of the things that a model does.
using ModelStep = std::variant<Scale, Translate, Rotate, Shear>;

inline Vec<Rational, 3> exact(const Numbers3& numbers) {
    return {numbers[0].exact(), numbers[1].exact(), numbers[2].exact()};
}

/// A vector of length 1 in the direction of `vector`, which must not be 0: exactly if its length is
/// rational, else each component is the nearest double.
inline Vec<Rational, 3> unit_vector(const Vec<Rational, 3>& vector) {
    const Rational square = dot(vector, vector);
    const auto component = [&square](const Rational& length) {
        return Rational(sgn(length) * square_root(length * length / square));
    };
    return {component(vector.x), component(vector.y), component(vector.z)};
}

/// True if a unit vector in this direction has irrational components.
inline bool has_irrational_length(const Vec<Rational, 3>& vector) {
    return !has_rational_root(dot(vector, vector));
}

/// True if the matrix of this step is not exact. Half turns need no sine, and so no length of the
/// axis.
inline bool is_rounded(const ModelStep& step) {
    const auto* rotate = std::get_if<Rotate>(&step);
    if (rotate == nullptr)
        return false;
    const Rational degrees = rotate->degrees.exact();
    return !is_quarter_turn(degrees) ||
           (sine_of_degrees(degrees) != 0 && has_irrational_length(exact(rotate->axis)));
}

inline Matrix<Rational> matrix_of(const Scale& scale) {
    const auto by = exact(scale.by);
    return diagonal<Rational>(by.x, by.y, by.z, 1);
}

inline Matrix<Rational> matrix_of(const Translate& translate) {
    return translation<Rational>(exact(translate.by));
}

/// Rodrigues' formula: cos I + (1 - cos) a a^T + sin [a]x, for the unit axis a. The products of its
/// components are rational whatever its length.
inline Matrix<Rational> matrix_of(const Rotate& rotate) {
    const Rational degrees = rotate.degrees.exact();
    const Rational sine = sine_of_degrees(degrees);
    const Rational cosine = cosine_of_degrees(degrees);
    const Vec<Rational, 3> axis = exact(rotate.axis);
    const Vec<Rational, 3> unit = unit_vector(axis);
    const Rational square = dot(axis, axis);
    const std::array<Rational, 3> v{axis.x, axis.y, axis.z};
    const std::array<std::array<Rational, 3>, 3> cross{
        {{0, -unit.z, unit.y}, {unit.z, 0, -unit.x}, {-unit.y, unit.x, 0}}};
    Matrix<Rational> matrix = identity<Rational>();
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            matrix.rows[i][j] = Rational((i == j ? cosine : Rational(0)) +
                                         (1 - cosine) * v[i] * v[j] / square + sine * cross[i][j]);
    return matrix;
}

inline Matrix<Rational> matrix_of(const Shear& shear) {
    return {{{{1, shear.xy.exact(), shear.xz.exact(), 0},
              {shear.yx.exact(), 1, shear.yz.exact(), 0},
              {shear.zx.exact(), shear.zy.exact(), 1, 0},
              {0, 0, 0, 1}}}};
}

/// A matrix as whole numbers over one denominator. Products of many stay cheap: fractions would be
/// reduced in each of their sums.
struct WholeMatrix {
    std::array<std::array<mpz_class, 4>, 4> above;
    mpz_class below = 1;
};

inline WholeMatrix whole(const Matrix<Rational>& matrix) {
    WholeMatrix result;
    for (const auto& row : matrix.rows)
        for (const Rational& entry : row)
            result.below = lcm(result.below, entry.get_den());
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            result.above[i][j] =
                matrix.rows[i][j].get_num() * mpz_class(result.below / matrix.rows[i][j].get_den());
    return result;
}

inline WholeMatrix operator*(const WholeMatrix& a, const WholeMatrix& b) {
    WholeMatrix product;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            product.above[i][j] = a.above[i][0] * b.above[0][j] + a.above[i][1] * b.above[1][j] +
                                  a.above[i][2] * b.above[2][j] + a.above[i][3] * b.above[3][j];
    product.below = a.below * b.below;
    return product;
}

/// The steps of a model as one matrix: the first listed moves a point first, so it stands on the
/// right of the product.
inline Matrix<Rational> model_matrix(std::span<const ModelStep> steps) {
    WholeMatrix product = whole(identity<Rational>());
    for (const ModelStep& step : steps)
        product = whole(std::visit([](const auto& one) { return matrix_of(one); }, step)) * product;

    Matrix<Rational> matrix;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            matrix.rows[i][j] = trigonometry::quotient_of(product.above[i][j], product.below);
    return matrix;
}

/// The matrix with each entry rounded to a Scalar.
template <typename Scalar> Matrix<Scalar> rounded(const Matrix<Rational>& exact) {
    Matrix<Scalar> result;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            result.rows[i][j] = nearest_scalar<Scalar>(exact.rows[i][j]);
    return result;
}

} // namespace rastertrace
