// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/scene/model.h>

#include <rastertrace/core/numbers/irrational.h>
#include <rastertrace/core/transform/model.h>

#include <algorithm>
#include <utility>

namespace rastertrace {

namespace {

/// A matrix as whole numbers over one denominator. Products of many stay cheap: fractions would be
/// reduced in each of their sums.
struct WholeMatrix {
    std::array<std::array<mpz_class, 4>, 4> above;
    mpz_class below = 1;
};

WholeMatrix whole(const Matrix<Rational>& matrix) {
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

WholeMatrix operator*(const WholeMatrix& a, const WholeMatrix& b) {
    WholeMatrix product;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            product.above[i][j] = a.above[i][0] * b.above[0][j] + a.above[i][1] * b.above[1][j] +
                                  a.above[i][2] * b.above[2][j] + a.above[i][3] * b.above[3][j];
    product.below = a.below * b.below;
    return product;
}

} // namespace

Matrix<Rational> product_of(std::span<const MatrixFactor<Rational>> factors) {
    WholeMatrix product = whole(identity<Rational>());
    for (const MatrixFactor<Rational>& factor : factors)
        product = product * whole(factor.matrix);

    Matrix<Rational> matrix;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            matrix.rows[i][j] = quotient_of(product.above[i][j], product.below);
    return matrix;
}

Vec<Rational, 3> exact(const Numbers3& numbers) {
    return {numbers[0].exact(), numbers[1].exact(), numbers[2].exact()};
}

Rational over_root(const Rational& number, const Rational& square) {
    return sgn(number) * square_root(number * number / square);
}

Vec<Rational, 3> unit_vector(const Vec<Rational, 3>& vector) {
    const Rational square = dot(vector, vector);
    return {over_root(vector.x, square), over_root(vector.y, square), over_root(vector.z, square)};
}

bool has_irrational_length(const Vec<Rational, 3>& vector) {
    return !has_rational_root(dot(vector, vector));
}

bool is_rounded(const ModelStep& step) {
    const auto* rotate = std::get_if<Rotate>(&step);
    if (rotate == nullptr)
        return false;
    const Rational degrees = rotate->degrees.exact();
    return !is_quarter_turn(degrees) ||
           (sine_of_degrees(degrees) != 0 && has_irrational_length(exact(rotate->axis)));
}

namespace {

MatrixFactor<Rational> factor_of(const Scale& scale) {
    return {"scale", scaling<Rational>(exact(scale.by))};
}

MatrixFactor<Rational> factor_of(const Translate& translate) {
    return {"translate", translation<Rational>(exact(translate.by))};
}

MatrixFactor<Rational> factor_of(const Rotate& rotate) {
    const Rational degrees = rotate.degrees.exact();
    const Vec<Rational, 3> axis = exact(rotate.axis);
    return {"rotate", rotation<Rational>(axis, unit_vector(axis), sine_of_degrees(degrees),
                                         cosine_of_degrees(degrees))};
}

MatrixFactor<Rational> factor_of(const Shear& by) {
    return {"shear", shear<Rational>({by.xy.exact(), by.xz.exact(), by.yx.exact(), by.yz.exact(),
                                      by.zx.exact(), by.zy.exact()})};
}

MatrixFactor<Rational> factor_of(const ModelStep& step) {
    return std::visit([](const auto& one) { return factor_of(one); }, step);
}

} // namespace

std::vector<MatrixFactor<Rational>> factors_of(std::span<const ModelStep> steps) {
    std::vector<MatrixFactor<Rational>> factors;
    for (const ModelStep& step : steps)
        factors.push_back(factor_of(step));
    std::reverse(factors.begin(), factors.end());
    return factors;
}

} // namespace rastertrace
