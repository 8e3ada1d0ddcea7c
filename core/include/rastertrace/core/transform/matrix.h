// SPDX-License-Identifier: MIT
#pragma once

// Matrices of four rows and four columns, in maths order: a point is a column on the right, so
// P V M v moves v by M first, then by V, then by P.
//
//     const auto rows = translation<double>({0, 0, 4});
//     rows * Vec<double, 4>{1, 1, 1, 1};  // (1, 1, 5, 1)

#include <rastertrace/core/numbers/vec.h>

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace rastertrace {

/// Row by row, as a textbook prints it.
template <typename Scalar> struct Matrix {
    std::array<std::array<Scalar, 4>, 4> rows{};

    /// Each component is the row's products, added from left to right.
    friend Vec<Scalar, 4> operator*(const Matrix& m, const Vec<Scalar, 4>& v) {
        const auto component = [&m, &v](std::size_t i) {
            const auto& row = m.rows[i];
            return Scalar(row[0] * v.x + row[1] * v.y + row[2] * v.z + row[3] * v.w);
        };
        return {component(0), component(1), component(2), component(3)};
    }

    friend Matrix operator*(const Matrix& a, const Matrix& b) {
        Matrix product;
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j)
                product.rows[i][j] = a.rows[i][0] * b.rows[0][j] + a.rows[i][1] * b.rows[1][j] +
                                     a.rows[i][2] * b.rows[2][j] + a.rows[i][3] * b.rows[3][j];
        return product;
    }

    friend bool operator==(const Matrix&, const Matrix&) = default;
};

/// A matrix with these numbers on its diagonal and 0 elsewhere.
template <typename Scalar>
Matrix<Scalar> diagonal(const Scalar& x, const Scalar& y, const Scalar& z, const Scalar& w) {
    return {{{{x, 0, 0, 0}, //
              {0, y, 0, 0},
              {0, 0, z, 0},
              {0, 0, 0, w}}}};
}

template <typename Scalar> Matrix<Scalar> identity() {
    return diagonal<Scalar>(1, 1, 1, 1);
}

/// Moves a point by `by`.
template <typename Scalar> Matrix<Scalar> translation(const Vec<Scalar, 3>& by) {
    Matrix<Scalar> matrix = identity<Scalar>();
    matrix.rows[0][3] = by.x;
    matrix.rows[1][3] = by.y;
    matrix.rows[2][3] = by.z;
    return matrix;
}

/// The matrix whose entries are `entry_of` those of another one.
template <typename Scalar, typename From, typename EntryOf>
Matrix<Scalar> mapped(const Matrix<From>& from, EntryOf&& entry_of) {
    Matrix<Scalar> matrix;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            matrix.rows[i][j] = entry_of(from.rows[i][j]);
    return matrix;
}

/// A factor of the matrix that leads from one space to the next.
template <typename Scalar> struct MatrixFactor {
    std::string_view name; ///< scale, translate, rotate, shear, perspective, flip
    Matrix<Scalar> matrix;
};

/// Factors whose product, in this order, is such a matrix: the last one moves a point first.
template <typename Scalar> using MatrixFactors = std::vector<MatrixFactor<Scalar>>;

} // namespace rastertrace
