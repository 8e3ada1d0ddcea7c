// SPDX-License-Identifier: MIT
#pragma once

// The model of an object, as a scene lists it: scale, move, turn and shear, composed in that order.
//
//     Model({Scale{{2, 2, 2}}, Translate{{0, 0, 4}}}).matrix();  // scales first, then moves
//
// Matrices are made of exact numbers, once; what is irrational in them is the nearest double. Each
// Scalar then rounds each entry once.

#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/number.h>
#include <rastertrace/core/numbers/rational.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/transform/matrix.h>

#include <array>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace rastertrace {

/// x, y and z as typed.
using Numbers3 = std::array<Number, 3>;

/// Multiplies x, y and z each by its own number.
struct Scale {
    Numbers3 by;

    friend bool operator==(const Scale&, const Scale&) = default;
};

/// Adds to x, y and z.
struct Translate {
    Numbers3 by;

    friend bool operator==(const Translate&, const Translate&) = default;
};

/// Turns about an axis through the origin; counter-clockwise as seen from the axis's tip.
struct Rotate {
    Numbers3 axis; ///< of any length but 0
    Number degrees;

    friend bool operator==(const Rotate&, const Rotate&) = default;
};

/// Adds to each coordinate multiples of the others: x grows by xy y + xz z, and so on.
struct Shear {
    Number xy;
    Number xz;
    Number yx;
    Number yz;
    Number zx;
    Number zy;

    friend bool operator==(const Shear&, const Shear&) = default;
};

/// One of the things that a model does.
using ModelStep = std::variant<Scale, Translate, Rotate, Shear>;

Vec<Rational, 3> exact(const Numbers3& numbers);

/// A number divided by the square root of another one: exactly if that is rational, else the nearest double.
Rational over_root(const Rational& number, const Rational& square);

/// A vector of length 1 in the direction of `vector`, which must not be 0: exactly if its length is
/// rational, else each component is the nearest double.
Vec<Rational, 3> unit_vector(const Vec<Rational, 3>& vector);

/// True if a unit vector in this direction has irrational components.
bool has_irrational_length(const Vec<Rational, 3>& vector);

/// True if the matrix of this step is not exact. Half turns need no sine, and so no length of the
/// axis.
bool is_rounded(const ModelStep& step);

/// The product of the factors in this order, so that the last one moves a point first. Of none, the
/// identity.
Matrix<Rational> product_of(std::span<const MatrixFactor<Rational>> factors);

/// The steps of a model: the first listed moves a point first, so it is the last factor.
std::vector<MatrixFactor<Rational>> factors_of(std::span<const ModelStep> steps);

/// The steps of a model, and their matrix: the product of the factors. It is worked out once; copies have it too.
class Model {
public:
    Model() : Model(std::vector<ModelStep>()) {}
    Model(std::initializer_list<ModelStep> steps) : Model(std::vector<ModelStep>(steps)) {}
    Model(std::vector<ModelStep> steps) // NOLINT: steps are a model
        : steps_(std::move(steps)), matrix_(product_of(factors_of(steps_))) {}

    const std::vector<ModelStep>& steps() const { return steps_; }
    const Matrix<Rational>& matrix() const { return matrix_; }

private:
    std::vector<ModelStep> steps_;
    Matrix<Rational> matrix_;
};

/// The matrix with each entry rounded to a Scalar.
template <typename Scalar> Matrix<Scalar> rounded(const Matrix<Rational>& exact) {
    Matrix<Scalar> result;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            result.rows[i][j] = nearest_scalar<Scalar>(exact.rows[i][j]);
    return result;
}

} // namespace rastertrace
